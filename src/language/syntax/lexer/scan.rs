//! What a regular expression does not find: the ends of pieces of strings.

/// What ends a piece of a string.
pub(super) enum PieceEnd {
    Quote,
    Brace,
    Line,
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
