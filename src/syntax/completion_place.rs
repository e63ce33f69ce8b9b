//! What stands around a place at which somebody types.

use super::{lexed::Lexed, lexer::lex, outline::opening, token::Token};

/// What stands around a place at which somebody types.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CompletionPlace<'s> {
    /// A name.
    Name {
        /// Where it begins.
        start: usize,
    },
    /// A name behind the dot after this expression.
    Field {
        /// Where it begins.
        start: usize,
        /// What stands before the dot, `a.b[0]` or `f(x)`.
        of: &'s str,
    },
    /// A string that begins behind this byte.
    Text {
        /// Where its content begins.
        start: usize,
        /// The call around it.
        call: Option<&'s str>,
        /// The label that it is the value of.
        label: Option<&'s str>,
    },
    /// A comment.
    Comment,
}

/// What stands around the end of a text.
#[must_use]
pub fn place(source: &str) -> CompletionPlace<'_> {
    let lexed = lex(source, 0);
    let end = source.len();
    if lexed.comments.iter().any(|comment| comment.span.range().end == end) {
        return CompletionPlace::Comment;
    }
    // An open string is one bad token up to the end of its line.
    let last = lexed.tokens.len().saturating_sub(2);
    let open_text = (lexed.tokens.len() > 1
        && lexed.token(last) == Token::Bad
        && lexed.text(last).starts_with('"'))
    .then_some(last);
    if let Some(at) = open_text {
        // What is computed inside of a string is a name again.
        let text = &source[lexed.span(at).range().start..];
        if let Some(brace) = open_brace(text) {
            return place(&text[brace + 1..]).shifted(source.len() - text.len() + brace + 1);
        }
        let label = (at > 1 && lexed.token(at - 1) == Token::Equals).then(|| lexed.text(at - 2));
        let start = lexed.span(at).range().start + 1;
        return CompletionPlace::Text { start, call: called(&lexed, at), label };
    }
    let is_word = lexed.tokens.len() > 1
        && (lexed.token(last).is_word() || lexed.token(last) == Token::Placeholder)
        && lexed.span(last).range().end == end;
    let at = if is_word { last } else { lexed.tokens.len() - 1 };
    let start = if is_word { lexed.span(last).range().start } else { end };
    if at > 1 && lexed.token(at - 1) == Token::Dot {
        let from = lexed.span(operand_start(&lexed, at - 2)).range().start;
        let of = &source[from..lexed.span(at - 2).range().end];
        return CompletionPlace::Field { start, of };
    }
    CompletionPlace::Name { start }
}

impl CompletionPlace<'_> {
    /// The same in a text with so many bytes before.
    fn shifted(mut self, n_bytes: usize) -> Self {
        match &mut self {
            Self::Name { start } | Self::Field { start, .. } | Self::Text { start, .. } => {
                *start += n_bytes;
            }
            Self::Comment => {}
        }
        self
    }
}

/// The brace of an interpolation that is open at the end of a string's text.
fn open_brace(text: &str) -> Option<usize> {
    let (mut open, mut is_escaped) = (Vec::new(), false);
    for (at, c) in text.char_indices() {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            '{' => open.push(at),
            '}' => {
                open.pop();
            }
            _ => {}
        }
    }
    open.first().copied()
}

/// Where what ends with token `last` begins: a name or brackets with fields, elements and calls behind.
fn operand_start(lexed: &Lexed<'_>, last: usize) -> usize {
    let mut at = last;
    loop {
        if lexed.token(at).closes() {
            let Some(open) = opening(lexed, at) else { return at };
            at = open;
            let is_behind = matches!(lexed.token(at), Token::OpenParen | Token::OpenBracket);
            match at.checked_sub(1) {
                Some(before) if is_behind && is_operand_end(lexed.token(before)) => at = before,
                _ => return at,
            }
        } else {
            match at.checked_sub(2) {
                Some(before) if lexed.token(at - 1) == Token::Dot => at = before,
                _ => return at,
            }
        }
    }
}

/// Whether a call or an element may stand behind.
fn is_operand_end(token: Token) -> bool {
    token.ends_expression() || token.names_built_in()
}

/// The name that is called in the innermost brackets around token `at`.
fn called<'s>(lexed: &Lexed<'s>, at: usize) -> Option<&'s str> {
    let before = opening(lexed, at)?.checked_sub(1)?;
    (lexed.token(before).is_word()).then(|| lexed.text(before))
}

#[cfg(test)]
mod tests {
    use super::{CompletionPlace, place};

    #[test]
    fn a_place_knows_what_is_around_it() {
        assert_eq!(place("let a = bez"), CompletionPlace::Name { start: 8 });
        assert_eq!(place("bezier(pts, wei"), CompletionPlace::Name { start: 12 });
        assert_eq!(place("c.deg"), CompletionPlace::Field { start: 2, of: "c" });
        for (text, of) in [
            ("let d = a.b.", "a.b"),
            ("1 + xs[i + 1].sta", "xs[i + 1]"),
            ("f(2, line(a, b).", "line(a, b)"),
            ("mesh(a, b).", "mesh(a, b)"),
            ("2 * (a + b).", "(a + b)"),
        ] {
            assert!(
                matches!(place(text), CompletionPlace::Field { of: found, .. } if found == of),
                "{text}"
            );
        }
        assert_eq!(place("print \"a {wi"), CompletionPlace::Name { start: 10 });
        assert_eq!(place("print \"{a} {p.w"), CompletionPlace::Field { start: 14, of: "p" });
        assert!(matches!(place("print \"{a} \\{b"), CompletionPlace::Text { .. }));
        assert_eq!(
            place("interpolate(p, ends = \"nat"),
            CompletionPlace::Text { start: 23, call: Some("interpolate"), label: Some("ends") }
        );
    }
}
