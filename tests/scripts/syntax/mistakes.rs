//! `mistakes.txt`: what people write by mistake, with the place and the words of each complaint.

use std::fmt::Write;

use virote::diag::Diagnostic;

use super::parse;

const MISTAKES: &str = include_str!("mistakes.txt");

#[test]
fn every_mistake_is_told_in_these_words_at_this_place() {
    let mut wrong = Vec::new();
    for case in MISTAKES.split("\n\n").filter(|case| case.starts_with("> ")) {
        let marked: Vec<&str> = case.lines().filter_map(|line| line.strip_prefix("> ")).collect();
        let marked = marked.join("\n");
        let source = marked.replace(['«', '»'], "");
        let (_, diagnostics) = parse(&source);
        let told = told(&source, &diagnostics);
        if told.trim_end() != case.trim_end() {
            wrong.push(told);
        }
    }
    assert!(wrong.is_empty(), "told otherwise:\n{}", wrong.join("\n"));
}

/// The case as it would be written.
fn told(source: &str, diagnostics: &[Diagnostic]) -> String {
    let mut marked = source.to_owned();
    for diagnostic in diagnostics.iter().rev() {
        let span = diagnostic.primary.span.range();
        marked.insert(span.end, '»');
        marked.insert(span.start, '«');
    }
    let mut out = String::new();
    for line in marked.lines() {
        let _ = writeln!(out, "> {line}");
    }
    for diagnostic in diagnostics {
        let label = &diagnostic.primary.text;
        let separator = if label.is_empty() { "" } else { " | " };
        let (id, message) = (diagnostic.code.id(), &diagnostic.message);
        let _ = writeln!(out, "{id} {message}{separator}{label}");
        for hint in &diagnostic.hints {
            let _ = writeln!(out, "  hint: {hint}");
        }
    }
    out
}

#[test]
fn a_comma_is_missing_between_two_places() {
    let (_, diagnostics) = parse("let s = [a b]");
    assert_eq!(diagnostics[0].others[0].span.range(), 11..12);
}

#[test]
fn a_crossed_bracket_shows_both() {
    let (_, diagnostics) = parse("let s = f(1]");
    assert_eq!(diagnostics[0].primary.span.range(), 11..12);
    assert_eq!(diagnostics[0].others[0].span.range(), 9..10);
}

#[test]
fn a_script_that_is_too_large_is_not_read() {
    let limits = virote::limits::Limits { source_bytes: 10, ..virote::limits::Limits::DEFAULT };
    let (tree, diagnostics) = virote::syntax::parse("let a = 1234", &limits);
    assert!(tree.statements.is_empty());
    assert_eq!(diagnostics[0].code.id(), "E0008");
}
