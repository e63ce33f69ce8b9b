//! Habits from other languages: what they mean here.

use std::ops::Range;

use super::{super::token::Token, Scanner, offset};
use crate::diag::{Code, Diagnostic, Fix, Span};

/// Spellings of other languages: what they mean here, and what to do.
const FOREIGN: &[(&str, Token, &str)] = &[
    ("&&", Token::And, "write `and`"),
    ("&", Token::And, "write `and`"),
    ("||", Token::Or, "write `or`"),
    ("|", Token::Or, "write `or`, or `|>` to pass a value into a call"),
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

impl Scanner<'_> {
    /// A spelling of another language: told, and read as what it means here.
    pub(super) fn foreign(&mut self) {
        let (span, text) = (self.span(), self.lexer.slice());
        let known = FOREIGN.iter().find(|(spelling, ..)| *spelling == text);
        let Some(&(_, meant, hint)) = known else { return self.stray() };
        let (meant, hint) = match text {
            "|" if !self.out.tokens.last().is_some_and(|token| token.ends_expression()) => {
                return self.barred_function();
            }
            "|" if begins_call(&self.source[span.range().end..]) => (Token::Pipe, hint),
            "->" if is_function_head(&self.out.tokens) => {
                (Token::Equals, "a function is written `fn f(x) = x^2`")
            }
            _ => (meant, hint),
        };
        let diagnostic =
            Diagnostic::error(Code::StrayText, span, format!("`{text}` means nothing here"));
        let diagnostic = diagnostic.label("not part of the language").hint(hint);
        self.complain(match meant {
            _ if text == "°" => diagnostic.fix(degrees(self.source, self.out.spans.last(), span)),
            Token::Bad => diagnostic,
            meant => diagnostic.fix(Fix::replace(span, apart(self.source, span, meant.text()))),
        });
        if text != "°" {
            self.push(meant);
        }
    }

    /// `|x, y| x + y`, read as `(x, y) => x + y`.
    fn barred_function(&mut self) {
        let start = self.lexer.span().start;
        let Some((names, len)) = barred_names(&self.source[start..]) else {
            return self.stray();
        };
        self.lexer.bump(len - 1);
        let span = self.span();
        let text = self.lexer.slice();
        let list: Vec<&str> = names.iter().map(|name| &text[name.clone()]).collect();
        let meant = match &list[..] {
            [one] => format!("{one} =>"),
            _ => format!("({}) =>", list.join(", ")),
        };
        let found =
            Diagnostic::error(Code::StrayText, span, format!("`{text}` means nothing here"));
        let found =
            found.label("not part of the language").hint("a function is written `x => x^2`");
        self.complain(found.fix(Fix::replace(span, meant)));
        let at =
            |place: Range<usize>| Span::new(offset(start + place.start), offset(start + place.end));
        let mut tokens = vec![(Token::OpenParen, at(0..1))];
        for (idx, name) in names.iter().enumerate() {
            if 0 < idx {
                tokens.push((Token::Comma, at(name.start..name.start)));
            }
            tokens.push((Token::Name, at(name.clone())));
        }
        tokens.push((Token::CloseParen, at(len - 1..len - 1)));
        tokens.push((Token::Arrow, at(len - 1..len)));
        for (token, span) in tokens {
            self.out.tokens.push(token);
            self.out.spans.push(span);
        }
    }
}

/// The text that takes a place: a word with blanks to what stands beside it.
fn apart(source: &str, place: Span, text: &str) -> String {
    let is_word = text.ends_with(char::is_alphabetic);
    let touches = |beside: Option<char>, brackets: &str| {
        is_word && beside.is_some_and(|c| !c.is_whitespace() && !brackets.contains(c))
    };
    let before = source[..place.start as usize].chars().next_back();
    let behind = source[place.end as usize..].chars().next();
    let blank = |is_wanted: bool| if is_wanted { " " } else { "" };
    format!("{}{text}{}", blank(touches(before, "([{")), blank(touches(behind, ")]}")))
}

/// The names between the bars that a text begins with, `|x, y|`, and the length of all that; none where it is something
/// else.
fn barred_names(text: &str) -> Option<(Vec<Range<usize>>, usize)> {
    let inner = text[1..].find('|').map(|end| &text[1..=end])?;
    let mut names = Vec::new();
    let mut at = 1;
    for part in inner.split(',') {
        let name = part.trim();
        let is_name = name.starts_with(|c: char| c.is_alphabetic() || c == '_')
            && name.chars().all(|c| c.is_alphanumeric() || c == '_');
        if !is_name {
            return None;
        }
        let start = at + (part.len() - part.trim_start().len());
        names.push(start..start + name.len());
        at += part.len() + 1;
    }
    Some((names, inner.len() + 2))
}

/// Whether a text begins with a name and an opening bracket.
fn begins_call(text: &str) -> bool {
    let text = text.trim_start();
    let rest = text.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
    rest.len() < text.len() && rest.starts_with('(')
}

/// Whether the last tokens are `fn f(...)`.
fn is_function_head(tokens: &[Token]) -> bool {
    let mut depth = 0_usize;
    for at in (0..tokens.len()).rev() {
        match tokens[at] {
            Token::CloseParen => depth += 1,
            Token::OpenParen => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return 2 <= at && tokens[at - 2..=at] == [Token::Fn, Token::Name, Token::OpenParen];
        }
    }
    false
}

/// The sign of degrees as a unit, glued to the number before it.
fn degrees(source: &str, before: Option<&Span>, sign: Span) -> Fix {
    let is_blank = |number: &&Span| {
        let between = &source[number.end as usize..sign.start as usize];
        between.bytes().all(|byte| byte == b' ')
    };
    let start = before.filter(is_blank).map_or(sign.start, |number| number.end);
    Fix::replace(Span::new(start, sign.end), "deg")
}

#[cfg(test)]
mod tests {
    use super::{apart, barred_names};
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

    #[test]
    fn parameters_between_bars_are_found() {
        assert_eq!(barred_names("|x, yy| x"), Some((vec![1..2, 4..6], 7)));
        assert_eq!(barred_names("|x| x").map(|(names, end)| (names.len(), end)), Some((1, 3)));
        assert_eq!(
            (barred_names("|| x"), barred_names("|2| x"), barred_names("|x")),
            (None, None, None)
        );
    }
}
