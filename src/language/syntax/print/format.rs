//! The formatter: canonical text that keeps comments, blank lines, line breaks inside of
//! statements, columns, and how numbers and strings are written.
//!
//! A line is indented by four for the brackets that are open, and by four more where it continues an item or a
//! statement. Statements stand on lines of their own, without semicolons. The last item before a bracket that closes on
//! its own line has a comma.

use super::{align, atom, layout, mark};
use crate::diag::Diagnostic;
use crate::limits::Limits;
use crate::syntax::lexer::lex;
use crate::syntax::parser::parse;

/// `source` in canonical form; the same text again when it has that form already.
///
/// # Errors
/// What is wrong with the text, if it cannot be parsed.
pub fn format(source: &str, limits: &Limits) -> Result<String, Vec<Diagnostic>> {
    let (tree, diagnostics) = parse(source, limits);
    if !diagnostics.is_empty() {
        return Err(diagnostics);
    }
    let mut atoms = atom::atoms(&lex(source, 0));
    mark::mark(&mut atoms, &tree);
    let lines = layout::lines(&mut atoms);
    Ok(align::text(source, &atoms, &lines))
}
