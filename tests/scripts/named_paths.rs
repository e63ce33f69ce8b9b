//! Files that the documentation names.

use std::{fs, path::Path};

/// Texts for whoever works on the code.
const TEXTS: &[&str] = &[
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "README.md",
    "src/kernel/README.md",
    "src/language/README.md",
];

/// Files that a text tells the reader to write.
const TO_BE_WRITTEN: &[&str] = &["src/language/ops/measure/curve/chord.rs"];

#[test]
fn files_that_the_documentation_names_are_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut n_named = 0;
    let mut missing = Vec::new();
    for text in TEXTS {
        let content = fs::read_to_string(root.join(text)).unwrap();
        for quoted in content.split('`').skip(1).step_by(2) {
            let is_path = ["src/", "tests/", "docs/", "examples/", "grammar/", ".ci/", ".cargo/"]
                .iter()
                .any(|folder| quoted.starts_with(folder));
            let is_pattern = quoted.contains(|c: char| c.is_ascii_uppercase() || " *{".contains(c));
            if !is_path || is_pattern || TO_BE_WRITTEN.contains(&quoted) {
                continue;
            }
            n_named += 1;
            if !root.join(quoted).exists() {
                missing.push(format!("{text}: `{quoted}`"));
            }
        }
    }
    assert!(10 < n_named, "{n_named} paths were found");
    assert!(missing.is_empty(), "these are not there:\n{}", missing.join("\n"));
}
