//! Lines of data files, which end with `\n`, `\r\n` or `\r`.

/// The lines of a text without their ends; a last one that is empty is none.
pub(super) fn lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let line = &rest[..end];
        let after = &rest[end..];
        let n_end = if after.starts_with("\r\n") { 2 } else { 1 };
        rest = after.get(n_end..).unwrap_or_default();
        Some(line)
    })
}

#[cfg(test)]
mod tests {
    use super::lines;

    #[test]
    fn each_line_ends_in_its_own_way() {
        let found: Vec<&str> = lines("a\r\nb\rc\n\n\r d").collect();
        assert_eq!(found, ["a", "b", "c", "", "", " d"]);
        assert_eq!(lines("a\n").count(), 1);
        assert_eq!(lines("").count(), 0);
    }
}
