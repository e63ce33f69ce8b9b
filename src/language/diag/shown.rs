//! Text of unknown origin as it may stand on a terminal.

use std::borrow::Cow;

/// Whether a character would act on a terminal rather than stand there: controls but line breaks
/// and tabulators, and those that turn the direction of writing.
#[must_use]
pub fn is_hidden(c: char) -> bool {
    let turns =
        matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c == '\u{feff}' || (c.is_control() && c != '\n' && c != '\t')
}

/// The text with what is hidden spelled as a script spells it: `\u{1b}`.
#[must_use]
pub fn shown(text: &str) -> Cow<'_, str> {
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            // Half of a line break.
            '\r' if rest.peek() == Some(&'\n') => out.push(c),
            c if is_hidden(c) => out.push_str(&format!("\\u{{{:x}}}", u32::from(c))),
            c => out.push(c),
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn escape_sequences_are_spelled_out() {
        assert_eq!(shown("\x1b[31mred\x07\u{9b}2J"), "\\u{1b}[31mred\\u{7}\\u{9b}2J");
        assert_eq!(shown("a\r\nb\tc — ä"), "a\r\nb\tc — ä");
        assert_eq!(shown("a\rb"), "a\\u{d}b");
    }
}
