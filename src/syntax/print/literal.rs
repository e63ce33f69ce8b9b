//! Numbers and strings: from their value to a spelling.

use super::expression::expression;
use super::layout::Layout;
use crate::diag::Span;
use crate::syntax::ast::{Piece, Unit};

/// A number as it was written, else in its shortest form.
pub(super) fn number(layout: &mut Layout<'_>, value: f64, unit: Option<Unit>, span: Span) {
    if let Some(text) = layout.source().and_then(|source| source.get(span.range())) {
        return layout.text(text);
    }
    let mut buffer = ryu::Buffer::new();
    let digits = buffer.format(value);
    let digits = digits.strip_suffix(".0").unwrap_or(digits);
    layout.text(format!("{digits}{}", unit.map_or("", Unit::name)));
}

/// A string as it was written, else of its escaped `pieces`.
pub(super) fn string(layout: &mut Layout<'_>, span: Span, pieces: &[String]) {
    if let Some(text) = layout.source().and_then(|source| source.get(span.range())) {
        return layout.text(text);
    }
    layout.text(format!("\"{}\"", pieces.concat()));
}

/// A piece of an interpolated string, which stays on one line.
pub(super) fn piece(piece: &Piece<'_>) -> String {
    match piece {
        Piece::Text(text) => escaped(text),
        Piece::Expr(expr) => {
            let mut inner = Layout::new(None);
            expression(&mut inner, expr);
            format!("{{{}}}", inner.render_flat())
        }
    }
}

/// Text as it stands between quotes.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '"' | '\\' | '{' => out.extend(['\\', c]),
            c if c.is_control() => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    out
}
