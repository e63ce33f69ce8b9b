//! Lines into text: what its author put into columns stays in columns.
//!
//! Names, equals signs and clauses stand in a column where they did in neighbouring statements;
//! messages and comments at the end of a line as far from it as they did. A column that has
//! become too narrow moves for all its lines.

use super::atom::{Atom, Point};
use super::layout::is_after_blank;
use super::line::{LayoutLine, ends_items, spaces};

/// The text of the lines.
pub(super) fn text(source: &str, atoms: &[Atom<'_>], lines: &[LayoutLine]) -> String {
    let mut rows: Vec<AlignedRow> =
        lines.iter().map(|&line| AlignedRow::new(source, atoms, line)).collect();
    for point in Point::ALL {
        align(&mut rows, point);
    }
    let mut text = String::with_capacity(source.len());
    for (index, (row, &line)) in rows.iter().zip(lines).enumerate() {
        if index > 0 && is_after_blank(atoms, line) {
            text.push('\n');
        }
        row.write(&mut text, atoms);
        text.push('\n');
    }
    text
}

/// A line with the columns that it may have.
struct AlignedRow {
    line: LayoutLine,
    is_after_blank: bool,
    is_statement: bool,
    stops: Vec<AlignmentStop>,
}

/// A place of a line that may be moved to a column.
struct AlignmentStop {
    point: Point,
    at: usize,
    /// Columns between it and the one before, or the beginning of the line's text; without its space.
    left: usize,
    /// The spaces before it.
    space: usize,
    /// The spaces before it in the source.
    written: usize,
    /// Its column in the source, counted as if the line were indented as it is now.
    column: Option<usize>,
}

impl AlignedRow {
    fn new(source: &str, atoms: &[Atom<'_>], line: LayoutLine) -> Self {
        let mut stops = Vec::new();
        let mut left = 0;
        for at in line.start..line.end {
            let is_last = at + 1 == line.end;
            let space = if at > line.start { spaces(atoms, at, is_last) } else { 0 };
            let point =
                atoms[at].point.or((is_last && atoms[at].is_comment()).then_some(Point::Comment));
            if let Some(point) = point.filter(|_| at > line.start) {
                let start = atoms[line.start].span.start as usize;
                let before = &source[start..atoms[at].span.start as usize];
                let column = (!before.contains('\n')).then(|| line.indent + before.chars().count());
                let written = before.chars().rev().take_while(|c| c.is_whitespace()).count();
                stops.push(AlignmentStop { point, at, left, space, written, column });
                left = 0;
            } else {
                left += space;
            }
            left += atoms[at].width() + usize::from(ends_items(atoms, at));
        }
        let is_statement = atoms[line.start..line.end]
            .iter()
            .find(|atom| !atom.is_comment())
            .is_some_and(|atom| atom.is_head);
        Self { line, is_after_blank: is_after_blank(atoms, line), is_statement, stops }
    }

    fn stop(&self, point: Point) -> Option<usize> {
        self.stops.iter().position(|stop| stop.point == point)
    }

    /// The column behind what stands before a stop.
    fn end_before(&self, stop: usize) -> usize {
        let before: usize = self.stops[..stop].iter().map(|stop| stop.left + stop.space).sum();
        self.line.indent + before + self.stops[stop].left
    }

    fn write(&self, text: &mut String, atoms: &[Atom<'_>]) {
        text.extend(std::iter::repeat_n(' ', self.line.indent));
        for at in self.line.start..self.line.end {
            let space = match self.stops.iter().find(|stop| stop.at == at) {
                Some(stop) => stop.space,
                None if at == self.line.start => 0,
                None => spaces(atoms, at, at + 1 == self.line.end),
            };
            text.extend(std::iter::repeat_n(' ', space));
            text.push_str(atoms[at].text);
            if ends_items(atoms, at) {
                text.push(',');
            }
        }
    }
}

/// Puts the stops at `point` into their columns.
fn align(rows: &mut [AlignedRow], point: Point) {
    let mut run: Vec<(usize, usize)> = Vec::new();
    for at in 0..rows.len() {
        let row = &rows[at];
        let stop = row.stop(point);
        let ends_run =
            row.is_after_blank || (stop.is_none() && (row.is_statement || point == Point::Comment));
        let is_apart = |&(last, stop_of_last): &(usize, usize)| {
            stop.is_some_and(|stop| row.stops[stop].column != rows[last].stops[stop_of_last].column)
        };
        if ends_run || run.last().is_some_and(is_apart) {
            settle(rows, &run);
            run.clear();
        }
        if let Some(stop) = stop {
            run.push((at, stop));
        }
    }
    settle(rows, &run);
}

/// Puts stops of one column in the source into one column.
fn settle(rows: &mut [AlignedRow], run: &[(usize, usize)]) {
    let Some(&(first, stop)) = run.first() else { return };
    let Some(column) = rows[first].stops[stop].column else { return };
    let is_wide = run.iter().any(|&(at, stop)| rows[at].stops[stop].written > 1);
    if !is_wide || (run.len() == 1 && !rows[first].stops[stop].point.is_marginal()) {
        return;
    }
    let least = run.iter().map(|&(at, stop)| rows[at].end_before(stop) + 1).max().unwrap_or(0);
    let column = column.max(least);
    for &(at, stop) in run {
        let end = rows[at].end_before(stop);
        rows[at].stops[stop].space = column - end;
    }
}
