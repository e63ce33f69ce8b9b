//! The written grammars and the program know the same words.

use std::collections::BTreeSet;

use serde_json::Value;

use virote::syntax::KEYWORDS;
use virote::syntax::ast::{Kind, Unit};

const GRAMMAR: &str = include_str!("../../../grammar/virote.ebnf");
const TEXT_MATE: &str = include_str!("../../../grammar/virote.tmLanguage.json");
const TREE_SITTER: &str = include_str!("../../../grammar/tree-sitter-virote/grammar.js");
const HIGHLIGHTS: &str = include_str!("../../../grammar/tree-sitter-virote/queries/highlights.scm");

/// Words that mean something in one place only and may be names elsewhere, units aside.
const CONTEXTUAL: [&str; 10] =
    ["all", "error", "expect", "face", "faces", "region", "regions", "solid", "solids", "step"];

type Words<'a> = BTreeSet<&'a str>;

fn keywords() -> Words<'static> {
    let known: Words<'_> = KEYWORDS.iter().copied().collect();
    assert_eq!(known.len(), KEYWORDS.len(), "no keyword twice");
    known
}

fn units() -> Words<'static> {
    Unit::ALL.iter().map(|&(name, _)| name).collect()
}

/// The words in quotes of this kind.
fn quoted(text: &str, quote: char) -> Words<'_> {
    let is_word = |word: &&str| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase());
    text.split(quote).skip(1).step_by(2).filter(is_word).collect()
}

/// The rules of the EBNF without comments.
fn rules() -> String {
    GRAMMAR.split("(*").map(|part| part.split_once("*)").map_or(part, |p| p.1)).collect()
}

#[test]
fn the_grammar_quotes_exactly_the_keywords() {
    let rules = rules();
    let is_word = |word: &&str| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase());
    let found: Words<'_> = rules.split('"').filter(is_word).collect();
    assert_eq!(found, keywords());
}

#[test]
fn every_rule_of_the_grammar_is_used() {
    let rules = rules();
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

/// The list `const NAME = [...]` of the tree-sitter grammar.
fn list(name: &str) -> Words<'static> {
    let start = format!("const {name} = [");
    let behind = TREE_SITTER.split_once(&start).map_or("", |(_, behind)| behind);
    quoted(behind.split_once(']').map_or("", |(list, _)| list), '"')
}

#[test]
fn the_tree_sitter_grammar_lists_exactly_the_keywords_and_units() {
    let kinds: Words<'_> =
        Kind::ALL.iter().map(|&(word, _)| word).filter(|word| *word != "let").collect();
    assert_eq!(&list("KINDS") | &list("WORD_KINDS"), kinds);
    let kinds = list("KINDS");
    assert_eq!(&list("KEYWORDS") | &kinds, keywords());
    assert_eq!(&list("LENGTHS") | &list("ANGLES"), units());
}

#[test]
fn highlighting_colours_every_keyword_and_nothing_that_the_tree_lacks() {
    let text: String = HIGHLIGHTS.lines().filter(|line| !line.starts_with(';')).collect();
    let coloured = &quoted(&text, '"') - &CONTEXTUAL.into();
    // These are nodes of their own.
    let nodes: Words<'_> = ["true", "false", "none"].into();
    assert_eq!(coloured, &(&keywords() - &list("KINDS")) - &nodes);
    for node in text.split('(').skip(1) {
        let name = node.split(|c: char| !c.is_ascii_lowercase() && c != '_').next().unwrap();
        let is_node = [format!(" {name}: ("), format!("$.{name})"), format!("$.{name},")]
            .iter()
            .any(|form| TREE_SITTER.contains(form));
        assert!(name.is_empty() || is_node, "`{name}` is no node");
    }
}

/// Calls `visit` with every object inside of `value`.
fn walk<'a>(value: &'a Value, visit: &mut impl FnMut(&'a serde_json::Map<String, Value>)) {
    match value {
        Value::Object(object) => {
            visit(object);
            object.values().for_each(|inner| walk(inner, visit));
        }
        Value::Array(items) => items.iter().for_each(|inner| walk(inner, visit)),
        _ => {}
    }
}

/// A regular expression without what is escaped of brackets, and what stands in square ones.
fn without_classes(pattern: &str) -> String {
    let escaped = [r"\\", r"\(", r"\)", r"\[", r"\]"];
    let plain = escaped.iter().fold(pattern.to_owned(), |text, mark| text.replace(mark, ""));
    plain.split('[').map(|part| part.split_once(']').map_or(part, |p| p.1)).collect()
}

#[test]
fn the_text_mate_grammar_is_whole_and_knows_exactly_the_keywords_and_units() {
    let grammar: Value = serde_json::from_str(TEXT_MATE).unwrap();
    let mut patterns = Vec::new();
    walk(&grammar, &mut |object| {
        if let Some(include) = object.get("include") {
            let name = include.as_str().unwrap().strip_prefix('#').unwrap();
            assert!(grammar["repository"].get(name).is_some(), "`{name}` is included, not there");
        }
        let all = ["match", "begin", "end"].map(|key| object.get(key).and_then(Value::as_str));
        assert_eq!(all[1].is_some(), all[2].is_some(), "{object:?}");
        patterns.extend(all.into_iter().flatten());
    });
    let patterns: Vec<String> = patterns.into_iter().map(without_classes).collect();
    for pattern in &patterns {
        assert_eq!(pattern.matches('(').count(), pattern.matches(')').count(), "{pattern}");
    }
    let text = patterns.join(" ").replace(r"\b", " ").replace(r"\s", " ");
    let is_word = |word: &&str| {
        word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase()) || *word == "m"
    };
    let words: Words<'_> =
        text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(is_word).collect();
    assert_eq!(words, &(&keywords() | &units()) | &CONTEXTUAL.into());
}
