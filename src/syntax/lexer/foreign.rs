//! Habits from other languages: what they mean here.

use super::super::token::Token;
use crate::diag::{Fix, Span};

/// Spellings of other languages: what they mean here, and what to do.
pub(super) const FOREIGN: &[(&str, Token, &str)] = &[
    ("&&", Token::And, "write `and`"),
    ("&", Token::And, "write `and`"),
    ("||", Token::Or, "write `or`"),
    ("|", Token::Pipe, "write `or`, or `|>` to pass a value into a call"),
    ("!", Token::Not, "write `not`"),
    (":=", Token::Equals, "write `=`"),
    ("->", Token::Arrow, "a function is written `x => x^2`"),
    ("**", Token::Caret, "a power is written `a^b`"),
    ("<>", Token::NotEqual, "write `!=`"),
    ("===", Token::Equal, "write `==`"),
    ("+=", Token::Bad, "there is no assignment: give the new value a name of its own"),
    ("-=", Token::Bad, "there is no assignment: give the new value a name of its own"),
    ("°", Token::Bad, "write `deg`, glued to the number: `45deg`"),
    ("−", Token::Minus, "write the minus of the keyboard: `-`"),
    ("×", Token::Star, "write `*`"),
    ("·", Token::Star, "write `*`, or `dot(a, b)`"),
    ("÷", Token::Slash, "write `/`"),
    ("≤", Token::LessEqual, "write `<=`"),
    ("≥", Token::GreaterEqual, "write `>=`"),
    ("≠", Token::NotEqual, "write `!=`"),
    ("≈", Token::Near, "write `~=`"),
    ("…", Token::Range, "write `..` for a range, `...` to spread a list"),
];

/// The text that takes a place: a word with blanks to what stands beside it.
pub(super) fn apart(source: &str, place: Span, text: &str) -> String {
    let is_word = text.ends_with(char::is_alphabetic);
    let touches = |beside: Option<char>, brackets: &str| {
        is_word && beside.is_some_and(|c| !c.is_whitespace() && !brackets.contains(c))
    };
    let before = source[..place.start as usize].chars().next_back();
    let behind = source[place.end as usize..].chars().next();
    let blank = |is_wanted: bool| if is_wanted { " " } else { "" };
    format!("{}{text}{}", blank(touches(before, "([{")), blank(touches(behind, ")]}")))
}

/// The sign of degrees as a unit, glued to the number before it.
pub(super) fn degrees(source: &str, before: Option<&Span>, sign: Span) -> Fix {
    let is_blank = |number: &&Span| {
        let between = &source[number.end as usize..sign.start as usize];
        between.bytes().all(|byte| byte == b' ')
    };
    let start = before.filter(is_blank).map_or(sign.start, |number| number.end);
    Fix::replace(Span::new(start, sign.end), "deg")
}

#[cfg(test)]
mod tests {
    use super::apart;
    use crate::diag::Span;

    #[test]
    fn words_stand_apart_from_what_is_beside_them() {
        let at = |source: &str, foreign: &str, text: &str| {
            let start = source.find(foreign).unwrap_or_default() as u32;
            let place = Span::new(start, start + foreign.len() as u32);
            source.replacen(foreign, &apart(source, place, text), 1)
        };
        assert_eq!(at("let a = !b", "!", "not"), "let a = not b");
        assert_eq!(at("f(!b)", "!", "not"), "f(not b)");
        assert_eq!(at("a&&b", "&&", "and"), "a and b");
        assert_eq!(at("a && b", "&&", "and"), "a and b");
        assert_eq!(at("(a)||(b)", "||", "or"), "(a) or (b)");
        assert_eq!(at("a**b", "**", "^"), "a^b");
    }
}
