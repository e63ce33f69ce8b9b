//! The scripts in the documents: each `geo` block runs and passes its tests, each `geo-error` block
//! does not.

use std::fs;

use crate::support::{Scratch, folder, told, virote};

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
            // What the example of `load` loads.
            scratch.file("points.csv", "x,y\n0,0\n1,2\n4,3\n");
            scratch.file("ring.geo", "param radius = 10mm\ncurve rim = circle((0, 0), radius)\n");
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

/// What `virote run` says of a script: standard output, standard error, exit code.
fn run(name: &str, script: &str) -> (String, String, i32) {
    let scratch = Scratch::new("docs-readme");
    scratch.file(name, script);
    told(&virote(&scratch.0).args(["run", name]).output().expect("it starts"))
}

#[test]
fn the_readme_shows_what_the_command_says() {
    let text = fs::read_to_string(folder("README.md")).expect("the README");
    let [(_, arch)] = &blocks(&text, "geo")[..] else { panic!("one script") };
    let [(_, too_low), (_, mistakes)] = &blocks(&text, "text")[..] else { panic!("two reports") };
    let (out, err, code) = run("arch.geo", arch);
    assert!(text.contains(out.lines().next().expect("a line")), "{out}");
    assert_eq!((err.as_str(), code), ("", 0));
    let (_, err, code) = run("arch.geo", &arch.replace("rise = 80mm", "rise = 60mm"));
    assert_eq!((&err, code), (too_low, 1));
    let bad = "let depth = 10mm\nlet tilt = 30deg\nlet slant = depth + tilt\n\n\
        curve wall = besier((0, 0), (40, 60), (80, 0))\n";
    let (_, err, code) = run("bad.geo", bad);
    assert_eq!((&err, code), (mistakes, 2));
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
