//! Tree to text, and text to its canonical form.
//!
//! [`print()`] spells a tree; [`format()`] arranges a text, its author's line breaks, comments and
//! columns kept. What either writes is read again to an equal tree.

mod align;
mod atom;
mod flat;
mod format;
mod layout;
mod line;
mod line_breaking;
mod mark;
mod shape;

pub use format::format;

use super::ast::Tree;
use crate::limits::Limits;

/// The canonical text of `tree`, documentation included.
///
/// Statements that were not understood are left out. Numbers and strings stand in their shortest
/// form; comments are not in the tree: [`format()`] keeps both as they were written.
#[must_use]
pub fn print(tree: &Tree<'_>) -> String {
    let text = flat::script(tree);
    // What a broken tree spells may be broken too, and stays as it is.
    format(&text, &Limits::DEFAULT).unwrap_or(text)
}
