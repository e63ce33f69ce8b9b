//! Elements and slices of lists and tables.

use super::autodiff;
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{Number, Range, Value},
};

/// `xs[i]`: an element, or a slice where the index is a range.
pub(super) fn index(
    subject: &Value,
    index: &Value,
    subject_span: Span,
    span: Span,
) -> Result<Value> {
    match (subject, index) {
        (Value::List(items), Value::Range(range)) => {
            let (start, end) = slice(items.len(), range, span)?;
            Ok(Value::List(items.slice(start..end.max(start))))
        }
        (Value::List(items), _) => {
            let idx = place(items.len(), index, "list", subject_span, span)?;
            Ok(items.get(idx).unwrap_or(Value::None))
        }
        (Value::Table(table), _) => {
            let row = place(table.n_rows(), index, "table", subject_span, span)?;
            Ok(crate::value::table_row(table, row))
        }
        (other, _) => {
            let hint = match other {
                Value::Point(_) => "coordinates are `.x`, `.y` and `.z`",
                Value::Curve(_) | Value::Surface(_) | Value::Face(_) => {
                    "curves and surfaces are called with round brackets: `c(t)`"
                }
                Value::Record(_) => {
                    "a record is asked for a member by name: `r.x`, or `r[\"half breadth\"]`"
                }
                _ => "only lists and tables have elements",
            };
            Diagnostic::error(
                Code::WrongKind,
                subject_span,
                format!("{} has no elements", other.phrase()),
            )
            .hint(hint)
            .fail()
        }
    }
}

/// The element that an index means; negative ones count from the end.
fn place(n: usize, index: &Value, what: &str, subject: Span, span: Span) -> Result<usize> {
    let number = match index {
        Value::Number(number) => number.as_integer(),
        _ => None,
    };
    let Some(number) = number else {
        if index.is_jet() {
            return autodiff::no_derivative("an index", span);
        }
        let message = format!("an index must be a whole number, found {}", index.phrase());
        return Diagnostic::error(Code::WrongKind, span, message).fail();
    };
    let place = if number < 0 { number + n as i64 } else { number };
    match usize::try_from(place) {
        Ok(place) if place < n => Ok(place),
        _ => Diagnostic::error(
            Code::IndexOutside,
            span,
            format!("index {number} is outside a {what} of {n}"),
        )
        .also(
            subject,
            format!("this {what} has {n} {}", if what == "table" { "rows" } else { "elements" }),
        )
        .hint(match n {
            0 => "it is empty".to_owned(),
            _ => format!("its indices are 0 to {}, or -1 to -{n} from the end", n - 1),
        })
        .fail(),
    }
}

/// The half-open range of elements that a slice means.
fn slice(n: usize, range: &Range, span: Span) -> Result<(usize, usize)> {
    let whole = |number: Number| number.as_integer();
    let (Some(start), Some(end)) = (whole(range.start), whole(range.end)) else {
        return Diagnostic::error(
            Code::WrongKind,
            span,
            format!("a slice needs whole numbers, found {range}"),
        )
        .fail();
    };
    let from_end = |place: i64| if place < 0 { place + n as i64 } else { place };
    let (start, end) = (from_end(start), from_end(end) + i64::from(range.closed));
    if end <= start && (0..=n as i64).contains(&start) {
        return Ok((0, 0));
    }
    match (usize::try_from(start), usize::try_from(end)) {
        (Ok(start), Ok(end)) if start <= end && end <= n => Ok((start, end)),
        _ => Diagnostic::error(
            Code::IndexOutside,
            span,
            format!("the slice {range} reaches outside a list of {n}"),
        )
        .fail(),
    }
}
