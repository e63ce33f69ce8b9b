//! Programs with mistakes: each `tests/errors/NAME.geo` makes the mistake that its name tells, and
//! `NAME.out` holds the message that it gets.
//!
//! The exit code is 2, but 1 where the name begins with `check-` and 3 where it begins with
//! `usage-`. `VIROTE_BLESS=1 cargo test --test scripts errors` rewrites the golden files: read each
//! message as a beginner would. Does it name the culprit and its place, what was expected and
//! found, and what to do?

use crate::support::{compare, complaints_of, files_below, folder, report, transcript};

fn expected_code(name: &str) -> i32 {
    match name.split('-').next() {
        Some("check") => 1,
        Some("usage") => 3,
        _ => 2,
    }
}

#[test]
fn mistakes_are_told() {
    let folder = folder("tests/errors");
    report(&complaints_of(&folder, |name| {
        let (code, text) = transcript(&folder, name);
        let mut complaints = Vec::new();
        if text.contains("virote failed") {
            complaints.push(format!("{name}.geo panics:\n{text}"));
        }
        let expected = expected_code(name);
        if code != expected {
            complaints.push(format!("{name}.geo exits with {code}, not {expected}:\n{text}"));
        }
        complaints.extend(compare(&folder.join(format!("{name}.out")), &text));
        complaints
    }));
}

#[test]
fn every_golden_file_has_its_program() {
    for file in files_below(&folder("tests/errors")).iter().filter(|file| file.ends_with(".out")) {
        let program = file.replace(".out", ".geo");
        assert!(folder("tests/errors").join(&program).is_file(), "{file} is left over");
    }
}
