//! How fast the language server answers while somebody types in a document of a thousand definitions.

#![expect(clippy::unwrap_used, reason = "a server that goes away ends the benchmark")]

use std::thread;

use divan::Bencher;
use lsp_server::{Connection, Message, Notification, Request};
use serde_json::{Value as Json, json};
use virote::{lsp, session::Session};

const URI: &str = "file:///nowhere/main.geo";
/// The number in line 500, which is typed anew.
const NUMBER: [u32; 2] = [500, 12];

fn main() {
    divan::main();
}

/// A thousand definitions: parameters, numbers, points, curves, functions, each of what came before.
fn script() -> String {
    let definition = |i: usize| match i % 5 {
        _ if i == 500 => "let d500 =  5 + 1\n".to_owned(),
        0 => format!("param d{i} = {i} in 0..2000\n"),
        1 => format!("let d{i} = d{} * 2 + sqrt({i})\n", i - 1),
        2 => format!("let d{i} = (d{}, {i}, 0)\n", i - 1),
        3 => format!("curve d{i} = line(d{}, (0, 0, {i}))\n", i - 1),
        _ => format!("fn d{i}(x, by = 2) = x * by + {i}\n"),
    };
    (0..1000).map(definition).collect()
}

/// A client in the same process.
struct Client {
    connection: Connection,
    version: i32,
    next_id: i32,
}

impl Client {
    fn new(text: &str) -> Self {
        let (server, connection) = Connection::memory();
        thread::spawn(move || {
            let session = |stop| Session::default().stopped_by(stop);
            lsp::serve(server, &session)
        });
        let mut client = Self { connection, version: 1, next_id: 0 };
        client.ask("initialize", json!({ "capabilities": {} }));
        client.tell("initialized", json!({}));
        let document = json!({ "uri": URI, "languageId": "virote", "version": 1, "text": text });
        client.tell("textDocument/didOpen", json!({ "textDocument": document }));
        client.wait_for_findings();
        client
    }

    fn tell(&self, method: &str, params: Json) {
        let told = Notification::new(method.to_owned(), params);
        self.connection.sender.send(told.into()).unwrap();
    }

    fn ask(&mut self, method: &str, params: Json) -> Json {
        self.next_id += 1;
        let request = Request::new(self.next_id.into(), method.to_owned(), params);
        self.connection.sender.send(request.into()).unwrap();
        loop {
            if let Message::Response(response) = self.connection.receiver.recv().unwrap() {
                return response.response_result.unwrap();
            }
        }
    }

    fn wait_for_findings(&self) {
        loop {
            match self.connection.receiver.recv().unwrap() {
                Message::Notification(told) if told.params["version"] == self.version => return,
                _ => {}
            }
        }
    }

    /// Types a digit over the one before.
    fn type_digit(&mut self) {
        self.version += 1;
        let [line, column] = NUMBER;
        let range = json!({
            "start": { "line": line, "character": column },
            "end": { "line": line, "character": column + 1 },
        });
        let change = json!({ "range": range, "text": (self.version % 10).to_string() });
        let document = json!({ "uri": URI, "version": self.version });
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": document, "contentChanges": [change] }),
        );
    }

    fn ask_at(&mut self, method: &str, [line, character]: [u32; 2]) -> Json {
        let position = json!({ "line": line, "character": character });
        self.ask(method, json!({ "textDocument": { "uri": URI }, "position": position }))
    }
}

#[divan::bench]
fn from_start_to_first_findings(bencher: Bencher<'_, '_>) {
    let text = script();
    bencher.bench_local(|| Client::new(&text));
}

#[divan::bench]
fn from_keystroke_to_findings(bencher: Bencher<'_, '_>) {
    let mut client = Client::new(&script());
    bencher.bench_local(|| {
        client.type_digit();
        client.wait_for_findings();
    });
}

/// Each with the names of a new text.
#[divan::bench(args = ["hover", "completion", "definition", "signatureHelp", "semanticTokens/full"])]
fn from_keystroke_to_answer(bencher: Bencher<'_, '_>, what: &str) {
    let mut client = Client::new(&script());
    let method = format!("textDocument/{what}");
    bencher.bench_local(|| {
        client.type_digit();
        client.ask_at(&method, [501, 12])
    });
}

/// Each with the names of a text that is known.
#[divan::bench(args = ["hover", "completion", "definition", "signatureHelp", "semanticTokens/full"])]
fn to_answer(bencher: Bencher<'_, '_>, what: &str) {
    let mut client = Client::new(&script());
    let method = format!("textDocument/{what}");
    bencher.bench_local(|| client.ask_at(&method, [501, 12]));
}
