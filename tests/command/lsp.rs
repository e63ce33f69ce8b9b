//! `virote lsp` over its streams: what is no message, and how it ends.

use std::{
    io::{BufRead, BufReader, Read, Write},
    process::{Child, ChildStdout, Stdio},
};

use serde_json::{Value as Json, json};

use crate::support::{Scratch, virote};

struct Server {
    child: Child,
    output: BufReader<ChildStdout>,
}

impl Server {
    fn start(folder: &Scratch) -> Self {
        let mut command = virote(&folder.0);
        command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("it starts");
        let output = BufReader::new(child.stdout.take().expect("it speaks"));
        Self { child, output }
    }

    fn send(&mut self, body: &[u8]) {
        let input = self.child.stdin.as_mut().expect("it listens");
        write!(input, "Content-Length: {}\r\n\r\n", body.len()).expect("it listens");
        input.write_all(body).expect("it listens");
        input.flush().expect("it listens");
    }

    fn tell(&mut self, method: &str, id: Option<i32>, params: Json) {
        let mut message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        if let Some(id) = id {
            message["id"] = json!(id);
        }
        self.send(message.to_string().as_bytes());
    }

    /// The next message with this key and value.
    fn hear(&mut self, key: &str, value: &Json) -> Json {
        loop {
            let (mut line, mut length) = (String::new(), 0);
            while self.output.read_line(&mut line).expect("it speaks") > 2 {
                if let Some(number) = line.strip_prefix("Content-Length: ") {
                    length = number.trim().parse().expect("a length");
                }
                line.clear();
            }
            assert!(0 < length, "it went away");
            let mut body = vec![0; length];
            self.output.read_exact(&mut body).expect("a whole message");
            let message: Json = serde_json::from_slice(&body).expect("JSON");
            if message[key] == *value {
                return message;
            }
        }
    }
}

#[test]
fn what_is_no_message_is_passed_over() {
    let folder = Scratch::new("lsp-streams");
    let mut server = Server::start(&folder);
    server.tell("initialize", Some(1), json!({ "capabilities": {} }));
    assert_eq!(server.hear("id", &json!(1))["result"]["serverInfo"]["name"], "virote");
    server.tell("initialized", None, json!({}));
    server.send(b"no JSON at all");
    server.send(b"{\"jsonrpc\": \"2.0\", \"method\": 7}");
    server.send(b"");
    let open = r#"{"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument":
        {"uri": "file:///nowhere/a.geo", "languageId": "virote", "version": 1, "text": "// \ud83e half\nprint \"x\" + y"}}}"#;
    server.send(open.as_bytes());
    let told = server.hear("method", &json!("textDocument/publishDiagnostics"));
    assert_eq!(told["params"]["diagnostics"][0]["code"], "E0201");
    // Bytes that are no UTF-8.
    let mut bytes = open.replace("a.geo", "b.geo").replace("half", "~").into_bytes();
    let at = bytes.iter().position(|byte| *byte == b'~').expect("it is there");
    bytes[at] = 0xff;
    server.send(&bytes);
    let told = server.hear("method", &json!("textDocument/publishDiagnostics"));
    assert_eq!(told["params"]["uri"], "file:///nowhere/b.geo");
    server.tell("shutdown", Some(2), Json::Null);
    server.hear("id", &json!(2));
    server.tell("exit", None, Json::Null);
    assert_eq!(server.child.wait().expect("it ends").code(), Some(0));
}

#[test]
fn a_client_that_goes_without_a_word_ends_it() {
    let folder = Scratch::new("lsp-gone");
    let mut server = Server::start(&folder);
    server.tell("initialize", Some(1), json!({ "capabilities": {} }));
    server.hear("id", &json!(1));
    drop(server.child.stdin.take());
    assert_eq!(server.child.wait().expect("it ends").code(), Some(0));
}

#[test]
fn a_lens_shows_its_definition_in_one_viewer() {
    let folder = Scratch::new("lsp-view");
    let script = folder.0.join("model.geo");
    let text = "curve größe = line((0, 0), (1, 0))\ncurve b = line((0, 0), (0, 1))\n";
    std::fs::write(&script, text).expect("it is written");
    let uri = format!("file://{}", script.display());
    let mut server = Server::start(&folder);
    server.tell("initialize", Some(1), json!({ "capabilities": {} }));
    server.hear("id", &json!(1));
    server.tell("initialized", None, json!({}));
    let document = json!({ "uri": uri, "languageId": "virote", "version": 1, "text": text });
    server.tell("textDocument/didOpen", None, json!({ "textDocument": document }));
    server.tell("textDocument/codeLens", Some(2), json!({ "textDocument": { "uri": uri } }));
    let lenses = server.hear("id", &json!(2));
    let mut addresses = Vec::new();
    for (id, lens) in (3..).zip(lenses["result"].as_array().expect("lenses")) {
        assert_eq!(lens["command"]["title"], "open in view");
        server.tell("workspace/executeCommand", Some(id), lens["command"].clone());
        let told = server.hear("id", &json!(id));
        addresses.push(told["result"]["address"].as_str().expect("an address").to_owned());
    }
    let parts: Vec<_> =
        addresses.iter().map(|address| address.split_once('#').expect("a definition")).collect();
    assert_eq!([parts[0].1, parts[1].1], ["definition=gr%C3%B6%C3%9Fe", "definition=b"]);
    assert_eq!(parts[0].0, parts[1].0, "one viewer shows both");
    server.tell("shutdown", Some(9), Json::Null);
    server.hear("id", &json!(9));
    server.tell("exit", None, Json::Null);
    assert_eq!(server.child.wait().expect("it ends").code(), Some(0));
}
