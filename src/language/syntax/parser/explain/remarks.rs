//! Findings that do not stop the grammar: it knows what is meant and goes on.

use super::missing::NO_STEP;
use crate::diag::{Code, Diagnostic, Fix, Span};
use crate::syntax::ast::Name;
use crate::syntax::is_name;
use crate::syntax::parser::body::StatementContext;
use crate::syntax::parser::input::{Input, here};
use crate::syntax::parser::parsed_script::ParsedScript;
use crate::syntax::token::Token;

/// A comparison that is quoted in a hint has at most so many bytes.
const QUOTED: usize = 60;

/// `a < b < c` before here: it begins with token `start`, its operators are `first` and `second`.
pub(crate) fn chain(
    input: &mut Input<'_, '_, '_>,
    [start, first, second]: [usize; 3],
) -> Diagnostic {
    let end = here(input);
    let script = input.state();
    let is_range = matches!(script.token(second), Token::Range | Token::RangeBelow);
    let message = if is_range { "ranges do not chain" } else { "comparisons do not chain" };
    let diagnostic = Diagnostic::error(Code::ComparisonChain, script.span(second), message);
    if is_range {
        return diagnostic.label("second range").hint("a range has two ends: `a..b`");
    }
    let text = |from: usize, to: usize| &script.source[script.place(from, to).range()];
    let whole = text(start, end);
    let meant = format!("{} and {}", text(start, second), text(first + 1, end));
    let hint = if whole.len() <= QUOTED && !whole.contains('\n') {
        format!("write `{meant}`")
    } else {
        "write `a < b and b < c`".to_owned()
    };
    let fix =
        Fix { title: "compare twice".to_owned(), edits: vec![(script.place(start, end), meant)] };
    diagnostic.label("second comparison").hint(hint).fix(fix)
}

/// `[a b]`: no comma before token `at`.
pub(crate) fn missing_comma(script: &ParsedScript<'_, '_>, at: usize) -> Diagnostic {
    let diagnostic = Diagnostic::error(Code::Syntax, script.gap(at), "a `,` is missing")
        .label("expected `,` after this")
        .also(script.span(at), "before this");
    let hint = match script.token(at) {
        Token::Name if script.text(at) == "step" => Some(NO_STEP),
        token => line_hint(token),
    };
    match hint {
        Some(hint) => diagnostic.hint(hint),
        None => diagnostic.fix(Fix::insert(script.gap(at), ",")),
    }
}

/// Why a token that begins a line does not continue the line before.
pub(super) fn line_hint(token: Token) -> Option<&'static str> {
    match token {
        Token::LineMinus => Some(
            "a `-` that begins a line starts a new expression; to continue the one before, put it at the end of that line",
        ),
        Token::LineParen | Token::LineBracket => Some(
            "a bracket that begins a line starts a new expression; to call or to index, put it on the line before",
        ),
        _ => None,
    }
}

/// `f(label: value)`
pub(crate) fn colon_in_call(script: &ParsedScript<'_, '_>, label: usize) -> Diagnostic {
    let message = "an argument is written `name = value`";
    Diagnostic::error(Code::Syntax, script.span(label + 1), message)
        .label(format!("did you mean `{} = ...`?", script.text(label)))
        .fix(Fix::replace(script.span(label + 1), " ="))
}

/// `{label = value}`
pub(crate) fn equals_in_record(
    script: &ParsedScript<'_, '_>,
    label: Name<'_>,
    at: usize,
) -> Diagnostic {
    let message = "a field of a record is written `name: value`";
    Diagnostic::error(Code::Syntax, script.span(at), message)
        .label(format!("did you mean `{}: ...`?", label.text))
        .fix(Fix {
            title: "write `:`".to_owned(),
            edits: vec![(Span::new(label.span.end, script.span(at).end), ":".to_owned())],
        })
}

/// `{"label": value}`
pub(crate) fn quoted_label(input: &mut Input<'_, '_, '_>) -> Diagnostic {
    let at = here(input);
    let script = input.state();
    let text = script.text(at).trim_matches('"');
    let message = "the label of a record stands without quotes";
    let found = Diagnostic::error(Code::Syntax, script.span(at), message);
    if !is_name(text) {
        return found.hint("a label is one word, of letters, digits and `_`");
    }
    found.label(format!("did you mean `{text}:`?")).fix(Fix::replace(script.span(at), text))
}

/// A parenthesis with none or with more than three parts.
pub(crate) fn point_length(n: usize, span: Span) -> Diagnostic {
    let message = format!("a point has two or three coordinates, not {n}");
    let diagnostic = Diagnostic::error(Code::Syntax, span, message);
    if n == 0 {
        return diagnostic.hint("an empty list is `[]`");
    }
    diagnostic.hint("a list is written `[a, b, c, d]`")
}

/// A statement that may not stand in `body`.
pub(crate) fn misplaced(
    script: &ParsedScript<'_, '_>,
    at: usize,
    body: StatementContext,
) -> Diagnostic {
    let keyword = script.text(at);
    let (place, hint) = match body {
        StatementContext::Block => ("in a block", "a block holds definitions, then its value"),
        StatementContext::Test => ("in a test", "move it to the top level"),
        StatementContext::Script => {
            ("outside of a test", "write `test \"name\" { expect error ... }`")
        }
    };
    let message = format!("`{keyword}` cannot stand {place}");
    Diagnostic::error(Code::Misplaced, script.span(at), message).hint(hint)
}
