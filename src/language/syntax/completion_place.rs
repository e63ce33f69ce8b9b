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
    /// The form in which an interpolated number is written, behind its colon.
    Format {
        /// Where it begins.
        start: usize,
        /// What is written.
        of: &'s str,
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
    if let Some(at) = open_text(&lexed) {
        // What is computed inside of a string is a name again.
        let code = open_code(source);
        if 0 < code {
            return format_of(&source[code..])
                .unwrap_or_else(|| place(&source[code..]))
                .shifted(code);
        }
        let label = (at > 1 && lexed.token(at - 1) == Token::Equals).then(|| lexed.text(at - 2));
        let start = lexed.span(at).range().start + 1;
        return CompletionPlace::Text { start, call: called(&lexed, at), label };
    }
    let last = lexed.tokens.len().saturating_sub(2);
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
            Self::Name { start }
            | Self::Field { start, .. }
            | Self::Text { start, .. }
            | Self::Format { start, .. } => *start += n_bytes,
            Self::Comment => {}
        }
        self
    }
}

/// The token of the string that is open at the end: one bad token up to the end of its line.
fn open_text(lexed: &Lexed<'_>) -> Option<usize> {
    let last = lexed.tokens.len().checked_sub(2)?;
    (lexed.token(last) == Token::Bad && lexed.text(last).starts_with('"')).then_some(last)
}

/// Where the code begins that is open at the end of a text: behind the brace of an interpolation, else at 0.
///
/// ```
/// use virote_language::syntax::open_code;
///
/// assert_eq!(open_code("print \"{a} and {max(b, "), 16);
/// assert_eq!(open_code("print max(b, "), 0);
/// ```
#[must_use]
pub fn open_code(source: &str) -> usize {
    let lexed = lex(source, 0);
    let Some(start) = open_text(&lexed).map(|at| lexed.span(at).range().start) else { return 0 };
    open_brace(&source[start..]).map_or(0, |brace| start + brace + 1)
}

/// The place behind the colon of an interpolation whose code is `source`, if there is one.
fn format_of(source: &str) -> Option<CompletionPlace<'_>> {
    let lexed = lex(source, 0);
    let colon = lexed
        .outside_brackets(0..lexed.tokens.len())
        .find(|&at| lexed.token(at) == Token::Colon)?;
    let colon = lexed.span(colon).range();
    Some(CompletionPlace::Format { start: colon.end, of: source[..colon.start].trim() })
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
pub(super) fn operand_start(lexed: &Lexed<'_>, last: usize) -> usize {
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
        assert_eq!(place("print \"{p.w:.3"), CompletionPlace::Format { start: 12, of: "p.w" });
        assert_eq!(place("print \"{f({a: b"), CompletionPlace::Name { start: 14 });
        assert_eq!(
            place("interpolate(p, ends = \"nat"),
            CompletionPlace::Text { start: 23, call: Some("interpolate"), label: Some("ends") }
        );
    }
}
