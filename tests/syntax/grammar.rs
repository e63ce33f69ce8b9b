//! The written grammar and the program know the same keywords.

use std::collections::BTreeSet;

use virote::syntax::KEYWORDS;

const GRAMMAR: &str = include_str!("../../grammar/virote.ebnf");

#[test]
fn the_grammar_quotes_exactly_the_keywords() {
    let rules: String =
        GRAMMAR.split("(*").map(|part| part.split_once("*)").map_or(part, |p| p.1)).collect();
    let quoted: BTreeSet<&str> = rules
        .split('"')
        .filter(|word| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase()))
        .collect();
    let known: BTreeSet<&str> = KEYWORDS.iter().copied().collect();
    assert_eq!(quoted, known);
    assert_eq!(known.len(), KEYWORDS.len(), "no keyword twice");
}

#[test]
fn every_rule_of_the_grammar_is_used() {
    let rules: String =
        GRAMMAR.split("(*").map(|part| part.split_once("*)").map_or(part, |p| p.1)).collect();
    let names: Vec<&str> = rules
        .split(';')
        .filter_map(|rule| rule.split_once(" = "))
        .map(|(name, _)| name.trim())
        .collect();
    for name in names.iter().filter(|name| !matches!(**name, "script" | "white space" | "comment"))
    {
        let uses = rules.matches(name).count();
        assert!(uses > 1, "`{name}` is defined and never used");
    }
}
