//! Golden programs: each `tests/golden/NAME.geo` is run, and what it says and writes is compared
//! with `NAME.out`. The programs of `examples/` have golden folders, and `virote test` runs them.
//!
//! The worked examples of the textbooks in `tests/golden/textbook`, by the books' own numbers, and
//! the values of `tests/golden/values`, computed with forty digits by other means, check themselves
//! and say nothing else than what `warnings.out` beside them holds.
//!
//! `VIROTE_BLESS=1 cargo test --test scripts golden` rewrites the golden files. A program that begins with
//! a line such as `// --set n=3` is run with those arguments.

use crate::support::{compare, complaints_of, folder, programs, report, told, transcript, virote};

#[test]
fn programs_say_and_write_what_they_did() {
    let folder = folder("tests/golden");
    report(&complaints_of(&folder, |name| {
        let (code, text) = transcript(&folder, name);
        let mut complaints = Vec::new();
        if text.contains("virote failed") {
            complaints.push(format!("{name}.geo panics:\n{text}"));
        }
        let expected = if name.starts_with("failed-") { 1 } else { 0 };
        if code != expected {
            complaints.push(format!("{name}.geo exits with {code}, not {expected}:\n{text}"));
        } else {
            complaints.extend(compare(&folder.join(format!("{name}.out")), &text));
        }
        complaints
    }));
}

/// Runs the checks of every program of a folder.
#[track_caller]
fn hold(of_programs: &str) {
    let (out, err, code) =
        told(&virote(&folder(of_programs)).args(["test", "."]).output().expect("the command runs"));
    let count = format!("{} files, ", programs(&folder(of_programs)).len());
    assert!(code == 0 && out.contains(&count), "{out}{err}exit code {code}");
    let golden = folder(of_programs).join("warnings.out");
    if !err.is_empty() || golden.exists() {
        report(&compare(&golden, &err).into_iter().collect::<Vec<_>>());
    }
}

#[test]
fn examples_say_and_write_what_they_did() {
    hold("examples");
    for name in programs(&folder("examples")) {
        let golden = folder("examples").join(format!("{name}.golden"));
        assert!(golden.is_dir(), "virote test --bless examples/{name}.geo makes its golden folder");
    }
}

#[test]
fn worked_examples_of_the_textbooks_hold() {
    hold("tests/golden/textbook");
}

#[test]
fn independently_computed_values_hold() {
    hold("tests/golden/values");
}

#[test]
fn what_breaks_other_programs_holds_here() {
    hold("tests/golden/breakers");
}
