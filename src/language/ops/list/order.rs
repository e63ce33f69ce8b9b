//! The order of elements: by themselves, or by what a function says of them.

use std::cmp::Ordering;

use super::super::math::empty;
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{GeomError, LocalError},
    value::{At, Callback, Ctx, Dimension, FromValue, List, Number, Real, Value},
};

/// What decides the order of the elements of a list; any two have one.
pub(super) fn sort_keys(
    ctx: &mut Ctx<'_>,
    list: &Spanned<List>,
    by: Option<&Callback>,
) -> Result<Vec<Value>> {
    let items = &list.value;
    let keys: Vec<Value> = match by {
        Some(by) => {
            let keys = items.iter().map(|item| ctx.call(by, std::slice::from_ref(item)));
            keys.collect::<Result<_>>()?
        }
        None => items.to_vec(),
    };
    // A number without a unit goes with any other, so that neighbours alone do not tell.
    let mut known = keys.first();
    for key in keys.iter().skip(1) {
        let Some(before) = known else { break };
        if ordering(before, key).is_none() {
            let message = format!("{} and {} have no order", before.phrase(), key.phrase());
            return Diagnostic::error(Code::WrongKind, list.span, message)
                .hint("numbers of one dimension can be sorted, and strings; else give `by = x => ...`")
                .fail();
        }
        if !has_dimension(before) {
            known = Some(key);
        }
    }
    Ok(keys)
}

/// Whether it is a number of a known dimension.
fn has_dimension(key: &Value) -> bool {
    match key.looked_at() {
        Value::Number(number) => {
            number.dim != Dimension::NONE && number.dim.length_power().is_some()
        }
        _ => false,
    }
}

/// The index of the first element that comes before, or behind, all others.
pub(super) fn extreme_index(
    ctx: &mut Ctx<'_>,
    list: &Spanned<List>,
    by: Option<&Callback>,
    wanted: Ordering,
    what: &str,
) -> Result<usize> {
    let keys = sort_keys(ctx, list, by)?;
    let better = |a: usize, b: usize| ordering(&keys[b], &keys[a]) == Some(wanted);
    match (0..keys.len()).reduce(|best, idx| if better(best, idx) { idx } else { best }) {
        Some(idx) => {
            keys.iter().try_for_each(|key| check_tie(&keys[idx], key, list.span))?;
            Ok(idx)
        }
        None => empty(list.span, what),
    }
}

/// That two keys are not equal numbers with other derivatives, beside which their order is another one.
///
/// # Errors
/// Such ones.
fn check_tie(a: &Value, b: &Value, span: Span) -> Result<()> {
    if !(a.is_jet() || b.is_jet()) || ordering(a, b) != Some(Ordering::Equal) {
        return Ok(());
    }
    let real = |key: &Value| Number::<Real>::from_value(key, span).ok();
    let Some((a, _)) = real(a).zip(real(b)).filter(|(a, b)| !a.value.goes_with(&b.value)) else {
        return Ok(());
    };
    let what = "the order of equal numbers";
    Err(GeomError::from(LocalError::NotDifferentiable { what, at: a.value.value() })).at(span)
}

/// The order of two numbers or two strings.
pub(super) fn ordering(a: &Value, b: &Value) -> Option<Ordering> {
    match (a, b) {
        (Value::Jet(_), _) | (_, Value::Jet(_)) => ordering(&a.looked_at(), &b.looked_at()),
        (Value::Number(a), Value::Number(b)) => {
            a.dim.common(b.dim)?;
            a.value.partial_cmp(&b.value)
        }
        (Value::Text(a), Value::Text(b)) => Some(a.cmp(b)),
        _ => None,
    }
}
