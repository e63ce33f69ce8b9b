//! Atoms into lines: where each begins and ends, and how far it is indented.

use super::atom::{Atom, GroupContent, Start};
use super::line::{INDENT, LayoutLine};
use super::line_breaking;
use crate::syntax::token::Token;

/// Deeper than this nothing is indented, lest a text grow with the square of its depth.
const MOST_INDENT: usize = 60;

/// The lines of a script; breaks those that are too long.
pub(super) fn lines(atoms: &mut [Atom<'_>]) -> Vec<LayoutLine> {
    let mut lines = Vec::new();
    let mut nest = OpenBracket::new(atoms);
    let mut start = 0;
    while start < atoms.len() {
        let indent = nest.indent(atoms, start);
        let further = nest.further(atoms, start, indent);
        let end = loop {
            let end = (start + 1..atoms.len()).find(|&at| atoms[at].begins_line());
            let line = LayoutLine { start, end: end.unwrap_or(atoms.len()), indent };
            if !line_breaking::wrap(atoms, line, further) {
                break line.end;
            }
        };
        nest.advance(atoms, start..end, indent);
        lines.push(LayoutLine { start, end, indent });
        start = end;
    }
    lines
}

/// An open bracket, or the script.
struct OpenGroup {
    holds: GroupContent,
    /// The indentation of its closing bracket.
    outer: usize,
    /// The indentation of what it holds.
    inner: usize,
    /// The indentation of the current item, if that begins a line.
    item: Option<usize>,
}

/// The open brackets.
struct OpenBracket {
    open: Vec<OpenGroup>,
    /// For each atom the next one that is no comment.
    next: Vec<usize>,
    /// The last atom that was no comment.
    last: Option<usize>,
}

impl OpenBracket {
    fn new(atoms: &[Atom<'_>]) -> Self {
        let mut next = vec![atoms.len(); atoms.len()];
        for at in (0..atoms.len()).rev() {
            if !atoms[at].is_comment() {
                next[at] = at;
            } else if at + 1 < atoms.len() {
                next[at] = next[at + 1];
            }
        }
        let script = OpenGroup { holds: GroupContent::Statements, outer: 0, inner: 0, item: None };
        Self { open: vec![script], next, last: None }
    }

    /// Whether an item or a statement begins with atom `at`.
    fn begins_item(&self, atoms: &[Atom<'_>], at: usize) -> bool {
        let Some(open) = self.open.last() else { return true };
        let next = atoms.get(self.next[at]);
        let is_at_end = atoms[at].is_comment() && next.is_none_or(Atom::closes);
        if open.holds == GroupContent::Statements {
            return is_at_end || next.is_none_or(|next| next.is_head);
        }
        let follows = |last: usize| atoms[last].opens() || atoms[last].token == Token::Comma;
        is_at_end || self.last.is_none_or(follows)
    }

    /// The indentation of a line that begins with atom `at`.
    fn indent(&self, atoms: &[Atom<'_>], at: usize) -> usize {
        let Some(open) = self.open.last() else { return 0 };
        let indent = if atoms[at].closes() {
            open.outer
        } else if self.begins_item(atoms, at) {
            open.inner
        } else {
            open.item.map_or(open.inner, |item| item + INDENT)
        };
        indent.min(MOST_INDENT)
    }

    /// The indentation of the lines that continue this one.
    fn further(&self, atoms: &[Atom<'_>], at: usize, indent: usize) -> usize {
        let continues = !atoms[at].closes() && !self.begins_item(atoms, at);
        if continues { indent } else { indent + INDENT }
    }

    /// Leaves a line behind.
    fn advance(&mut self, atoms: &[Atom<'_>], line: std::ops::Range<usize>, indent: usize) {
        let mut is_first = true;
        for at in line {
            let atom = &atoms[at];
            if atom.is_comment() {
                continue;
            }
            let begins_item = self.begins_item(atoms, at);
            if let Some(open) = self.open.last_mut()
                && begins_item
                && !atom.closes()
            {
                open.item = is_first.then_some(indent);
            }
            if atom.opens() {
                let (outer, inner) = (indent, indent + INDENT);
                self.open.push(OpenGroup { holds: atom.holds, outer, inner, item: None });
            } else if atom.closes() && self.open.len() > 1 {
                self.open.pop();
            }
            self.last = Some(at);
            is_first = false;
        }
    }
}

/// Whether a blank line stands before a line.
pub(super) fn is_after_blank(atoms: &[Atom<'_>], line: LayoutLine) -> bool {
    atoms[line.start].start == Start::Blank
}
