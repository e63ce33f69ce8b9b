//! Comments between `/*` and `*/`, which hold others.

use logos::{FilterResult, Lexer, Logos};

/// Takes a comment that began with `/*` to the `*/` of its own, or to the end of the text.
pub(super) fn block_comment<'s, T: Logos<'s, Source = str>>(
    lexer: &mut Lexer<'s, T>,
) -> FilterResult<(), ()> {
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

/// Whether a comment that begins with `/*` ends.
pub(super) fn is_closed(comment: &str) -> bool {
    comment_len(&comment[2..]).is_some()
}
