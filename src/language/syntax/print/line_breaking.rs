//! Lines that are too long are broken: at the loosest place that helps, or in brackets.
//!
//! No break changes what is read: none comes before a `(`, `[` or `-` that continues an expression.

use super::atom::{Atom, GroupContent, Point, Rank};
use super::line::{INDENT, LayoutLine, ends_items, spaces};
use crate::syntax::token::Token;

/// Columns of a line, messages and comments in the margin not counted.
const WIDTH: usize = 100;

/// Broken wherever they stand, whether or not what is left fits.
const ALWAYS: [Rank; 5] = [Rank::Pipe, Rank::Else, Rank::Body, Rank::Or, Rank::And];

/// Broken where all that is left fits.
const IF_IT_FITS: [Rank; 5] = [Rank::Item, Rank::Bind, Rank::Compare, Rank::Sum, Rank::Product];

/// Broken where nothing else is left.
const AT_LAST: [Rank; 9] = [
    Rank::Item,
    Rank::Bind,
    Rank::Compare,
    Rank::Sum,
    Rank::Product,
    Rank::Then,
    Rank::Arrow,
    Rank::LastBind,
    Rank::Clause,
];

/// Breaks a line that is too long, if it can be; `further` is the indentation of what continues it.
pub(super) fn wrap(atoms: &mut [Atom<'_>], line: LayoutLine, further: usize) -> bool {
    let measured = MeasuredLine::new(atoms, line);
    if measured.fits(line.start, measured.end, line.indent) {
        return false;
    }
    let Some(chosen) = choose(atoms, line, further, &measured) else { return false };
    for at in chosen {
        atoms[at].begin_line();
    }
    true
}

/// Where a line is best broken.
fn choose(
    atoms: &[Atom<'_>],
    line: LayoutLine,
    further: usize,
    measured: &MeasuredLine,
) -> Option<Vec<usize>> {
    let places = places(atoms, line);
    let at_rank = |rank: Rank| -> Vec<usize> {
        let has_rank = |at: usize| match rank {
            Rank::Item => atoms[at - 1].token == Token::Comma,
            _ => atoms[at].rank == Some(rank),
        };
        places.iter().copied().filter(|&at| has_rank(at)).collect()
    };
    let always = ALWAYS.map(at_rank).into_iter().find(|breaks| !breaks.is_empty());
    let fitting = || {
        let filled = IF_IT_FITS.iter().map(|&rank| measured.filled(&at_rank(rank), further));
        filled.flatten().find(|breaks| !breaks.is_empty())
    };
    let at_last = || AT_LAST.map(at_rank).into_iter().find(|breaks| !breaks.is_empty());
    always.or_else(fitting).or_else(|| bracket(atoms, line, &places, measured)).or_else(at_last)
}

/// A line with the columns of its atoms.
struct MeasuredLine {
    start: usize,
    /// Behind the last atom that counts.
    end: usize,
    /// For each atom the columns up to its end, counted from the start of the line's text.
    ends: Vec<usize>,
    /// For each atom the column of its beginning.
    starts: Vec<usize>,
}

impl MeasuredLine {
    fn new(atoms: &[Atom<'_>], line: LayoutLine) -> Self {
        let (mut ends, mut starts) = (Vec::new(), Vec::new());
        let mut column = 0;
        for at in line.start..line.end {
            column += if at > line.start { spaces(atoms, at, at + 1 == line.end) } else { 0 };
            starts.push(column);
            column += atoms[at].width() + usize::from(ends_items(atoms, at));
            ends.push(column);
        }
        let is_margin = |atom: &Atom<'_>| atom.is_comment() || atom.point == Some(Point::Label);
        let mut end = line.end;
        while end > line.start && is_margin(&atoms[end - 1]) {
            end -= 1;
        }
        Self { start: line.start, end, ends, starts }
    }

    /// Whether the atoms from `start` to before `end` fit on a line.
    fn fits(&self, start: usize, end: usize, indent: usize) -> bool {
        start >= end
            || indent + self.ends[end - 1 - self.start] - self.starts[start - self.start] <= WIDTH
    }

    /// Those of the breaks that are needed, if the lines between them fit.
    fn filled(&self, breaks: &[usize], further: usize) -> Option<Vec<usize>> {
        let mut needed = Vec::new();
        let (mut start, mut indent) = (self.start, further);
        for (index, &at) in breaks.iter().enumerate() {
            let next = breaks.get(index + 1).copied().unwrap_or(self.end);
            if !self.fits(start, next, indent) {
                if !self.fits(start, at, indent) {
                    return None;
                }
                needed.push(at);
                (start, indent) = (at, further);
            }
        }
        self.fits(start, self.end, indent).then_some(needed)
    }
}

/// The atoms of a line before which it may be broken without breaking brackets: those at the
/// least depth of brackets that any of them has.
fn places(atoms: &[Atom<'_>], line: LayoutLine) -> Vec<usize> {
    let mut places = Vec::new();
    let (mut depth, mut least) = (0_i64, 0);
    for (at, atom) in atoms.iter().enumerate().take(line.end).skip(line.start) {
        depth -= i64::from(atom.closes());
        if depth < least {
            places.clear();
            least = depth;
        }
        if depth == least {
            places.push(at);
        }
        depth += i64::from(atom.opens());
    }
    places.retain(|&at| at > line.start);
    places
}

/// Breaks in the widest brackets of a line.
fn bracket(
    atoms: &[Atom<'_>],
    line: LayoutLine,
    places: &[usize],
    measured: &MeasuredLine,
) -> Option<Vec<usize>> {
    let inside = |open: usize| open + 1..atoms[open].partner.min(line.end);
    let width = |open: usize| {
        let inside = inside(open);
        measured.ends[inside.end - 1 - line.start] - measured.starts[inside.start - line.start]
    };
    let mut open = [line.start]
        .iter()
        .chain(places)
        .copied()
        .filter(|&at| atoms[at].opens() && !inside(at).is_empty())
        .max_by_key(|&open| width(open))?;
    while let Some(inner) = hugged(atoms, open, line) {
        open = inner;
    }
    Some(broken(atoms, open, line, measured))
}

/// The brackets at the end of the only item in `open`, if they do as well.
fn hugged(atoms: &[Atom<'_>], open: usize, line: LayoutLine) -> Option<usize> {
    let close = atoms[open].partner;
    if close >= line.end || !atoms[close - 1].closes() {
        return None;
    }
    let inner = atoms[close - 1].partner;
    let before = atoms.get(open + 1..inner)?;
    let is_simple = |atom: &Atom<'_>| {
        atom.token == Token::Arrow
            || (atom.rank.is_none_or(|rank| rank == Rank::Arrow)
                && matches!(atom.token, Token::Name | Token::Dot))
    };
    (before.iter().all(is_simple) && inner + 1 < close - 1).then_some(inner)
}

/// Breaks behind `open`, between its items, and before its partner.
fn broken(
    atoms: &[Atom<'_>],
    open: usize,
    line: LayoutLine,
    measured: &MeasuredLine,
) -> Vec<usize> {
    let close = atoms[open].partner;
    let mut items = Vec::new();
    let mut at = open + 1;
    let is_items = atoms[open].holds == GroupContent::Items;
    while is_items && at < close.min(line.end) {
        if atoms[at].opens() {
            at = atoms[at].partner;
        } else if atoms[at].token == Token::Comma && at + 1 < close.min(line.end) {
            items.push(at + 1);
        }
        at += 1;
    }
    let is_scalar =
        |atom: &Atom<'_>| matches!(atom.token, Token::Number | Token::Minus | Token::Comma);
    let inner = line.indent + INDENT;
    if !items.is_empty() && close < line.end && atoms[open + 1..close].iter().all(is_scalar) {
        items = filled_row(measured, open, close, &items, inner);
    }
    items.extend([open + 1, close]);
    items
}

/// Those of the breaks between numbers that are needed.
fn filled_row(
    measured: &MeasuredLine,
    open: usize,
    close: usize,
    breaks: &[usize],
    indent: usize,
) -> Vec<usize> {
    let mut needed = Vec::new();
    let mut start = open + 1;
    for (index, &at) in breaks.iter().enumerate() {
        let next = breaks.get(index + 1).copied().unwrap_or(close);
        // The last number takes a comma too.
        if !measured.fits(start, next, indent + usize::from(next == close)) {
            needed.push(at);
            start = at;
        }
    }
    needed
}
