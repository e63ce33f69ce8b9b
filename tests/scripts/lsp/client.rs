//! A client in the same process: it opens marked scripts, edits them, asks, and waits for answers.

use std::{
    collections::VecDeque,
    thread::{self, JoinHandle},
    time::Duration,
};

use lsp_server::{Connection, Message, Notification, Request, ResponseError};
use serde_json::{Value as Json, json};
use virote::{lsp, session::Session};

/// Longer than anything takes: who waits for so long waits in vain.
const PATIENCE: Duration = Duration::from_secs(120);

pub(super) struct Client {
    connection: Option<Connection>,
    server: Option<JoinHandle<()>>,
    next_id: i32,
    /// Notifications and requests of the server that nobody looked at yet.
    told: VecDeque<(String, Json)>,
    pub(super) capabilities: Json,
}

impl Client {
    pub(super) fn new() -> Self {
        Self::with(
            json!({ "textDocument": { "completion": { "completionItem": { "snippetSupport": true } } } }),
            Json::Null,
        )
    }

    /// A client that can do this, in a workspace of this folder.
    pub(super) fn with(capabilities: Json, root: Json) -> Self {
        let (server_side, connection) = Connection::memory();
        let server = thread::spawn(move || {
            let session = |stop| Session::default().stopped_by(stop);
            lsp::serve(server_side, &session).expect("the protocol is kept");
        });
        let mut client = Self {
            connection: Some(connection),
            server: Some(server),
            next_id: 0,
            told: VecDeque::new(),
            capabilities: Json::Null,
        };
        let result = client.ask(
            "initialize",
            json!({ "capabilities": capabilities, "rootUri": root, "processId": null }),
        );
        client.capabilities = result["capabilities"].clone();
        client.tell("initialized", json!({}));
        client
    }

    pub(super) fn send(&self, message: impl Into<Message>) {
        self.connection
            .as_ref()
            .expect("it is open")
            .sender
            .send(message.into())
            .expect("the server is there");
    }

    pub(super) fn tell(&self, method: &str, params: Json) {
        self.send(Notification::new(method.to_owned(), params));
    }

    fn next(&mut self) -> Message {
        let connection = self.connection.as_ref().expect("it is open");
        connection.receiver.recv_timeout(PATIENCE).expect("the server answers")
    }

    /// Sends a request; its number.
    pub(super) fn begin(&mut self, method: &str, params: Json) -> i32 {
        self.next_id += 1;
        self.send(Request::new(self.next_id.into(), method.to_owned(), params));
        self.next_id
    }

    /// Waits for the answer to a request.
    pub(super) fn answer(&mut self, id: i32) -> Result<Json, ResponseError> {
        loop {
            match self.next() {
                Message::Response(response) if response.id == id.into() => {
                    return response.response_result;
                }
                Message::Response(other) => unreachable!("an answer to nothing: {other:?}"),
                Message::Notification(told) => self.told.push_back((told.method, told.params)),
                Message::Request(asked) => self.told.push_back((asked.method, asked.params)),
            }
        }
    }

    /// The result of a request.
    #[track_caller]
    pub(super) fn ask(&mut self, method: &str, params: Json) -> Json {
        let id = self.begin(method, params);
        self.answer(id).expect(method)
    }

    /// The refusal of a request.
    #[track_caller]
    pub(super) fn refusal(&mut self, method: &str, params: Json) -> String {
        let id = self.begin(method, params);
        self.answer(id).expect_err("it is refused").message
    }

    /// The next notification or request of a kind.
    pub(super) fn hear(&mut self, method: &str) -> Json {
        if let Some(idx) = self.told.iter().position(|(told, _)| told == method) {
            return self.told.remove(idx).expect("it is there").1;
        }
        loop {
            match self.next() {
                Message::Notification(told) if told.method == method => return told.params,
                Message::Request(asked) if asked.method == method => return asked.params,
                Message::Notification(told) => self.told.push_back((told.method, told.params)),
                Message::Request(asked) => self.told.push_back((asked.method, asked.params)),
                Message::Response(other) => unreachable!("an answer to nothing: {other:?}"),
            }
        }
    }

    /// Forgets what was told so far.
    pub(super) fn forget(&mut self) {
        self.told.clear();
    }

    pub(super) fn open(&self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "virote", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces a range, line and column by line and column, or all.
    pub(super) fn edit(&self, uri: &str, version: i32, range: Option<[u32; 4]>, text: &str) {
        let change = match range {
            None => json!({ "text": text }),
            Some(places) => json!({ "range": range_of(places), "text": text }),
        };
        let document = json!({ "uri": uri, "version": version });
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": document, "contentChanges": [change] }),
        );
    }

    /// The findings of a version of a document, its values known: those that were told last.
    pub(super) fn findings(&mut self, uri: &str, version: i32) -> Vec<Json> {
        // It is answered when they are.
        let all = range_of([0, 0, 0, 0]);
        let document = json!({ "uri": uri });
        self.ask("textDocument/inlayHint", json!({ "textDocument": document, "range": all }));
        let is_it = |params: &Json| params["uri"] == uri && params["version"] == version;
        let last = self
            .told
            .iter()
            .rfind(|(told, params)| told == "textDocument/publishDiagnostics" && is_it(params));
        let (_, params) = last.expect("they are told before");
        params["diagnostics"].as_array().expect("a list").clone()
    }

    /// The findings of a version of a document that are told first, maybe of its text alone.
    pub(super) fn first_findings(&mut self, uri: &str, version: i32) -> Vec<Json> {
        loop {
            let told = self.hear("textDocument/publishDiagnostics");
            if told["uri"] == uri && told["version"] == version {
                return told["diagnostics"].as_array().expect("a list").clone();
            }
        }
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        if thread::panicking() {
            return;
        }
        self.ask("shutdown", Json::Null);
        self.tell("exit", Json::Null);
        drop(self.connection.take());
        self.server.take().expect("it runs").join().expect("the server ends well");
    }
}

pub(super) fn range_of([start_line, start, end_line, end]: [u32; 4]) -> Json {
    json!({
        "start": { "line": start_line, "character": start },
        "end": { "line": end_line, "character": end },
    })
}

/// A text without its mark `‸`, and where it stood, in columns of UTF-16.
pub(super) fn marked(text: &str) -> (String, Json) {
    let at = text.find('‸').expect("a mark");
    let before = &text[..at];
    let line = before.matches('\n').count();
    let column = before.rsplit('\n').next().unwrap_or_default().encode_utf16().count();
    (text.replace('‸', ""), json!({ "line": line, "character": column }))
}

/// A text after edits of the protocol, in columns of UTF-16.
pub(super) fn applied(text: &str, edits: &Json) -> String {
    let offset = |place: &Json| {
        let (line, column) = (
            place["line"].as_u64().expect("a line"),
            place["character"].as_u64().expect("a column"),
        );
        let start: usize = text.split_inclusive('\n').take(line as usize).map(str::len).sum();
        let mut left = column as usize;
        let inside = text[start..].char_indices().find(|(_, character)| {
            let is_there = left == 0;
            left = left.saturating_sub(character.len_utf16());
            is_there
        });
        inside.map_or(text.len(), |(at, _)| start + at)
    };
    let mut edits: Vec<(usize, usize, String)> = edits
        .as_array()
        .expect("edits")
        .iter()
        .map(|edit| {
            (
                offset(&edit["range"]["start"]),
                offset(&edit["range"]["end"]),
                edit["newText"].as_str().expect("a text").to_owned(),
            )
        })
        .collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.0));
    edits.into_iter().fold(text.to_owned(), |mut text, (start, end, new)| {
        text.replace_range(start..end, &new);
        text
    })
}
