//! What a regular expression does not find: the ends of nested comments and of pieces of strings.

use logos::{FilterResult, Lexer};

use super::super::token::Token;

/// What ends a piece of a string.
pub(super) enum PieceEnd {
    Quote,
    Brace,
    Line,
}

/// Takes a comment that began with `/*` to the `*/` of its own, or to the end of the text.
pub(in crate::syntax) fn block_comment(lexer: &mut Lexer<'_, Token>) -> FilterResult<(), ()> {
    let len = comment_len(lexer.remainder()).unwrap_or(lexer.remainder().len());
    lexer.bump(len);
    FilterResult::Emit(())
}

/// Bytes up to and with the `*/` that closes the comment around `rest`.
fn comment_len(rest: &str) -> Option<usize> {
    let bytes = rest.as_bytes();
    let (mut at, mut depth) = (0, 1);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => depth += 1,
            b"*/" => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

pub(super) fn is_closed(comment: &str) -> bool {
    comment_len(&comment[2..]).is_some()
}

/// The length of the piece of a string that begins with `rest`, its end mark included.
pub(super) fn piece(rest: &str) -> (usize, PieceEnd) {
    let bytes = rest.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        match bytes[at] {
            b'\n' => return (at, PieceEnd::Line),
            b'"' => return (at + 1, PieceEnd::Quote),
            b'{' => return (at + 1, PieceEnd::Brace),
            b'\\' if bytes[at + 1..].starts_with(b"u{") => at += 3,
            b'\\' if bytes.get(at + 1).is_some_and(|&b| b != b'\n') => at += 2,
            _ => at += 1,
        }
    }
    (bytes.len(), PieceEnd::Line)
}
