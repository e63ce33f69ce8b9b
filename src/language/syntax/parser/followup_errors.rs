//! One mistake, one message: what is found only because of something else is dropped.

use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::ast::{Statement, StatementKind, Tree};

/// Drops the echoes among the findings of a script, which are in order.
pub(super) fn drop_echoes(source: &str, tree: &Tree<'_>, diagnostics: &mut Vec<Diagnostic>) {
    drop_what_a_comment_swallowed(diagnostics);
    drop_what_stands_beside_its_cause(source, diagnostics);
    drop_what_a_stray_bracket_explains(tree, diagnostics);
}

/// Drops what is missing only because a comment that is never closed has swallowed it.
fn drop_what_a_comment_swallowed(diagnostics: &mut Vec<Diagnostic>) {
    let unclosed = diagnostics.iter().find(|found| found.code == Code::UnclosedComment);
    let Some(start) = unclosed.map(|found| found.primary.span.start) else { return };
    // Whatever is expected at the end of the text is expected before the comment.
    diagnostics.retain(|found| found.code != Code::Syntax || found.primary.span.end + 1 < start);
}

/// Drops the second of two findings about one word and what stands right before it, such as the `:=`
/// of `x := 3`, where `x` begins no statement, and the unit of `1e400 mm`, whose number is none.
fn drop_what_stands_beside_its_cause(source: &str, diagnostics: &mut Vec<Diagnostic>) {
    diagnostics.dedup_by(|found, cause| {
        let (span, before) = (found.primary.span, cause.primary.span);
        let gap = source.get(before.end as usize..span.start as usize);
        let touches = gap.is_none_or(|gap| gap.trim().is_empty());
        let is_one = matches!(
            (cause.code, found.code),
            (Code::Syntax, Code::StrayText) | (Code::BadNumber | Code::UnknownUnit, Code::Syntax)
        );
        is_one && touches && !gap.is_some_and(|gap| gap.contains('\n'))
    });
}

/// Drops what else does not fit in a statement with a bracket that closes nothing, or not what it
/// should: most often another one was left out before it, and all that stands between is read
/// without it.
fn drop_what_a_stray_bracket_explains(tree: &Tree<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let is_stray = |found: &&Diagnostic| found.code == Code::StrayBracket;
    let strays: Vec<u32> =
        diagnostics.iter().filter(is_stray).map(|found| found.primary.span.start).collect();
    if strays.is_empty() {
        return;
    }
    let mut statements = Vec::new();
    places(&tree.statements, &mut statements);
    let statement_at = |at: u32| {
        let next = statements.partition_point(|span| span.start <= at);
        next.checked_sub(1).map(|last| statements[last]).filter(|span| at <= span.end)
    };
    let mut spoilt: Vec<Span> = strays.into_iter().filter_map(statement_at).collect();
    spoilt.dedup();
    diagnostics.retain(|found| {
        let place = statement_at(found.primary.span.start);
        found.code != Code::Syntax
            || place.is_none_or(|place| spoilt.binary_search(&place).is_err())
    });
}

/// The places of statements in order; of a test those inside.
fn places(statements: &[Statement<'_>], out: &mut Vec<Span>) {
    for statement in statements {
        match &statement.kind {
            StatementKind::Test { body, .. } => places(body, out),
            _ => out.push(statement.span),
        }
    }
}
