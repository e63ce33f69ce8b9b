//! What can be said about the order of statements without evaluating any: `geo` stands first,
//! and `geo`, `unit` and `tolerance` stand once each.

use crate::diag::{Code, Diagnostic, Fix, Span};
use crate::syntax::ast::{Expr, ExprKind, StatementKind, Tree};

/// The edition of the language that this program knows.
const EDITION: f64 = 1.0;

/// The statements of `tree`, which was read from `source`, that stand in the wrong place, but not many more than `most`.
pub(super) fn check(source: &str, tree: &Tree<'_>, most: usize) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut first_places: [Option<Span>; 3] = [None; 3];
    for (index, statement) in tree.statements.iter().enumerate() {
        if found.len() >= most {
            break;
        }
        let (which, keyword) = match &statement.kind {
            StatementKind::Edition(edition) => {
                found.extend(check_edition(edition));
                (0, "geo")
            }
            StatementKind::Unit(_) => (1, "unit"),
            StatementKind::Tolerance(_) => (2, "tolerance"),
            _ => continue,
        };
        let start = statement.span.start;
        let place = Span::new(start, start + u32::try_from(keyword.len()).unwrap_or(0));
        if let Some(first) = first_places[which] {
            let message = format!("`{keyword}` stands twice");
            let diagnostic = Diagnostic::error(Code::Misplaced, place, message);
            let fix = Fix::remove(with_line_break(source, statement.span), keyword);
            found.push(diagnostic.label("second one").also(first, "first one").fix(fix));
        } else if which == 0 && index > 0 {
            let diagnostic = Diagnostic::error(Code::Misplaced, place, "`geo` stands first");
            let text = format!("{}\n", &source[statement.span.range()]);
            let edits = vec![
                (Span::default(), text),
                (with_line_break(source, statement.span), String::new()),
            ];
            let fix = Fix { title: "move it to the top".to_owned(), edits };
            found.push(diagnostic.label("move this line to the top of the script").fix(fix));
        }
        first_places[which].get_or_insert(place);
    }
    found
}

/// A statement with the end of its line, where nothing else stands there.
fn with_line_break(source: &str, statement: Span) -> Span {
    let (before, rest) = (&source[..statement.start as usize], &source[statement.end as usize..]);
    let is_first = before.rsplit('\n').next().is_some_and(|line| line.trim().is_empty());
    let line_break = rest.find('\n').filter(|&at| is_first && rest[..at].trim().is_empty());
    let n_more = line_break.and_then(|at| u32::try_from(at + 1).ok()).unwrap_or(0);
    Span { start: statement.start, end: statement.end + n_more }
}

fn check_edition(edition: &Expr<'_>) -> Option<Diagnostic> {
    match edition.kind {
        ExprKind::Error => None,
        ExprKind::Number(EDITION, None) => None,
        ExprKind::Number(..) => {
            let message = "this program does not know that edition of the language";
            let diagnostic = Diagnostic::error(Code::WrongEdition, edition.span, message);
            Some(
                diagnostic.hint("it knows edition 1: `geo 1`").fix(Fix::replace(edition.span, "1")),
            )
        }
        _ => {
            let message = "the edition of the language is a number";
            let diagnostic = Diagnostic::error(Code::WrongEdition, edition.span, message);
            Some(diagnostic.hint("write `geo 1`").fix(Fix::replace(edition.span, "1")))
        }
    }
}
