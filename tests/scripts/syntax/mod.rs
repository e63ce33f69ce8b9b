//! Text to tree and back: what scripts mean, what mistakes are told, and that nothing breaks it.

#![expect(clippy::panic, clippy::unwrap_used, reason = "a test fails by a panic")]

mod grammar;
mod meaning;
mod mistakes;
mod robustness;
mod round_trip;
mod trees;

use virote::diag::Diagnostic;
use virote::limits::Limits;
use virote::syntax::ast::Tree;

/// The tree of `source` and its diagnostics, under the usual limits.
fn parse(source: &str) -> (Tree<'_>, Vec<Diagnostic>) {
    virote::syntax::parse(source, &Limits::DEFAULT)
}

/// The tree of a script without mistakes.
#[track_caller]
fn parse_clean(source: &str) -> Tree<'_> {
    let (tree, diagnostics) = parse(source);
    assert!(diagnostics.is_empty(), "{source}\n{diagnostics:#?}");
    tree
}

/// The tree without places, to be compared.
fn shape(tree: &Tree<'_>) -> String {
    let text = format!("{tree:?}");
    let mut parts = text.split("Span { start: ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |shape, part| shape + part.split_once('}').map_or("", |(_, rest)| rest))
}

/// Scripts of all sorts, by name.
fn scripts() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scripts/syntax/scripts");
    let mut scripts: Vec<(String, String)> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.display().to_string(), std::fs::read_to_string(path).unwrap()))
        .collect();
    scripts.sort();
    scripts
}
