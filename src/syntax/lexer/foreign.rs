//! Habits from other languages: what they mean here.

use super::super::token::Token;

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
