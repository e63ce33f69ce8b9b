//! Names get another one in every script of the workspace that uses them, or the rename is refused.

use serde_json::{Value as Json, json};

use super::client::{Client, applied, range_of};
use crate::support::Scratch;

const LIBRARY: &str = "param wide = 3\nlet rec = {wide: wide}\n";

/// What a rename of the library's first name comes to in `main.geo`, which is not open.
fn renamed(name: &str, main: &str) -> Result<(String, String), String> {
    let scratch = Scratch::new(name);
    scratch.file("lib.geo", LIBRARY);
    scratch.file("main.geo", main);
    let uri = |name: &str| format!("file://{}", scratch.0.join(name).display());
    let mut client = Client::with(json!({}), json!(format!("file://{}", scratch.0.display())));
    client.open(&uri("lib.geo"), LIBRARY);
    let params = json!({ "textDocument": { "uri": uri("lib.geo") }, "position": { "line": 0, "character": 6 }, "newName": "zq" });
    let id = client.begin("textDocument/rename", params);
    let answer = client.answer(id).map_err(|refusal| refusal.message)?;
    let changed = |name: &str, text: &str| match &answer["changes"][uri(name)] {
        Json::Null => text.to_owned(),
        edits => applied(text, edits),
    };
    Ok((changed("lib.geo", LIBRARY), changed("main.geo", main)))
}

#[test]
fn scripts_that_ask_a_file_by_script_are_renamed_along() {
    for (i, (before, after)) in [
        ("let x = script(\"lib.geo\").wide\n", "let x = script(\"lib.geo\").zq\n"),
        (
            "let s = script(\"lib.geo\", wide = 2)\nlet x = s.wide\nprint \"{s.wide}\"\n",
            "let s = script(\"lib.geo\", zq = 2)\nlet x = s.zq\nprint \"{s.zq}\"\n",
        ),
        (
            "let {wide, rec} = script(\"lib.geo\")\nprint wide\n",
            "let {zq, rec} = script(\"lib.geo\")\nprint zq\n",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let library = "param zq = 3\nlet rec = {wide: zq}\n".to_owned();
        let found = renamed(&format!("lsp-by-script-{i}"), before);
        assert_eq!(found, Ok((library, after.to_owned())));
    }
}

#[test]
fn a_rename_that_could_miss_a_use_is_refused() {
    let found = renamed("lsp-unseen", "let s = [script(\"lib.geo\")]\nlet x = s[0].wide\n");
    let told = found.expect_err("it is refused");
    assert!(told.contains("main.geo:2: `wide` may be this one"), "{told}");
    let long = format!("let x = script(\"lib.geo\").wide\n{}", "// filling\n".repeat(100_000));
    let told = renamed("lsp-long", &long).expect_err("it is refused");
    assert!(told.contains("too large to be looked through"), "{told}");
}

#[test]
fn names_of_a_text_that_is_no_file_are_found() {
    let mut client = Client::new();
    let uri = "untitled:Untitled-1";
    client.open(uri, "let a = 1\nlet b = a\n");
    let mut params =
        json!({ "textDocument": { "uri": uri }, "position": { "line": 1, "character": 8 } });
    let found = client.ask("textDocument/definition", params.clone());
    assert_eq!((&found["uri"], &found["range"]), (&json!(uri), &range_of([0, 4, 0, 5])));
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.ask("textDocument/references", params);
    assert_eq!(found.as_array().map(Vec::len), Some(2), "{found}");
}
