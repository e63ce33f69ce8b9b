//! What clients do wrong, and what is hard: none of it ends the server, and the next request is answered.

use std::time::Duration;

use serde_json::{Value as Json, json};
use virote::{session::Session, value::NoFiles};

use super::client::{Client, range_of};

const URI: &str = "file:///nowhere/main.geo";

/// Asks something that is answered by a server that lives.
#[track_caller]
fn lives(client: &mut Client) {
    let uri = "file:///nowhere/other.geo";
    client.open(uri, "let alive = 1");
    let found =
        client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    assert_eq!(found[0]["name"], "alive");
}

#[test]
fn unknown_methods_and_bad_parameters_are_refused() {
    let mut client = Client::new();
    assert!(client.refusal("textDocument/noSuchThing", json!({})).contains("noSuchThing"));
    client.refusal("textDocument/hover", json!({ "wrong": true }));
    client.refusal("textDocument/hover", json!([1, 2]));
    client.refusal("workspace/executeCommand", json!({ "command": "virote.noSuchCommand" }));
    let nowhere = json!({ "textDocument": { "uri": "file:///not/open.geo" }, "position": { "line": 0, "character": 0 } });
    assert_eq!(client.ask("textDocument/hover", nowhere.clone()), Json::Null);
    client.refusal("textDocument/hover", json!({ "textDocument": { "uri": "no address" }, "position": { "line": 0, "character": 0 } }));
    client.tell("$/noSuchThing", json!(7));
    client.tell("textDocument/didOpen", json!({ "textDocument": 7 }));
    client.tell("textDocument/didChange", nowhere);
    client.tell("textDocument/didClose", json!(null));
    client.tell("workspace/didChangeWatchedFiles", json!({ "changes": "all" }));
    client.tell("workspace/didChangeConfiguration", json!({ "settings": [1] }));
    lives(&mut client);
}

#[test]
fn places_outside_of_the_text_are_clamped() {
    let mut client = Client::new();
    client.open(URI, "let a = 1\n// 🫖");
    let far = json!({ "line": 4_000_000_000_u32, "character": 4_000_000_000_u32 });
    for method in
        ["hover", "completion", "signatureHelp", "definition", "documentHighlight", "prepareRename"]
    {
        client.ask(
            &format!("textDocument/{method}"),
            json!({ "textDocument": { "uri": URI }, "position": far }),
        );
    }
    // The second half of a surrogate pair, and a range that ends before it begins.
    client.ask(
        "textDocument/hover",
        json!({ "textDocument": { "uri": URI }, "position": { "line": 1, "character": 4 } }),
    );
    client.edit(URI, 2, Some([1, 4, 1, 4]), "x");
    client.edit(URI, 3, Some([900, 0, 0, 8]), "2");
    client.edit(URI, 4, None, "print b");
    assert_eq!(client.findings(URI, 4)[0]["code"], "E0201");
    lives(&mut client);
}

#[test]
fn an_edit_of_an_older_version_is_passed_over() {
    let mut client = Client::new();
    client.open(URI, "let a = 1");
    client.edit(URI, 5, Some([0, 8, 0, 9]), "2");
    client.edit(URI, 3, Some([0, 0, 0, 9]), "print nothing");
    assert!(client.hear("window/logMessage")["message"].as_str().unwrap().contains("version 3"));
    // Nor a whole text, and no edit of that one.
    client.edit(URI, 3, None, "print nothing");
    client.edit(URI, 4, Some([0, 0, 0, 5]), "check");
    client.edit(URI, 6, Some([0, 8, 0, 9]), "unknown");
    assert_eq!(client.findings(URI, 6)[0]["range"], range_of([0, 8, 0, 15]));
}

#[test]
fn an_endless_run_ends_with_the_next_edit() {
    let mut client = Client::new();
    client
        .open(URI, "print unknown\nprint sum([for i in 0..<100000: sum([for j in 0..<9000: j])])");
    // What is wrong with the text is told while the run goes on.
    assert_eq!(client.first_findings(URI, 1)[0]["code"], "E0201");
    let hints = client.begin(
        "textDocument/inlayHint",
        json!({ "textDocument": { "uri": URI }, "range": range_of([0, 0, 9, 0]) }),
    );
    client.edit(URI, 2, None, "print 1");
    assert_eq!(client.answer(hints).expect_err("of another text").code, -32801);
    assert!(client.findings(URI, 2).is_empty());
}

#[test]
fn what_needs_no_value_is_told_during_an_endless_run() {
    let refresh = json!({ "refreshSupport": true });
    let mut client = Client::with(
        json!({ "workspace": { "inlayHint": refresh, "codeLens": refresh } }),
        serde_json::Value::Null,
    );
    let text =
        "fn twice(long, wide) = long * wide\nlet a = twice(1, 2)\ntest \"t\" { check true }\n";
    let endless = format!("{text}print sum([for i in 0..<100000: sum([for j in 0..<9000: j])])");
    client.open(URI, &endless);
    let whole = json!({ "textDocument": { "uri": URI }, "range": range_of([0, 0, 9, 0]) });
    let labels = |hints: &serde_json::Value| -> Vec<String> {
        let hints = hints.as_array().expect("hints").iter();
        hints.map(|hint| hint["label"].as_str().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(labels(&client.ask("textDocument/inlayHint", whole.clone())), ["long: ", "wide: "]);
    client.edit(URI, 2, None, text);
    client.hear("workspace/inlayHint/refresh");
    client.hear("workspace/codeLens/refresh");
    let hints = client.ask("textDocument/inlayHint", whole.clone());
    assert_eq!(labels(&hints), ["long: ", "wide: ", " = 2"]);
    // Who cannot be told to ask anew is answered a little later.
    let mut client = Client::new();
    client.open(URI, &endless);
    assert_eq!(labels(&client.ask("textDocument/inlayHint", whole.clone())), ["long: ", "wide: "]);
    assert!(client.ask("textDocument/codeLens", whole).is_array());
}

#[test]
fn an_endless_run_does_not_keep_another_document_waiting() {
    let mut client = Client::new();
    client.open(URI, "print sum([for i in 0..<100000: sum([for j in 0..<9000: j])])");
    std::thread::sleep(Duration::from_millis(500));
    let other = "file:///nowhere/other.geo";
    client.open(other, "print unknown");
    assert_eq!(client.findings(other, 1)[0]["code"], "E0201");
    let hints = client.begin(
        "textDocument/inlayHint",
        json!({ "textDocument": { "uri": other }, "range": range_of([0, 0, 9, 0]) }),
    );
    assert_eq!(client.answer(hints).expect("its values are there"), json!([]));
    // A request that waits can be called off.
    let hints = client.begin(
        "textDocument/inlayHint",
        json!({ "textDocument": { "uri": URI }, "range": range_of([0, 0, 9, 0]) }),
    );
    client.tell("$/cancelRequest", json!({ "id": hints }));
    assert_eq!(client.answer(hints).expect_err("it was called off").code, -32800);
}

#[test]
fn a_script_that_exhausts_its_ceilings_is_told_and_forgotten() {
    let mut client = Client::new();
    client.open(URI, "fn f(n) = 1 + f(n + 1)\nprint f(0)");
    assert_eq!(client.findings(URI, 1)[0]["code"], "E0403");
    client.edit(URI, 2, None, &format!("let a = {}", "(".repeat(100_000)));
    assert!(!client.findings(URI, 2).is_empty());
    client.edit(URI, 3, None, "let a = 1");
    assert!(client.findings(URI, 3).is_empty());
}

#[test]
fn a_document_of_ten_megabytes_is_served() {
    let mut client = Client::new();
    let line = format!("// {}\n", "🫖 a comment that goes on and on ".repeat(8));
    let text = format!("{}print unknown", line.repeat((10 << 20) / line.len()));
    let lines = text.matches('\n').count() as u32;
    client.open(URI, &text);
    assert_eq!(client.findings(URI, 1)[0]["range"], range_of([lines, 6, lines, 13]));
    client.edit(URI, 2, Some([lines, 6, lines, 13]), "1");
    assert!(client.findings(URI, 2).is_empty());
}

/// Each place is counted from the start of its line, which is far away.
#[test]
fn a_long_line_of_many_definitions_is_served() {
    let mut client = Client::new();
    let n = 20_000;
    let definitions: Vec<String> = (0..n).map(|i| format!("let ü{i} = {i}")).collect();
    client.open(URI, &definitions.join(" "));
    let params = json!({ "textDocument": { "uri": URI } });
    let found = client.ask("textDocument/semanticTokens/full", params.clone());
    assert_eq!(found["data"].as_array().map(Vec::len), Some(5 * 4 * n));
    let found = client.ask("textDocument/documentSymbol", params);
    let start = definitions.join(" ").chars().count() - format!("ü{0} = {0}", n - 1).len() + 1;
    let end = start + format!("ü{}", n - 1).chars().count();
    let (start, end) = (start as u32, end as u32);
    assert_eq!(found[n - 1]["selectionRange"], range_of([0, start, 0, end]));
}

#[test]
fn a_thousand_edits_in_a_row_come_to_the_last() {
    let mut client = Client::new();
    client.open(URI, "let a = 0");
    for version in 2..=1001 {
        client.edit(URI, version, Some([0, 8, 0, 9]), &(version % 10).to_string());
    }
    client.edit(URI, 1002, Some([0, 9, 0, 9]), " + b");
    assert_eq!(client.findings(URI, 1002)[0]["range"], range_of([0, 12, 0, 13]));
}

#[test]
fn files_that_vanish_are_told() {
    let folder = crate::support::Scratch::new("lsp-vanish");
    let part = folder.file("part.geo", "let size = 3mm\n");
    let uri = format!("file://{}", folder.0.join("main.geo").display());
    let mut client = Client::new();
    client.open(&uri, "import \"part.geo\"\nprint part.size");
    assert!(client.findings(&uri, 1).is_empty());
    std::fs::remove_file(&part).expect("it goes");
    let gone = format!("file://{}", part.display());
    client.tell(
        "workspace/didChangeWatchedFiles",
        json!({ "changes": [{ "uri": gone, "type": 3 }] }),
    );
    assert_eq!(client.findings(&uri, 1)[0]["code"], "E0701");
    std::fs::remove_dir_all(&folder.0).expect("it goes");
    client.ask(
        "textDocument/completion",
        json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": 8 } }),
    );
    lives(&mut client);
}

#[test]
fn an_import_that_was_missing_is_found_when_it_is_made() {
    let folder = crate::support::Scratch::new("lsp-made");
    let uri = |name: &str| format!("file://{}", folder.0.join(name).display());
    let mut client = Client::new();
    let code = |client: &mut Client| client.findings(&uri("main.geo"), 1)[0]["code"].clone();
    client.open(&uri("main.geo"), "import \"middle.geo\" as middle\nprint middle.size");
    assert_eq!(code(&mut client), "E0701");
    // In the editor, and not on the disk yet; it misses another one.
    client.open(&uri("middle.geo"), "import \"part.geo\" as part\nlet size = part.size");
    assert_eq!(code(&mut client), "E0306");
    client.open(&uri("part.geo"), "let size = 3mm");
    assert!(client.findings(&uri("main.geo"), 1).is_empty());
}

/// Whoever types at random.
struct Typist {
    text: String,
    state: u64,
}

const PIECES: [&str; 15] = [
    "",
    "1",
    "mm",
    "(",
    ")",
    "\n",
    "let a = 2\n",
    "🫖",
    "\"",
    "ü",
    "// x\n",
    "length(",
    "]",
    ", ",
    "neck",
];

impl Typist {
    fn random(&mut self, below: usize) -> usize {
        let product = self.state.wrapping_mul(6_364_136_223_846_793_005);
        self.state = product.wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) as usize % below.max(1)
    }

    /// Line and column of a byte, in units of UTF-16.
    fn place(&self, at: usize) -> [u32; 2] {
        let before = &self.text[..at];
        let line = before.rsplit('\n').next().unwrap_or_default();
        [before.matches('\n').count() as u32, line.encode_utf16().count() as u32]
    }

    /// One edit; now and then the text is a whole example again.
    fn edit(&mut self, client: &Client, version: i32) {
        if self.text.len() > 6000 || self.random(40) == 0 {
            self.text = std::fs::read_to_string("examples/bottle.geo").expect("an example");
            return client.edit(URI, version, None, &self.text);
        }
        let n_bytes = self.text.len();
        let start = self.random(n_bytes);
        let start = self.text.floor_char_boundary(start);
        let end = (start + self.random(12)).min(n_bytes);
        let end = self.text.floor_char_boundary(end);
        let piece = PIECES[self.random(PIECES.len())];
        let ([line, column], [end_line, end_column]) = (self.place(start), self.place(end));
        client.edit(URI, version, Some([line, column, end_line, end_column]), piece);
        self.text.replace_range(start..end, piece);
    }
}

/// What a server says of a text, its values known.
fn all_of(client: &mut Client) -> [Json; 3] {
    let document = json!({ "uri": URI });
    let all = range_of([0, 0, 100_000, 0]);
    [
        client.ask("textDocument/inlayHint", json!({ "textDocument": document, "range": all })),
        client.ask("textDocument/semanticTokens/full", json!({ "textDocument": document })),
        client.ask("textDocument/documentSymbol", json!({ "textDocument": document })),
    ]
}

/// After each pause the server says what a fresh one says of the same text.
#[test]
fn random_edits_lead_to_what_a_fresh_server_tells() {
    let text = std::fs::read_to_string("examples/bottle.geo").expect("an example");
    let mut typist = Typist { text, state: 0x9e37_79b9_7f4a_7c15 };
    let mut client = Client::new();
    client.open(URI, &typist.text);
    let mut version = 1;
    for round in 0..30 {
        for _ in 0..=typist.random(6) {
            version += 1;
            typist.edit(&client, version);
        }
        let known = all_of(&mut client);
        let found = client.findings(URI, version);
        let codes: Vec<&str> = found.iter().filter_map(|one| one["code"].as_str()).collect();
        let report = Session::default().run("main.geo", typist.text.as_bytes(), &NoFiles, &[]);
        let expected: Vec<&str> = report.diagnostics.iter().map(|one| one.code.id()).collect();
        assert_eq!(codes, expected, "round {round}:\n{}", typist.text);
        let mut fresh = Client::new();
        fresh.open(URI, &typist.text);
        assert_eq!(all_of(&mut fresh), known, "round {round}:\n{}", typist.text);
        assert_eq!(fresh.findings(URI, 1), found, "round {round}:\n{}", typist.text);
    }
}
