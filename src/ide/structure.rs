//! The shape of a text: its symbols, what folds, what is selected next.

use std::ops::Range;

use super::{ActKind, DefinedName, Document, NameRole, hover};
use crate::{kernel::sorting::sort_by_key, syntax::Highlight};

/// A definition, a test or a file, with what stands inside of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// What it is called.
    pub name: String,
    /// What it is: none of a test.
    pub role: Option<NameRole>,
    /// The same in a few words.
    pub detail: String,
    /// All of it.
    pub whole: Range<usize>,
    /// Its name.
    pub place: Range<usize>,
    /// What it defines inside.
    pub children: Vec<Symbol>,
}

/// A part that folds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoldingRange {
    /// Its bytes.
    pub range: Range<usize>,
    /// Whether it is a comment.
    pub is_comment: bool,
    /// Whether it is a row of imports.
    pub is_imports: bool,
}

impl Document {
    /// The definitions and tests of the file, in order.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        let inner = |whole: &Range<usize>| -> Vec<Symbol> {
            let is_inside = |name: &&DefinedName| {
                !name.is_of_file
                    && !matches!(name.role, NameRole::Parameter | NameRole::Variable)
                    && whole.start <= name.whole.start
                    && name.whole.end <= whole.end
            };
            // A name stands inside of what defines it.
            let names = &self.outline.names;
            let first = names.partition_point(|name| name.place.start < whole.start);
            let behind = names.partition_point(|name| name.place.start < whole.end);
            names[first..behind.max(first)]
                .iter()
                .filter(is_inside)
                .map(|name| symbol(name, Vec::new()))
                .collect()
        };
        let mut found: Vec<Symbol> =
            self.outline.of_file().map(|name| symbol(name, inner(&name.whole))).collect();
        let tests = self.outline.acts.iter().filter(|act| act.kind == ActKind::Test);
        found.extend(tests.map(|act| Symbol {
            name:
                self.text.get(act.subject.clone()).unwrap_or_default().trim_matches('"').to_owned(),
            role: None,
            detail: "test".to_owned(),
            whole: act.whole.clone(),
            place: act.subject.clone(),
            children: inner(&act.whole),
        }));
        sort_by_key(&mut found, |symbol| symbol.whole.start);
        found
    }

    /// Statements and brackets over several lines, comments, rows of imports.
    #[must_use]
    pub fn folds(&self) -> Vec<FoldingRange> {
        let has_lines = |range: &Range<usize>| {
            self.text.get(range.clone()).is_some_and(|text| text.contains('\n'))
        };
        let plain =
            |range: Range<usize>| FoldingRange { range, is_comment: false, is_imports: false };
        let mut found: Vec<FoldingRange> = self
            .outline
            .nodes
            .iter()
            .filter(|range| has_lines(range))
            .cloned()
            .map(plain)
            .collect();
        let comments = self
            .pieces
            .iter()
            .filter(|(paint, _)| *paint == Highlight::Comment)
            .map(|(_, range)| range.clone());
        let comments = self.rows(comments).into_iter();
        found.extend(comments.map(|range| FoldingRange { is_comment: true, ..plain(range) }));
        let imports = self
            .outline
            .acts
            .iter()
            .filter(|act| act.kind == ActKind::Import)
            .map(|act| act.whole.clone());
        found.extend(
            self.rows(imports)
                .into_iter()
                .map(|range| FoldingRange { is_imports: true, ..plain(range) }),
        );
        sort_by_key(&mut found, |fold| (fold.range.start, fold.range.end));
        // Of several that begin on a line the longest.
        let line = |at: usize| self.lines.position(&self.text, at, super::ColumnUnit::Utf8).line;
        found.reverse();
        found.dedup_by_key(|fold| line(fold.range.start));
        found.reverse();
        found
    }

    /// Ranges that follow one another without anything between, as one, where that has several lines.
    fn rows(&self, ranges: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
        let mut rows: Vec<Range<usize>> = Vec::new();
        for range in ranges {
            match rows.last_mut() {
                Some(last)
                    if self.text.get(last.end..range.start).is_some_and(|gap| {
                        gap.trim().is_empty() && gap.matches('\n').count() == 1
                    }) =>
                {
                    last.end = range.end;
                }
                _ => rows.push(range),
            }
        }
        rows.retain(|range| {
            self.text.get(range.clone()).is_some_and(|text| text.trim_end().contains('\n'))
        });
        rows
    }

    /// What is around a byte, from the word to all of the text.
    #[must_use]
    pub fn selections(&self, at: usize) -> Vec<Range<usize>> {
        let mut found: Vec<Range<usize>> = self
            .outline
            .nodes
            .iter()
            .filter(|range| range.start <= at && at <= range.end)
            .cloned()
            .collect();
        found.extend(self.piece_at(at).map(|idx| self.pieces[idx].1.clone()));
        found.push(0..self.text.len());
        sort_by_key(&mut found, |range| (range.len(), range.start));
        let mut nested: Vec<Range<usize>> = Vec::new();
        for range in found {
            let holds = |last: &Range<usize>| {
                range.start <= last.start && last.end <= range.end && range != *last
            };
            if nested.last().is_none_or(holds) {
                nested.push(range);
            }
        }
        nested
    }
}

fn symbol(name: &DefinedName, children: Vec<Symbol>) -> Symbol {
    let signature = hover::signature(name);
    let detail = match name.role {
        NameRole::Function => signature.trim_start_matches("fn ").to_owned(),
        _ => signature.split(' ').next().unwrap_or_default().to_owned(),
    };
    Symbol {
        name: name.name.clone(),
        role: Some(name.role),
        detail,
        whole: name.whole.clone(),
        place: name.place.clone(),
        children,
    }
}
