//! Tokens to tree, with chumsky.
//!
//! First `brackets` and `depth` make sure that brackets come in pairs and that the rest may recurse;
//! then the grammar (`statement`,
//! `expression`, `primary`, `literal`) reads the tokens, each broken statement for itself; then
//! `explain` finds words for what went wrong.

mod body;
mod brackets;
mod depth;
mod explain;
mod expression;
mod followup_errors;
mod gmsh;
mod input;
mod literal;
mod order;
mod parsed_script;
mod primary;
mod problem;
mod statement;

use chumsky::extra::SimpleState;
use chumsky::prelude::Parser;

use self::parsed_script::ParsedScript;
use super::ast::Tree;
use super::lexer::lex;
use crate::diag::{Code, Diagnostic, Span};
use crate::limits::{Ceiling, Limits};

/// The tree of `source`, and everything that is wrong with it, in the order of the places.
///
/// Never fails: where the text is broken, `Error` nodes stand in the tree. Linear in the length
/// of the text; the stack it needs is bounded by `limits.nesting`.
///
/// ```
/// use virote_language::{limits::Limits, syntax};
///
/// let (tree, found) = syntax::parse("let a = (1\nlet b = 2", &Limits::DEFAULT);
/// assert_eq!(tree.statements.len(), 2);
/// assert_eq!(found[0].message, "`(` is never closed");
/// ```
#[must_use]
pub fn parse<'s>(source: &'s str, limits: &Limits) -> (Tree<'s>, Vec<Diagnostic>) {
    if source.len() > limits.source_bytes.min(u32::MAX as usize) {
        return (Tree::default(), vec![too_large(source, limits)]);
    }
    let mut lexed = lex(source, most_diagnostics(limits));
    let mut diagnostics = brackets::check(&mut lexed, limits);
    diagnostics.extend(depth::check(&mut lexed, limits));
    diagnostics.append(&mut lexed.diagnostics);
    let mut state = SimpleState(ParsedScript { lexed: &lexed, limits: *limits, diagnostics });
    let grammar_input = &lexed.tokens[..lexed.tokens.len() - 1];
    let statements = body::script().parse_with_state(grammar_input, &mut state).into_output();
    let tree = Tree { statements: statements.unwrap_or_default() };
    let mut diagnostics = state.0.diagnostics;
    diagnostics.extend(order::check(source, &tree, most_diagnostics(limits)));
    diagnostics.sort_by_key(|diagnostic| diagnostic.primary.span);
    diagnostics.dedup();
    followup_errors::drop_echoes(source, &tree, &mut diagnostics);
    if !diagnostics.is_empty()
        && let Some(gmsh) = gmsh::recognise(&lex(source, 0))
    {
        return (Tree::default(), vec![gmsh]);
    }
    (tree, diagnostics)
}

/// Diagnostics that are recorded for each one that is shown: enough to count the rest, few
/// enough that a large file of something else does not fill the memory.
const RECORDED_FOR_EACH_SHOWN: usize = 50;

/// How many diagnostics each pass over a script records.
fn most_diagnostics(limits: &Limits) -> usize {
    limits.diagnostics.saturating_mul(RECORDED_FOR_EACH_SHOWN)
}

fn too_large(source: &str, limits: &Limits) -> Diagnostic {
    let message =
        format!("the script has {} bytes, more than {}", source.len(), limits.source_bytes);
    Diagnostic::error(Code::SourceTooLarge, Span::default(), message)
        .crossing(Ceiling::SOURCE_BYTES)
        .hint("put the data into a file of its own and `load` it")
}
