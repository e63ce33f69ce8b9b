//! Every kind of request, over a script with a mark `‸`.

use serde_json::{Value as Json, json};

use super::client::{Client, applied, marked, range_of};
use crate::support::Scratch;

const URI: &str = "file:///nowhere/main.geo";

/// What a request about a marked script comes to, after its values are known.
#[track_caller]
fn asked(method: &str, text: &str, more: Json) -> (Json, String) {
    let (text, position) = marked(text);
    let mut client = Client::new();
    client.open(URI, &text);
    client.findings(URI, 1);
    let mut params = json!({ "textDocument": { "uri": URI }, "position": position });
    for (key, value) in more.as_object().into_iter().flatten() {
        params[key] = value.clone();
    }
    (client.ask(method, params), text)
}

#[test]
fn findings_come_with_codes_hints_and_related_places() {
    let mut client = Client::new();
    client.open(URI, "// 🫖\nlet width = 2\nprint /* ü🫖 */ widht\ncheck width > 3");
    let found = client.findings(URI, 1);
    assert_eq!(found[0]["code"], "E0201");
    assert_eq!(found[0]["range"], range_of([2, 16, 2, 21]));
    assert!(found[0]["message"].as_str().unwrap().contains("did you mean `width`?"));
    assert_eq!(found[0]["relatedInformation"][0]["location"]["range"], range_of([1, 4, 1, 9]));
    assert_eq!((&found[1]["severity"], &found[1]["range"]), (&json!(2), &range_of([3, 6, 3, 15])));
    client.edit(URI, 2, Some([2, 16, 2, 21]), "width");
    assert_eq!(client.findings(URI, 2).len(), 1);
    client.forget();
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": URI } }));
    assert_eq!(client.hear("textDocument/publishDiagnostics")["diagnostics"], json!([]));
}

#[test]
fn bytes_can_be_columns() {
    let mut client = Client::with(
        json!({ "general": { "positionEncodings": ["utf-16", "utf-8"] } }),
        Json::Null,
    );
    assert_eq!(client.capabilities["positionEncoding"], "utf-8");
    client.open(URI, "let a = 1 /* 🫖 */ print b");
    assert_eq!(client.findings(URI, 1)[0]["range"], range_of([0, 27, 0, 28]));
}

#[test]
fn a_hint_is_an_action() {
    let mut client = Client::new();
    let text = "let width = 2\nprint widht";
    client.open(URI, text);
    let params = json!({ "textDocument": { "uri": URI }, "range": range_of([1, 8, 1, 8]), "context": { "diagnostics": [] } });
    let actions = client.ask("textDocument/codeAction", params);
    assert_eq!(
        (&actions[0]["title"], &actions[0]["kind"]),
        (&json!("write `width`"), &json!("quickfix"))
    );
    assert_eq!(applied(text, &actions[0]["edit"]["changes"][URI]), "let width = 2\nprint width");
}

#[test]
fn hovers() {
    let (found, _) = asked(
        "textDocument/hover",
        "/// How wide. 🫖\nlet width = 27.2mm\nlet b = /* 🫖 */ wid‸th",
        Json::Null,
    );
    assert_eq!(found["contents"]["value"], "```geo\nlet width\n```\n\n27.2 mm\n\nHow wide. 🫖");
    assert_eq!(found["range"], range_of([2, 17, 2, 22]));
}

#[test]
fn a_hover_has_a_picture_where_pictures_are_shown() {
    let text = "surface ball = sphere((0, 0), 2)\nlet n = 3\n";
    let shown = |capabilities: Json, line: u32, is_drawn: bool| {
        let mut client = Client::with(capabilities, Json::Null);
        client.open(URI, text);
        client.findings(URI, 1);
        let params = json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": 8 - 4 * line } });
        // A picture that takes longer than a hover waits is there when it is asked for again.
        for _ in 0..200 {
            let contents = client.ask("textDocument/hover", params.clone())["contents"].clone();
            if !is_drawn || contents["value"].as_str().unwrap().contains("![") {
                return contents;
            }
        }
        unreachable!("there is a picture")
    };
    let marked = json!({ "general": { "markdown": { "parser": "marked" } } });
    let told = shown(marked.clone(), 0, true)["value"].as_str().unwrap().to_owned();
    let (words, picture) = told.split_once("\n\n![](data:image/png;base64,").unwrap();
    assert!(words.ends_with("\n\narea 50.2655 mm^2"), "{words}");
    assert!(picture.starts_with("iVBORw0KGgo") && picture.len() < 20_000);
    assert!(!shown(marked.clone(), 1, false)["value"].as_str().unwrap().contains("!["));
    assert!(
        !shown(json!({}), 0, false)["value"].as_str().unwrap().contains("!["),
        "as in a terminal"
    );
    let mut plain = marked;
    plain["textDocument"] = json!({ "hover": { "contentFormat": ["plaintext"] } });
    let told = shown(plain, 0, false);
    assert_eq!(told["kind"], "plaintext");
    assert!(!told["value"].as_str().unwrap().contains("!["));
}

#[test]
fn a_lens_runs_the_test_of_its_name_alone() {
    let mut client = Client::new();
    client.open(URI, "test \"a\" { check true }\ntest \"ab\" { check false }\n");
    let lenses = client.ask("textDocument/codeLens", json!({ "textDocument": { "uri": URI } }));
    let told = client.ask("workspace/executeCommand", lenses[0]["command"].clone());
    let passed = json!({ "name": "a", "verdict": "passed", "reasons": [] });
    assert_eq!(told, json!({ "passed": true, "tests": [passed] }));
    let told = client.ask("workspace/executeCommand", lenses[1]["command"].clone());
    assert_eq!(told["passed"], false);
}

#[test]
fn completions() {
    let (found, _) = asked(
        "textDocument/completion",
        "let width = 2mm\nlet b = circle((0, 0), wi‸)",
        Json::Null,
    );
    assert_eq!(found["isIncomplete"], true, "what does not go on from `wi` is left out");
    let found = found["items"].as_array().unwrap();
    assert!(found.iter().all(|item| item["label"] != "pi"));
    let item = found.iter().find(|item| item["label"] == "width").unwrap();
    assert_eq!(
        (&item["detail"], &item["textEdit"]["range"]),
        (&json!("2 mm"), &range_of([1, 23, 1, 25]))
    );
    let (found, _) = asked("textDocument/completion", "let b = cir‸", Json::Null);
    let call = found["items"].as_array().unwrap();
    let call = call.iter().find(|item| item["label"] == "circle").unwrap();
    assert_eq!(call["textEdit"]["newText"], "circle(${1:center}, ${2:radius}$0)");
    // Its page comes when somebody looks at it, and nothing else changes.
    assert_eq!(call["documentation"], Json::Null);
    let mut client = Client::new();
    let mut resolved = client.ask("completionItem/resolve", call.clone());
    let page = resolved["documentation"].take();
    assert!(page["value"].as_str().unwrap().contains("- `radius`"), "{page}");
    resolved.as_object_mut().unwrap().remove("documentation");
    assert_eq!(resolved, *call);
    assert_eq!(client.ask("completionItem/resolve", item.clone()), *item);
}

#[test]
fn signatures() {
    let (found, _) = asked("textDocument/signatureHelp", "let b = circle((0, 0), ‸", Json::Null);
    assert!(found["signatures"][0]["label"].as_str().unwrap().starts_with("circle("));
    assert_eq!((&found["activeParameter"], &found["activeSignature"]), (&json!(1), &json!(0)));
}

#[test]
fn names() {
    let text = "let a = 1\nlet b = a + ‸a";
    let (found, _) = asked("textDocument/definition", text, Json::Null);
    assert_eq!(found, json!({ "uri": URI, "range": range_of([0, 4, 0, 5]) }));
    let (found, _) = asked(
        "textDocument/references",
        text,
        json!({ "context": { "includeDeclaration": true } }),
    );
    assert_eq!(found.as_array().unwrap().len(), 3);
    let (found, _) = asked(
        "textDocument/references",
        text,
        json!({ "context": { "includeDeclaration": false } }),
    );
    assert_eq!(found.as_array().unwrap().len(), 2);
    let (found, _) = asked("textDocument/documentHighlight", text, Json::Null);
    assert_eq!((&found[0]["kind"], &found[2]["range"]), (&json!(3), &range_of([1, 12, 1, 13])));
    let (found, _) = asked("textDocument/prepareRename", text, Json::Null);
    assert_eq!(found, range_of([1, 12, 1, 13]));
    let (found, plain) = asked("textDocument/rename", text, json!({ "newName": "größe" }));
    assert_eq!(applied(&plain, &found["changes"][URI]), "let größe = 1\nlet b = größe + größe");
}

#[test]
fn a_rename_that_changes_a_meaning_is_refused() {
    let mut client = Client::new();
    client.open(URI, "let a = 1\nlet b = a");
    let params = json!({ "textDocument": { "uri": URI }, "position": { "line": 1, "character": 4 }, "newName": "a" });
    assert!(client.refusal("textDocument/rename", params).contains("means something else"));
}

#[test]
fn shapes() {
    let text = "‸// one\n// two\nfn f(x) = {\n    let y = x\n    y\n}\ntest \"t\" {\n    check f(1) == 1\n}\n";
    let (found, _) = asked("textDocument/documentSymbol", text, Json::Null);
    assert_eq!(
        (&found[0]["name"], &found[0]["children"][0]["name"], &found[1]["name"]),
        (&json!("f"), &json!("y"), &json!("t"))
    );
    let (found, _) = asked("textDocument/foldingRange", text, Json::Null);
    let lines: Vec<(u64, u64)> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|fold| (fold["startLine"].as_u64().unwrap(), fold["endLine"].as_u64().unwrap()))
        .collect();
    assert_eq!(lines, [(0, 1), (2, 5), (6, 8)]);
    let (found, _) = asked(
        "textDocument/selectionRange",
        "let a = [1, ‸2]",
        json!({ "positions": [{ "line": 0, "character": 12 }] }),
    );
    assert_eq!(
        (&found[0]["range"], &found[0]["parent"]["range"]),
        (&range_of([0, 12, 0, 13]), &range_of([0, 8, 0, 14]))
    );
}

#[test]
fn words_have_kinds() {
    let (found, _) = asked(
        "textDocument/semanticTokens/full",
        "‸let 🫖 = 1\nlet a = 2 // one\nprint a",
        Json::Null,
    );
    // Five numbers each: lines and columns ahead, length, kind, marks.
    let data = found["data"].as_array().unwrap();
    let rows: Vec<Vec<u64>> =
        data.chunks(5).map(|row| row.iter().map(|one| one.as_u64().unwrap()).collect()).collect();
    assert!(rows.contains(&vec![1, 0, 3, 0, 0]), "`let` begins line 1: {rows:?}");
    assert!(rows.contains(&vec![0, 4, 1, 1, 5]), "`a` is declared: {rows:?}");
    let (within, _) = asked(
        "textDocument/semanticTokens/range",
        "‸let a = 2\nprint a",
        json!({ "range": range_of([1, 0, 1, 7]) }),
    );
    assert_eq!(within["data"], json!([1, 0, 5, 0, 0, 0, 6, 1, 1, 4]));
}

#[test]
fn canonical_form() {
    let text = "‸let   a = 1\nlet b = 2\nlet   c =  [ 1,2 ]\n";
    let options = json!({ "options": { "tabSize": 4, "insertSpaces": true } });
    let (found, plain) = asked("textDocument/formatting", text, options.clone());
    assert_eq!(applied(&plain, &found), "let a = 1\nlet b = 2\nlet c = [1, 2]\n");
    assert_eq!(found.as_array().unwrap().len(), 2, "the line between is left alone");
    let mut more = options.clone();
    more["range"] = range_of([2, 0, 2, 3]);
    let (found, plain) = asked("textDocument/rangeFormatting", text, more);
    assert_eq!(applied(&plain, &found), "let   a = 1\nlet b = 2\nlet c = [1, 2]\n");
    let mut more = options;
    more["ch"] = json!("\n");
    let (found, plain) =
        asked("textDocument/onTypeFormatting", "let   a = 1\n\n‸\n\nlet   b = 2\n", more.clone());
    assert_eq!(found, json!([]), "blank lines around the cursor stay: {plain}");
    let (found, plain) =
        asked("textDocument/onTypeFormatting", "let   a = 1\n‸\nlet   b = 2\n", more);
    assert_eq!(applied(&plain, &found), "let a = 1\n\nlet   b = 2\n");
}

#[test]
fn what_is_not_formatted_is_told() {
    let mut client = Client::new();
    client.open(URI, "let   a = 1\nlet b = (");
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let params = json!({ "textDocument": { "uri": URI }, "options": options });
    assert_eq!(client.ask("textDocument/formatting", params), json!([]));
    let told = client.hear("window/showMessage");
    assert!(told["message"].as_str().unwrap().contains("in line 2"), "{told}");
}

#[test]
fn a_test_that_fails_says_why() {
    let mut client = Client::new();
    client.open(URI, "let a = 2\ntest \"t1\" { check a < 1 }");
    assert!(client.findings(URI, 1).is_empty());
    client.forget();
    let params = json!({ "command": "virote.runTest", "arguments": [URI, "t1"] });
    let result = client.ask("workspace/executeCommand", params);
    assert_eq!(result["tests"][0]["verdict"], "failed");
    let told = client.hear("window/showMessage");
    assert!(told["message"].as_str().unwrap().starts_with("t1: failed; `a < 1`: "), "{told}");
    let found = client.findings(URI, 1);
    assert_eq!((found.len(), &found[0]["range"]), (1, &range_of([1, 18, 1, 23])), "{found:?}");
}

#[test]
fn a_field_that_is_taken_apart_is_not_renamed() {
    let mut client = Client::new();
    client.open(URI, "let {a1} = {a1: 1}");
    let params =
        json!({ "textDocument": { "uri": URI }, "position": { "line": 0, "character": 5 } });
    assert!(client.refusal("textDocument/prepareRename", params).contains("the field"));
}

#[test]
fn hints_and_lenses() {
    let text = "‸let a = 2mm\nlet b = a * 3\ncurve c = line((0, 0), (3, 4))\ncheck length(c) < 6\ntest \"t\" { check 1 < 2 }\n";
    let (found, _) =
        asked("textDocument/inlayHint", text, json!({ "range": range_of([0, 0, 9, 0]) }));
    let labels: Vec<&str> =
        found.as_array().unwrap().iter().map(|hint| hint["label"].as_str().unwrap()).collect();
    assert_eq!(labels, [" = 6 mm", " holds with margin 1mm"]);
    assert_eq!(found[0]["position"], json!({ "line": 1, "character": 13 }));
    let (found, _) = asked("textDocument/codeLens", text, Json::Null);
    let titles: Vec<&str> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|lens| lens["command"]["title"].as_str().unwrap())
        .collect();
    assert_eq!(titles, ["open in view", "✓ holds with margin 1mm", "run"]);

    let mut client = Client::new();
    client.tell("workspace/didChangeConfiguration", json!({ "settings": { "virote": { "inlayHints": { "values": false }, "codeLens": false } } }));
    client.open(URI, &text.replace('‸', ""));
    let document = json!({ "uri": URI });
    let found = client.ask(
        "textDocument/inlayHint",
        json!({ "textDocument": document, "range": range_of([0, 0, 9, 0]) }),
    );
    assert_eq!(found.as_array().unwrap().len(), 1);
    assert_eq!(client.ask("textDocument/codeLens", json!({ "textDocument": document })), json!([]));
    let test = json!({ "command": "virote.runTest", "arguments": [URI, "t"] });
    assert_eq!(client.ask("workspace/executeCommand", test)["passed"], true);
}

#[test]
fn colours() {
    let text = "‸curve c = line((0, 0), (1, 0)) with (color = \"red\")";
    let (found, _) = asked("textDocument/documentColor", text, Json::Null);
    assert_eq!(
        (&found[0]["range"], &found[0]["color"]["red"]),
        (&range_of([0, 45, 0, 50]), &json!(1.0))
    );
    let color = json!({ "red": 0.0, "green": 0.0, "blue": 1.0, "alpha": 1.0 });
    let (found, _) = asked(
        "textDocument/colorPresentation",
        text,
        json!({ "color": color, "range": range_of([0, 45, 0, 50]) }),
    );
    assert_eq!(
        (&found[0]["label"], &found[1]["textEdit"]["newText"]),
        (&json!("\"blue\""), &json!("\"#0000ff\""))
    );
}

#[test]
fn calls() {
    let text = "fn ‸f(x) = x\nfn g(x) = f(x) + f(2)\nlet a = g(1)\n";
    let (found, _) = asked("textDocument/prepareCallHierarchy", text, Json::Null);
    let item = found[0].clone();
    let (found, _) = asked("callHierarchy/incomingCalls", text, json!({ "item": item }));
    assert_eq!(
        (&found[0]["from"]["name"], found[0]["fromRanges"].as_array().unwrap().len()),
        (&json!("g"), 2)
    );
    let (items, _) = asked(
        "textDocument/prepareCallHierarchy",
        &text.replace('‸', "").replace("fn g", "fn ‸g"),
        Json::Null,
    );
    let (found, _) = asked("callHierarchy/outgoingCalls", text, json!({ "item": items[0] }));
    assert_eq!(found[0]["to"]["name"], "f");
}

/// A folder with a part, a script that imports it, and one that imports it too and is not open.
fn workspace(name: &str) -> (Scratch, impl Fn(&str) -> String) {
    let folder = Scratch::new(name);
    let root = folder.0.clone();
    let write =
        |name: &str, text: &str| std::fs::write(root.join(name), text).expect("a file is written");
    write("part.geo", "let size = 3mm\nlet twice = 2 * size\n");
    write("main.geo", "import \"part.geo\"\nprint part.size\n");
    write("other.geo", "import \"part.geo\" (size)\nprint size\n");
    let uri = move |name: &str| format!("file://{}", root.join(name).display());
    (folder, uri)
}

#[test]
fn names_are_renamed_in_all_scripts_of_the_workspace() {
    let (folder, uri) = workspace("lsp-rename");
    let mut client = Client::with(json!({}), json!(format!("file://{}", folder.0.display())));
    let main = "import \"part.geo\"\nprint part.size\n";
    client.open(&uri("main.geo"), main);
    assert!(client.findings(&uri("main.geo"), 1).is_empty());
    let at = json!({ "textDocument": { "uri": uri("main.geo") }, "position": { "line": 1, "character": 13 } });
    let found = client.ask("textDocument/definition", at.clone());
    assert_eq!(
        (&found["uri"], &found["range"]),
        (&json!(uri("part.geo")), &range_of([0, 4, 0, 8]))
    );
    let mut params = at.clone();
    params["context"] = json!({ "includeDeclaration": true });
    assert_eq!(client.ask("textDocument/references", params).as_array().unwrap().len(), 5);
    let mut params = at;
    params["newName"] = json!("width");
    let changes = client.ask("textDocument/rename", params)["changes"].clone();
    assert_eq!(applied(main, &changes[uri("main.geo")]), "import \"part.geo\"\nprint part.width\n");
    assert_eq!(
        applied("let size = 3mm\nlet twice = 2 * size\n", &changes[uri("part.geo")]),
        "let width = 3mm\nlet twice = 2 * width\n"
    );
    assert_eq!(
        applied("import \"part.geo\" (size)\nprint size\n", &changes[uri("other.geo")]),
        "import \"part.geo\" (width)\nprint width\n"
    );
    let found = client.ask("workspace/symbol", json!({ "query": "TWI" }));
    assert_eq!((&found[0]["name"], found.as_array().unwrap().len()), (&json!("twice"), 1));
    let found = client
        .ask("textDocument/documentLink", json!({ "textDocument": { "uri": uri("main.geo") } }));
    assert_eq!(
        (&found[0]["target"], &found[0]["range"]),
        (&json!(uri("part.geo")), &range_of([0, 8, 0, 16]))
    );
}

#[test]
fn what_is_not_saved_counts_where_it_is_imported() {
    let (_folder, uri) = workspace("lsp-unsaved");
    let mut client = Client::new();
    client.open(&uri("main.geo"), "import \"part.geo\"\ncheck part.size == 3mm\n");
    assert!(client.findings(&uri("main.geo"), 1).is_empty());
    client.open(&uri("part.geo"), "let size = 4mm\n");
    let found = client.findings(&uri("main.geo"), 1);
    assert_eq!(found[0]["code"], "E1001", "{found:?}");
    client.edit(&uri("part.geo"), 2, Some([0, 11, 0, 12]), "3");
    assert!(client.findings(&uri("main.geo"), 1).is_empty());
    // A mistake of a file that is not open is told there.
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri("part.geo") } }));
    assert!(client.findings(&uri("main.geo"), 1).is_empty());
}
