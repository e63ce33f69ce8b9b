//! The scripts in the documents: each `geo` block runs and passes its tests, each `geo-error` block
//! does not.

mod support;

use std::fs;

use support::{Scratch, folder, virote};

/// Documents with scripts in them.
const DOCUMENTS: &[&str] =
    &["README.md", "docs/language.md", "docs/numerics.md", "docs/reference.md"];

/// The blocks of a language with the lines on which they begin.
fn blocks(text: &str, language: &str) -> Vec<(usize, String)> {
    let (mut found, mut open) = (Vec::new(), None);
    for (i, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((i + 1, info.trim().to_owned(), String::new())),
            (Some(_), Some(_)) => {
                let (start, info, body) = open.take().expect("a block is open");
                if info == language {
                    found.push((start, body));
                }
            }
            (Some((_, _, body)), None) => {
                body.push_str(line);
                body.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// Gives every block of a language to a verb; `fits` judges the exit code.
#[track_caller]
fn check(verb: &str, language: &str, fits: impl Fn(i32) -> bool) {
    let mut n_blocks = 0;
    for document in DOCUMENTS {
        let text = fs::read_to_string(folder(document)).expect("the document is there");
        for (line, body) in blocks(&text, language) {
            let scratch = Scratch::new(&format!("docs-{verb}-{language}"));
            let script = scratch.file("block.geo", body);
            let output = virote(&scratch.0).arg(verb).arg(script).output().expect("it starts");
            let code = output.status.code().unwrap_or(-1);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(fits(code), "{document}:{line}: exit code {code}\n{said}");
            n_blocks += 1;
        }
    }
    assert!(n_blocks > 0, "no document has a `{language}` block");
}

#[test]
fn scripts_in_the_documents_run() {
    check("run", "geo", |code| code == 0);
}

#[test]
fn tests_in_the_documents_pass() {
    check("test", "geo", |code| code == 0);
}

#[test]
fn mistakes_in_the_documents_are_mistakes() {
    check("run", "geo-error", |code| code == 1 || code == 2);
}
