//! Bounds of several unknowns.

use std::sync::Arc;

use super::SearchRange;
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::glam::DVec3,
    value::{BARE_AND_ANGLE, Dimension, IntoValue, Range, Record, Value},
};

/// Bounds of what nothing bounds.
pub(super) const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// The number in the middle of each range.
pub(super) fn middle(within: &Value, span: Span) -> Result<Value> {
    Ok(match within {
        Value::Range(range) => {
            let range = SearchRange::new(Spanned::new(*range, span))?;
            range.place(range.ends[0] + 0.5 * (range.ends[1] - range.ends[0])).into_value()
        }
        Value::List(items) => {
            let items: Vec<Value> =
                items.iter().map(|item| middle(item, span)).collect::<Result<_>>()?;
            Value::list(items)
        }
        Value::Record(record) => {
            let field = |(label, value): (&str, &Value)| -> Result<(Arc<str>, Value)> {
                Ok((Arc::from(label), middle(value, span)?))
            };
            let fields = record.iter().map(field).collect::<Result<Vec<_>>>()?;
            Value::Record(Arc::new(Record::new(fields)))
        }
        other => return no_bounds(&format!("found {}", other.phrase()), span),
    })
}

/// The bounds of the unknowns of a shape.
pub(super) fn bound(
    shape: &Value,
    within: &Value,
    span: Span,
    bounds: &mut Vec<[f64; 2]>,
) -> Result<()> {
    match (shape, within) {
        (Value::Number(number), Value::Range(range)) => {
            let ends = SearchRange::new(Spanned::new(*range, span))?.ends;
            check_ends(number.dim, range, span)?;
            bounds.push(ends);
        }
        (Value::Point(point), Value::Range(_)) => {
            for part in point.to_array() {
                bound(&Value::number(part), within, span, bounds)?;
            }
        }
        (Value::Point(DVec3 { x, y, z }), Value::List(ranges)) if ranges.len() <= 3 => {
            for (idx, part) in [*x, *y, *z].into_iter().enumerate() {
                match ranges.get(idx) {
                    Some(range) => bound(&Value::number(part), &range, span, bounds)?,
                    None => bounds.push(FREE),
                }
            }
        }
        (Value::List(items), Value::Range(_)) => {
            items.iter().try_for_each(|item| bound(item, within, span, bounds))?;
        }
        (Value::Record(record), Value::Range(_)) => {
            record.iter().try_for_each(|(_, value)| bound(value, within, span, bounds))?;
        }
        (Value::List(items), Value::List(ranges)) if items.len() == ranges.len() => {
            let mut pairs = items.iter().zip(ranges.iter());
            pairs.try_for_each(|(item, range)| bound(item, range, span, bounds))?;
        }
        (Value::Record(record), Value::Record(ranges)) => {
            if let Some((label, _)) = ranges.iter().find(|(label, _)| record.get(label).is_none()) {
                return no_bounds(&format!("there is no unknown `{label}`"), span);
            }
            for (label, value) in record.iter() {
                match ranges.get(label) {
                    Some(range) => bound(value, range, span, bounds)?,
                    None => {
                        let mut values = Vec::new();
                        take_apart(value, &mut values);
                        bounds.resize(bounds.len() + values.len(), FREE);
                    }
                }
            }
        }
        (shape, within) => {
            return no_bounds(&format!("found {} for {}", within.phrase(), shape.phrase()), span);
        }
    }
    Ok(())
}

/// # Errors
/// Ends of another dimension than the unknown. It changes, so that beside an angle it is no help that it is 0 now.
fn check_ends(unknown: Dimension, range: &Range, span: Span) -> Result<()> {
    for end in [range.start, range.end] {
        let (common, is_angle) = (unknown.common(end.dim), end.dim.angle_power() != 0);
        let is_said = is_angle || unknown.angle_power() == 0 || end.value.abs() <= 0.0;
        if common.is_some() && is_said && (unknown.angle_power() != 0 || !is_angle) {
            continue;
        }
        let message = format!("a bound is {}, the unknown is {unknown}", end.dim);
        let found = Diagnostic::error(Code::UnitMismatch, span, message);
        let is_bare = end.dim.is_bare() || unknown.is_bare();
        return if is_bare && common.is_some() { found.hint(BARE_AND_ANGLE) } else { found }.fail();
    }
    Ok(())
}

fn no_bounds<T>(found: &str, span: Span) -> Result<T> {
    let message = format!("`within` takes a range for each unknown, {found}");
    Diagnostic::error(Code::WrongKind, span, message)
        .hint("one range for all of them, or a list or record of ranges like the start: `within = {beam: 2m..4m, draft: 0.5m..2m}`")
        .fail()
}

/// The numbers of unknowns in order; whether there are no other values.
pub(super) fn take_apart(value: &Value, values: &mut Vec<f64>) -> bool {
    match value {
        Value::Number(number) => values.push(number.value),
        Value::Point(point) => values.extend(point.to_array()),
        Value::List(items) => return items.iter().all(|item| take_apart(item, values)),
        Value::Record(record) => return record.iter().all(|(_, value)| take_apart(value, values)),
        _ => return false,
    }
    true
}
