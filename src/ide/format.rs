//! The canonical form as edits of lines, so that cursors and marks elsewhere stay.

use std::ops::Range;

use super::{LineIndex, TextEdit};
use crate::session::Session;

/// The edits that bring a text into canonical form; none where it has that form or does not parse.
#[must_use]
pub fn formatted(session: &Session, text: &str) -> Vec<TextEdit> {
    match session.format("", text.as_bytes()) {
        Ok(new) => between(text, &new),
        Err(_) => Vec::new(),
    }
}

/// Those of them that concern these lines.
#[must_use]
pub fn formatted_lines(session: &Session, text: &str, lines: &Range<usize>) -> Vec<TextEdit> {
    let index = LineIndex::new(text);
    let start = index.line(lines.start, text).start;
    let end = index.line(lines.end.max(lines.start + 1) - 1, text).end;
    let mut edits = formatted(session, text);
    edits.retain(|edit| start <= edit.range.start && edit.range.end <= end);
    edits
}

/// The lines in which two texts differ: runs of lines that both have, in order, are kept, as far as they
/// are found from the front of each difference.
fn between(old: &str, new: &str) -> Vec<TextEdit> {
    /// Lines ahead in which the two are looked for to meet again.
    const WINDOW: usize = 64;
    let split = |text: &'_ str| -> Vec<Range<usize>> {
        let mut at = 0;
        text.split_inclusive('\n')
            .map(|line| {
                at += line.len();
                at - line.len()..at
            })
            .collect()
    };
    let (old_lines, new_lines) = (split(old), split(new));
    let same = |i: usize, j: usize| match (old_lines.get(i), new_lines.get(j)) {
        (Some(a), Some(b)) => old[a.clone()] == new[b.clone()],
        (None, None) => true,
        _ => false,
    };
    let start_of = |lines: &[Range<usize>], idx: usize, text: &str| {
        lines.get(idx).map_or(text.len(), |line| line.start)
    };
    let (mut i, mut j, mut edits) = (0, 0, Vec::new());
    while i < old_lines.len() || j < new_lines.len() {
        if same(i, j) && i < old_lines.len() {
            (i, j) = (i + 1, j + 1);
            continue;
        }
        // The nearest lines at which both go on alike; blank lines are everywhere.
        let meets = |skip: usize| {
            (0..=skip).map(move |a| (a, skip - a)).find(|&(a, b)| {
                let (i, j) = (i + a, j + b);
                i <= old_lines.len()
                    && j <= new_lines.len()
                    && same(i, j)
                    && old_lines.get(i).is_none_or(|line| !old[line.clone()].trim().is_empty())
            })
        };
        let (a, b) =
            (1..=2 * WINDOW).find_map(meets).unwrap_or((old_lines.len() - i, new_lines.len() - j));
        // As many lines as before: each is an edit of its own.
        let parts = if a == b { (0..a).map(|k| (k, 1, 1)).collect() } else { vec![(0, a, b)] };
        for (k, a, b) in parts.into_iter().filter(|&(k, a, b)| a != b || !same(i + k, j + k)) {
            let range = start_of(&old_lines, i + k, old)..start_of(&old_lines, i + k + a, old);
            let new_range = start_of(&new_lines, j + k, new)..start_of(&new_lines, j + k + b, new);
            edits.push(TextEdit { range, text: new[new_range].to_owned() });
        }
        (i, j) = (i + a, j + b);
    }
    edits
}

#[cfg(test)]
mod tests {
    use super::between;
    use crate::ide::applied;

    #[test]
    fn edits_lead_from_one_text_to_the_other_and_touch_little() {
        let old = "a\nb\nc\nd\ne\n";
        for new in
            ["a\nb\nc\nd\ne\n", "a\nX\nc\nd\ne\n", "b\nc\nd\ne\nf\n", "", "a\nb\nb2\nc\ne", "x"]
        {
            assert_eq!(applied(old, &between(old, new)), new);
            assert_eq!(applied(new, &between(new, old)), old);
        }
        let edits = between(old, "a\nX\nc\nd\ne\n");
        assert_eq!((edits.len(), edits[0].range.clone(), edits[0].text.as_str()), (1, 2..4, "X\n"));
    }
}
