//! Names of definitions, layers and groups as formats of lines can hold them.

/// A name that stands on the rest of a line: whatever a reader may take for the end of it is a space.
pub(super) fn one_line(name: &str) -> String {
    let is_plain = |c: char| !c.is_control() && !matches!(c, '\u{2028}' | '\u{2029}');
    name.chars().map(|c| if is_plain(c) { c } else { ' ' }).collect()
}

/// A name that is one word, as in OBJ: there white space ends it, `#` begins a comment, and a line goes
/// on after a backslash.
pub(super) fn word(name: &str) -> String {
    let is_plain = |c: char| !c.is_whitespace() && !c.is_control() && !matches!(c, '#' | '\\');
    let word: String = name.chars().map(|c| if is_plain(c) { c } else { '_' }).collect();
    if word.is_empty() { "unnamed".to_owned() } else { word }
}

#[cfg(test)]
mod tests {
    use super::{one_line, word};

    #[test]
    fn no_name_ends_its_line() {
        let hostile = "a\"b\nc\r\u{85}\u{2028}d\\\t#\u{0}é🦆\\";
        assert_eq!(one_line(hostile), "a\"b c   d\\ # é🦆\\");
        assert_eq!(word(hostile), "a\"b_c___d____é🦆_");
        assert_eq!((word(""), one_line("")), ("unnamed".to_owned(), String::new()));
    }
}
