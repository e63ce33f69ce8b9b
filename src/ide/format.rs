//! The canonical form as edits, so that cursors and marks elsewhere stay.
//!
//! The formatter keeps the statements and comments of a text in their order. Where the same number of both stands before
//! a line of the old text and before one of the new, the two texts can be cut: what lies between two cuts is one
//! [`Chunk`], which is replaced as a whole or not at all.

use std::{collections::BTreeMap, ops::Range};

use super::{LineIndex, TextEdit};
use crate::{
    kernel::sorting::sort_by_key,
    session::Session,
    syntax::{self, Highlight},
};

/// The edits that bring a text into canonical form; none where it has that form or does not parse.
#[must_use]
pub fn formatted(session: &Session, text: &str) -> Vec<TextEdit> {
    let Ok(new) = session.format("", text.as_bytes()) else { return Vec::new() };
    chunks(session, text, &new).iter().filter_map(|chunk| chunk.edit(text, &new)).collect()
}

/// Those of them that concern whole statements, comments and blank lines which touch these lines.
#[must_use]
pub fn formatted_lines(session: &Session, text: &str, lines: &Range<usize>) -> Vec<TextEdit> {
    let Ok(new) = session.format("", text.as_bytes()) else { return Vec::new() };
    let index = LineIndex::new(text);
    // Line breaks are part of their lines.
    let start = index.line(lines.start, text).start;
    let end = index.line(lines.end.max(lines.start + 1) - 1, text).end;
    let touches = |chunk: &Chunk| {
        let is_at_end = chunk.old.start == text.len() && end == text.len();
        let reaches = start <= chunk.old.start || start < chunk.old.end;
        is_at_end || chunk.old.start < end && reaches
    };
    let chunks = chunks(session, text, &new);
    let touched = chunks.iter().filter(|chunk| touches(chunk));
    touched.filter_map(|chunk| chunk.edit(text, &new)).collect()
}

/// Whole lines of a text, and those of its canonical form that say the same.
#[derive(Debug)]
struct Chunk {
    old: Range<usize>,
    new: Range<usize>,
}

impl Chunk {
    /// The edit that makes the new lines of the old ones: lines that both begin or end with stay.
    fn edit(&self, old: &str, new: &str) -> Option<TextEdit> {
        let (before, after) = (&old[self.old.clone()], &new[self.new.clone()]);
        if before == after {
            return None;
        }
        let alike = |(a, b): &(&str, &str)| a == b;
        let length = |(line, _): (&str, &str)| line.len();
        let [a, b] = [before, after].map(|text| text.split_inclusive('\n'));
        let head: usize = a.zip(b).take_while(alike).map(length).sum();
        let [a, b] = [before, after].map(|text| text[head..].split_inclusive('\n').rev());
        let tail: usize = a.zip(b).take_while(alike).map(length).sum();
        Some(TextEdit {
            range: self.old.start + head..self.old.end - tail,
            text: after[head..after.len() - tail].to_owned(),
        })
    }
}

/// A text and its canonical form, cut alike.
fn chunks(session: &Session, old: &str, new: &str) -> Vec<Chunk> {
    let cuts_of_new = cuts(session, new);
    let mut chunks = Vec::new();
    let (mut i, mut j) = (0, 0);
    let mut cut = |at: usize, new_at: usize| {
        chunks.push(Chunk { old: i..at, new: j..new_at });
        (i, j) = (at, new_at);
    };
    for (before, gap) in cuts(session, old) {
        if let Some(new_gap) = cuts_of_new.get(&before) {
            cut(gap.start, new_gap.start);
            cut(gap.end, new_gap.end);
        }
    }
    cut(old.len(), new.len());
    chunks
}

/// The lines without statements and comments before and behind which a text can be cut, which may be none, by the
/// number of statements and of comments before them.
fn cuts(session: &Session, text: &str) -> BTreeMap<(usize, usize), Range<usize>> {
    let comments =
        syntax::pieces(text).into_iter().filter(|(paint, _)| *paint == Highlight::Comment);
    let mut items: Vec<(Range<usize>, bool)> = comments.map(|(_, range)| (range, true)).collect();
    let statements: Vec<Range<usize>> =
        session.tree(text, |tree, _| tree.statements.iter().map(|one| one.span.range()).collect());
    items.extend(statements.into_iter().map(|range| (range, false)));
    sort_by_key(&mut items, |(range, _)| range.start);
    let mut cuts = BTreeMap::new();
    let (mut n_statements, mut n_comments, mut end) = (0, 0, 0);
    for (range, is_comment) in items {
        // Inside of a statement there is no gap.
        if let Some(gap) = text.get(end..range.start) {
            let first = if end == 0 { Some(0) } else { gap.find('\n').map(|at| end + at + 1) };
            if let Some(first) = first {
                let last = gap.rfind('\n').map_or(first, |at| end + at + 1);
                cuts.insert((n_statements, n_comments), first..last);
            }
        }
        end = end.max(range.end);
        if is_comment {
            n_comments += 1;
        } else {
            n_statements += 1;
        }
    }
    if let Some(first) = text[end..].find('\n').map(|at| end + at + 1) {
        cuts.insert((n_statements, n_comments), first..text.len());
    }
    cuts
}

#[cfg(test)]
mod tests {
    use super::{formatted, formatted_lines};
    use crate::{ide::applied, session::Session};

    fn lines(text: &str, lines: std::ops::Range<usize>) -> String {
        let edits = formatted_lines(&Session::default(), text, &lines);
        applied(text, &edits)
    }

    #[test]
    fn edits_lead_to_the_canonical_form_and_touch_little() {
        let session = Session::default();
        for text in [
            "let   a = 1\nlet b = 2\nlet   c=3\n",
            "\n\n;let a=1 ;let b=2 /* x */; let d=3 // y\n\n\n\nlet z=1\n;\n",
            "let a=1;;let b = 2",
            "// only\n\n\n",
            "\u{feff}let a=1\r\n\r\n\r\nlet b=2\r\n",
            "",
            "\n\n",
        ] {
            let new = session.format("", text.as_bytes()).unwrap();
            assert_eq!(applied(text, &formatted(&session, text)), new, "{text:?}");
        }
        let text = "let a = 1\nlet   b = 2\ntest \"t\" {\n    check a == 1\n    check a  == 1\n}\n";
        let ranges: Vec<_> = formatted(&session, text).into_iter().map(|edit| edit.range).collect();
        assert_eq!(ranges, [10..22, 50..68]);
    }

    #[test]
    fn statements_that_share_a_line_are_formatted_together() {
        let text = "geo 1\nlet a=1 let b=2 let c=3\n\n\n\nlet z=1\n";
        let three = "geo 1\nlet a = 1\nlet b = 2\nlet c = 3\n\n\n\nlet z=1\n";
        assert_eq!(lines(text, 1..2), three);
        assert_eq!(lines(text, 2..3), "geo 1\nlet a=1 let b=2 let c=3\n\nlet z=1\n");
        let text = "let a=1 ;let b=2 /* x */; let d=3 // y\n\n\n\nlet z=1\n";
        let apart = "let a = 1\nlet b = 2 /* x */\nlet d = 3 // y\n\n\n\nlet z=1\n";
        assert_eq!(lines(text, 0..1), apart);
    }

    #[test]
    fn a_statement_over_several_lines_is_formatted_from_each_of_them() {
        let text = "let a=[1,\n2]\nlet b=1\n";
        for line in 0..2 {
            assert_eq!(lines(text, line..line + 1), "let a = [1,\n    2]\nlet b=1\n");
        }
        assert_eq!(lines(text, 2..3), "let a=[1,\n2]\nlet b = 1\n");
        assert_eq!(lines("let a=1", 0..1), "let a = 1\n");
    }
}
