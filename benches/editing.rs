//! How fast the language server answers while somebody types in a document of a thousand definitions, or ten thousand,
//! and how much memory it holds after ten thousand edits of the largest example.
//!
//! The server is the command `virote lsp`, asked over its streams as by an editor. `VIROTE` names
//! another build of it.

#![expect(clippy::unwrap_used, reason = "a server that goes away ends the benchmark")]
#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::{
    io::BufReader,
    path::Path,
    process::{Child, Command, Stdio},
    thread,
};

use crossbeam_channel::unbounded;
use divan::Bencher;
use lsp_server::{Connection, Message, Notification, Request};
use serde_json::{Value as Json, json};

const URI: &str = "file:///nowhere/main.geo";
/// Definitions of the document.
const N_DEFINITIONS: usize = 1000;
/// The number in line 500, which is typed anew.
const NUMBER: [u32; 2] = [500, 12];
/// The example whose values take most memory.
const LARGEST_EXAMPLE: &str = "pipe-along-a-curve.geo";
/// Characters that are typed or deleted there.
const N_EDITS: usize = 10_000;

fn main() {
    divan::main();
    // A filter wants some benchmarks and not all.
    if std::env::args().skip(1).all(|argument| argument.starts_with('-')) {
        print_memory();
    }
}

/// So many definitions: parameters, numbers, points, curves, functions, each of what came before.
fn script(n: usize) -> String {
    let definition = |i: usize| match i % 5 {
        _ if i == 500 => "let d500 =  5 + 1\n".to_owned(),
        0 => format!("param d{i} = {i} in 0..20000\n"),
        1 => format!("let d{i} = d{} * 2 + sqrt({i})\n", i - 1),
        2 => format!("let d{i} = (d{}, {i}, 0)\n", i - 1),
        3 => format!("curve d{i} = line(d{}, (0, 0, {i}))\n", i - 1),
        _ => format!("fn d{i}(x, by = 2) = x * by + {i}\n"),
    };
    (0..n).map(definition).collect()
}

/// An editor with one document, and the server that it started.
struct Client {
    server: Child,
    connection: Connection,
    uri: String,
    version: i32,
    next_id: i32,
}

impl Drop for Client {
    fn drop(&mut self) {
        // One that is gone already is no loss.
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Starts the server: the process, and messages to it and from it.
fn start() -> (Child, Connection) {
    let program = std::env::var_os("VIROTE");
    let mut server = Command::new(program.unwrap_or_else(|| env!("CARGO_BIN_EXE_virote").into()))
        .arg("lsp")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut input, output) = (server.stdin.take().unwrap(), server.stdout.take().unwrap());
    let (sender, outgoing) = unbounded::<Message>();
    let (incoming, receiver) = unbounded();
    thread::spawn(move || outgoing.into_iter().try_for_each(|message| message.write(&mut input)));
    thread::spawn(move || {
        let mut output = BufReader::new(output);
        while let Ok(Some(message)) = Message::read(&mut output) {
            if incoming.send(message).is_err() {
                return;
            }
        }
    });
    (server, Connection { sender, receiver })
}

impl Client {
    /// Starts a server, opens a document, and waits for its findings.
    fn new(uri: &str, text: &str) -> Self {
        let (server, connection) = start();
        let mut client = Self { server, connection, uri: uri.to_owned(), version: 1, next_id: 0 };
        client.ask("initialize", json!({ "capabilities": {} }));
        client.tell("initialized", json!({}));
        let document = json!({ "uri": uri, "languageId": "virote", "version": 1, "text": text });
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

    /// Puts a text in the place of so many characters behind a place.
    fn replace(&mut self, [line, column]: [u32; 2], n_replaced: u32, text: &str) {
        self.version += 1;
        let range = json!({
            "start": { "line": line, "character": column },
            "end": { "line": line, "character": column + n_replaced },
        });
        let document = json!({ "uri": self.uri, "version": self.version });
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": document, "contentChanges": [{ "range": range, "text": text }] }),
        );
    }

    /// Types a digit over the one before.
    fn type_digit(&mut self) {
        let digit = (self.version % 10).to_string();
        self.replace(NUMBER, 1, &digit);
    }

    fn ask_at(&mut self, method: &str, [line, character]: [u32; 2]) -> Json {
        let position = json!({ "line": line, "character": character });
        self.ask(method, json!({ "textDocument": { "uri": self.uri }, "position": position }))
    }
}

#[divan::bench]
fn from_start_to_first_findings(bencher: Bencher<'_, '_>) {
    let text = script(N_DEFINITIONS);
    bencher.bench_local(|| Client::new(URI, &text));
}

#[divan::bench(args = [N_DEFINITIONS, 10 * N_DEFINITIONS])]
fn from_keystroke_to_findings(bencher: Bencher<'_, '_>, n_definitions: usize) {
    let mut client = Client::new(URI, &script(n_definitions));
    bencher.bench_local(|| {
        client.type_digit();
        client.wait_for_findings();
    });
}

/// Each with the names of a new text.
#[divan::bench(args = ["hover", "completion", "definition", "signatureHelp", "semanticTokens/full"])]
fn from_keystroke_to_answer(bencher: Bencher<'_, '_>, what: &str) {
    let mut client = Client::new(URI, &script(N_DEFINITIONS));
    let method = format!("textDocument/{what}");
    bencher.bench_local(|| {
        client.type_digit();
        client.ask_at(&method, [501, 12])
    });
}

/// Each with the names of a text that is known.
#[divan::bench(args = ["hover", "completion", "definition", "signatureHelp", "semanticTokens/full"])]
fn to_answer(bencher: Bencher<'_, '_>, what: &str) {
    let mut client = Client::new(URI, &script(N_DEFINITIONS));
    let method = format!("textDocument/{what}");
    bencher.bench_local(|| client.ask_at(&method, [501, 12]));
}

/// Types factors behind the numbers of the largest example and deletes them again, in bursts of ten
/// characters with a pause for the findings behind each, and prints what the server holds.
fn print_memory() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(LARGEST_EXAMPLE);
    let text = std::fs::read_to_string(&path).unwrap();
    let places = ends_of_numbers(&text);
    let mut client = Client::new(&format!("file://{}", path.display()), &text);
    let first = memory_megabytes(&client.server);
    let mut n_edits = 0;
    for (round, &[line, column]) in places.iter().cycle().enumerate() {
        let factor = format!(" * 1.{round:05}");
        for (i, sign) in (0..).zip(factor.chars()) {
            client.replace([line, column + i], 0, &sign.to_string());
        }
        client.wait_for_findings();
        for i in (0..factor.len() as u32).rev() {
            client.replace([line, column + i], 1, "");
        }
        client.wait_for_findings();
        n_edits += 2 * factor.len();
        if N_EDITS <= n_edits {
            break;
        }
    }
    let after = memory_megabytes(&client.server);
    match (first, after) {
        (Some([first, _]), Some([after, most])) => println!(
            "{LARGEST_EXAMPLE}: the server holds {first:.0} MB after the first findings, {after:.0} MB after \
             {n_edits} edits, and {most:.0} MB at most"
        ),
        _ => println!("this system does not tell how much memory a process holds"),
    }
}

/// Lines and columns behind the numbers with their units, in the lines that are no comments.
fn ends_of_numbers(text: &str) -> Vec<[u32; 2]> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let mut ends = Vec::new();
    for (line, words) in (0..).zip(text.lines()) {
        let words = words.split("//").next().unwrap_or_default();
        let mut column = 0;
        for word in words.split_inclusive(|c| !is_part(c)) {
            let number = word.trim_end_matches(|c| !is_part(c));
            if number.starts_with(|c: char| c.is_ascii_digit()) && !number.contains("..") {
                ends.push([line, column + number.len() as u32]);
            }
            column += word.encode_utf16().count() as u32;
        }
    }
    ends
}

/// What a process holds now, and what it held at most.
fn memory_megabytes(process: &Child) -> Option<[f64; 2]> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", process.id())).ok()?;
    let of = |name: &str| -> Option<f64> {
        let line = status.lines().find(|line| line.starts_with(name))?;
        line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
    };
    Some([of("VmRSS:")?, of("VmHWM:")?])
}
