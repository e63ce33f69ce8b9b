//! What a script calls an element of a list that it hands to an operation.

use super::Ctx;
use crate::diag::{Diagnostic, Label, Sources, Span};

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

/// Where the element of a list stands to which a path of indices leads, as far as the list is
/// written out there.
pub(super) fn element_span(sources: Option<&Sources>, list: Span, path: &[usize]) -> Span {
    let Some(source) = sources.and_then(|sources| sources.at(list)) else { return list };
    let mut place = source.local(list);
    for &index in path {
        let parts = source.text.get(place.clone()).and_then(written_out);
        let Some(part) = parts.and_then(|parts| parts.into_iter().nth(index)) else { break };
        place = place.start + part.start..place.start + part.end;
    }
    Span::new(source.base + place.start as u32, source.base + place.end as u32)
}

/// The finding with its places at the elements that it is about, where they are written out.
#[must_use]
pub fn pointed(mut found: Box<Diagnostic>, sources: Option<&Sources>) -> Box<Diagnostic> {
    let list = found.primary.span;
    let is_row = |span: Span| {
        let source = sources.and_then(|sources| sources.at(span));
        source.is_some_and(|source| source.text[source.local(span)].starts_with('['))
    };
    let paths = std::mem::take(&mut found.elements);
    let places: Vec<Span> = paths.iter().map(|path| element_span(sources, list, path)).collect();
    // A row is not what an index counts.
    if places.iter().any(|&place| place == list || is_row(place)) {
        return found;
    }
    let label = |path: &[usize]| {
        format!("element {}", path.iter().map(|index| format!("[{index}]")).collect::<String>())
    };
    let pairs: Vec<(Span, String)> =
        places.into_iter().zip(&paths).map(|(place, path)| (place, label(path))).collect();
    let Some(((culprit, own), others)) = pairs.split_last() else { return found };
    found.primary.span = *culprit;
    if !others.is_empty() && found.primary.text.is_empty() {
        found.primary.text.clone_from(own);
    }
    found
        .others
        .extend(others.iter().map(|(span, text)| Label { span: *span, text: text.clone() }));
    found
}

/// Where the elements of a list stand in its text, if each is written there: in brackets, or as
/// arguments one after another.
fn written_out(text: &str) -> Option<Vec<std::ops::Range<usize>>> {
    let (inner, level) = match text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        Some(inner) => (inner, 1),
        None => (text, 0),
    };
    let is_comprehension = inner
        .trim_start()
        .strip_prefix("for")
        .is_some_and(|rest| rest.starts_with(|c: char| c.is_whitespace() || c == '('));
    // Comments and texts could hide a comma.
    let is_plain = !["...", "//", "/*", "\"", "`"].iter().any(|mark| inner.contains(mark));
    if is_comprehension || !is_plain {
        return None;
    }
    // Cuts go through the first byte before a part and the first behind it.
    let (mut depth, mut start) = (level, level);
    let mut parts = Vec::new();
    let mut cut = |start: usize, end: usize| {
        let own = &text[start..end];
        let first = start + (own.len() - own.trim_start().len());
        parts.push(first..first + own.trim().len());
    };
    for (at, c) in inner.char_indices().map(|(at, c)| (at + level, c)) {
        match c {
            '[' | '(' | '{' => depth += 1,
            // The first bracket is not the one of the whole.
            ']' | ')' | '}' if depth == level => return None,
            ']' | ')' | '}' => depth -= 1,
            ',' if depth == level => {
                cut(start, at);
                start = at + 1;
            }
            _ => {}
        }
    }
    if level == 0 && start == 0 {
        return None;
    }
    cut(start, level + inner.len());
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
        assert_eq!(found("(0, 0), p, q[1]").unwrap(), ["(0, 0)", "p", "q[1]"]);
        assert_eq!(found("(0, 0)"), None);
        assert_eq!(found("[p][0], q[1]"), None);
    }
}
