//! Characters that nobody can see, which a message must name by their code.

/// The code of a single character that nobody can see.
pub(super) fn code(text: &str) -> Option<String> {
    let mut chars = text.chars();
    let only = chars.next().filter(|_| chars.next().is_none())?;
    let is_unseen = only.is_control()
        || matches!(only, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
    is_unseen.then(|| format!("U+{:04X}", u32::from(only)))
}

#[cfg(test)]
mod tests {
    use super::code;

    #[test]
    fn what_cannot_be_seen_has_a_code() {
        assert_eq!(code("\u{200b}").as_deref(), Some("U+200B"));
        assert_eq!(code("\u{7}").as_deref(), Some("U+0007"));
        assert_eq!([code("?"), code("é"), code("ab"), code("")], [None, None, None, None]);
    }
}
