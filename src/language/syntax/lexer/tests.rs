//! What the lexer makes of a text.

use super::lex;
use crate::syntax::token::Token;

/// The tokens of `source` by their texts, without the end.
#[track_caller]
fn check(source: &str, texts: &[&str]) {
    let lexed = lex(source, 1);
    let found: Vec<&str> = (0..lexed.tokens.len() - 1).map(|at| lexed.text(at)).collect();
    assert_eq!(found, texts);
    assert!(lexed.diagnostics.is_empty(), "{:?}", lexed.diagnostics);
}

#[test]
fn numbers_take_their_units_and_leave_ranges() {
    check("0..3", &["0", "..", "3"]);
    check("0..<3.5mm", &["0", "..<", "3.5mm"]);
    check("1e-3mm 10mn 2e", &["1e-3mm", "10mn", "2e"]);
    check("1_000.x", &["1_000", ".", "x"]);
}

#[test]
fn names_are_of_any_script() {
    check("größe _a _ π2", &["größe", "_a", "_", "π2"]);
}

#[test]
fn strings_come_in_pieces() {
    check(r#""a {x} {y}""#, &[r#""a {"#, "x", "} {", "y", r#"}""#]);
    check(r#""\{a}" "\"{b}""#, &[r#""\{a}""#, r#""\"{"#, "b", r#"}""#]);
    check(r#""{ {a} }""#, &[r#""{"#, "{", "a", "}", r#"}""#]);
}

#[test]
fn comments_nest_and_stand_aside() {
    check("a /* b /* c */ d */ e // f", &["a", "e"]);
    let comments = lex("/// a\nb //// c\n/* d */", 0).comments;
    let docs: Vec<(usize, bool)> = comments.iter().map(|c| (c.before, c.is_doc)).collect();
    assert_eq!(docs, [(0, true), (1, false), (1, false)]);
}

#[test]
fn only_what_begins_a_line_is_a_beginning() {
    let tokens = lex("(a (\n( /*\n*/ -[\n [", 0).tokens;
    let expected = [
        Token::LineParen,
        Token::Name,
        Token::OpenParen,
        Token::LineParen,
        Token::LineMinus,
        Token::OpenBracket,
        Token::LineBracket,
        Token::End,
    ];
    assert_eq!(tokens, expected);
}

#[test]
fn an_open_string_ends_with_its_line() {
    let lexed = lex("a \"b {c\nd", 5);
    assert_eq!(lexed.tokens, [Token::Name, Token::Bad, Token::Name, Token::End]);
    assert_eq!(lexed.diagnostics.len(), 1);
}
