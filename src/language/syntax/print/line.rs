//! A line of the result, and what stands between its atoms.

use super::atom::{Atom, GroupContent, code_at};
use crate::syntax::token::Token;

/// Spaces of one indentation.
pub(super) const INDENT: usize = 4;

/// A line of the result: the atoms from one to before another.
#[derive(Clone, Copy, Debug)]
pub(super) struct LayoutLine {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) indent: usize,
}

/// The spaces before atom `at`, which does not begin a line.
pub(super) fn spaces(atoms: &[Atom<'_>], at: usize, is_last: bool) -> usize {
    let (before, atom) = (&atoms[at - 1], &atoms[at]);
    let is_block =
        |open: &Atom<'_>| matches!(open.holds, GroupContent::Value | GroupContent::Statements);
    if atom.is_comment() {
        return usize::from(is_last || !before.opens() || is_block(before));
    }
    let is_glued = atom.is_glued
        || matches!(atom.token, Token::Comma | Token::Colon | Token::Dot)
        || matches!(before.token, Token::Dot | Token::Spread)
        || (before.opens() && (atom.closes() || !is_block(before)))
        || (atom.closes() && !is_block(&atoms[atom.partner]));
    usize::from(!is_glued)
}

/// Whether a comma follows atom `at`: the last of the items whose bracket closes on a new line.
pub(super) fn ends_items(atoms: &[Atom<'_>], at: usize) -> bool {
    if atoms[at].is_comment() {
        return false;
    }
    let close = code_at(atoms, at + 1);
    close < atoms.len()
        && atoms[close].closes()
        && (at + 1..=close).any(|at| atoms[at].begins_line())
        && atoms[close].partner != at
        && atoms[atoms[close].partner].holds == GroupContent::Items
}
