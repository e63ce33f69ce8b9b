//! What a script calls an element of a list that it hands to an operation.

use super::Ctx;
use crate::diag::Span;

/// The longest name that a message repeats.
const LONGEST: usize = 24;

impl Ctx<'_> {
    /// The name of an element of a list, quoted, and where it stands: `guides[2]` of a list that
    /// has a name, `sheer` of one that is written out, else of the parameter.
    #[must_use]
    pub fn element(&self, list: Span, index: usize, parameter: &str) -> (String, Span) {
        let fallback = (format!("`{parameter}[{index}]`"), list);
        let Some(source) = self.sources.and_then(|sources| sources.at(list)) else {
            return fallback;
        };
        let range = source.local(list);
        let text = &source.text[range.clone()];
        let is_name = |text: &str| {
            text.len() <= LONGEST
                && text.starts_with(|c: char| c.is_alphabetic() || c == '_')
                && text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '.')
        };
        if is_name(text) {
            return (format!("`{text}[{index}]`"), list);
        }
        let Some(part) = written_out(text).and_then(|parts| parts.into_iter().nth(index)) else {
            return fallback;
        };
        let base = source.base + range.start as u32;
        let span = Span::new(base + part.start as u32, base + part.end as u32);
        let own = &text[part];
        let is_short = own.len() <= LONGEST && !own.contains('\n');
        (if is_short { format!("`{own}`") } else { fallback.0 }, span)
    }
}

/// Where the elements of a list stand in its text, if each is written there.
fn written_out(text: &str) -> Option<Vec<std::ops::Range<usize>>> {
    let inner = text.strip_prefix('[')?.strip_suffix(']')?;
    let is_comprehension = inner
        .trim_start()
        .strip_prefix("for")
        .is_some_and(|rest| rest.starts_with(|c: char| c.is_whitespace() || c == '('));
    // Comments and texts could hide a comma.
    let is_plain = !["...", "//", "/*", "\"", "`"].iter().any(|mark| inner.contains(mark));
    if is_comprehension || !is_plain {
        return None;
    }
    let mut depth = 0_i32;
    let mut cuts = vec![0];
    for (at, c) in text.char_indices() {
        match c {
            '[' | '(' | '{' => depth += 1,
            ']' | ')' | '}' => depth -= 1,
            ',' if depth == 1 => cuts.push(at),
            _ => {}
        }
    }
    cuts.push(text.len() - 1);
    let trimmed = |ends: &[usize]| {
        let own = &text[ends[0] + 1..ends[1]];
        let start = ends[0] + 1 + (own.len() - own.trim_start().len());
        start..start + own.trim().len()
    };
    let parts: Vec<_> = cuts.windows(2).map(trimmed).collect();
    Some(parts.into_iter().filter(|part| !part.is_empty()).collect())
}

#[cfg(test)]
mod tests {
    use super::written_out;

    #[test]
    fn elements_are_found_where_they_are_written() {
        let found = |text: &'static str| {
            let parts = written_out(text)?;
            Some(parts.into_iter().map(|part| &text[part]).collect::<Vec<_>>())
        };
        assert_eq!(
            found("[sheer, line((0, 0), (1, 0)) , keel,]").unwrap(),
            ["sheer", "line((0, 0), (1, 0))", "keel"]
        );
        assert_eq!(found("[größe]").unwrap(), ["größe"]);
        assert_eq!(found("[]").unwrap(), [""; 0]);
        assert_eq!(found("[for k in 0..3: c[k]]"), None);
        assert_eq!(found("[...a, b]"), None);
        assert_eq!(found("curves"), None);
    }
}
