//! `solve` from a start: unknowns for which several functions are zero together.

use std::sync::Arc;

use super::{plain_number, told};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{LeastSquares, find_least_squares, glam::DVec3, tolerance::SYSTEM_ROOT_RELATIVE},
    value::{Callback, Ctx, Dimension, IntoValue, Number, Record, Value},
};

/// Unknowns as the script holds them: a number, a point, or a list or record of such.
pub(super) struct Unknowns {
    shape: Value,
    pub(super) values: Vec<f64>,
}

impl Unknowns {
    /// The unknowns of a start.
    ///
    /// # Errors
    /// A value that is none of these.
    pub(super) fn new(start: &Spanned<Value>) -> Result<Self> {
        let mut values = Vec::new();
        if !take_apart(&start.value, &mut values) || values.is_empty() {
            let message = format!("a search starts from numbers, found {}", start.value.phrase());
            return Diagnostic::error(Code::WrongKind, start.span, message)
                .hint("the start is a number, a point, or a list or record of such: `start = {beam: 3m, draft: 1m}`")
                .fail();
        }
        Ok(Self { shape: start.value.clone(), values })
    }

    /// The value of the start's shape with these numbers.
    fn with(&self, values: &[f64]) -> Value {
        put_together(&self.shape, &mut values.iter().copied())
    }
}

fn take_apart(value: &Value, values: &mut Vec<f64>) -> bool {
    match value {
        Value::Number(number) => values.push(number.value),
        Value::Point(point) => values.extend(point.to_array()),
        Value::List(items) => return items.iter().all(|item| take_apart(item, values)),
        Value::Record(record) => return record.iter().all(|(_, value)| take_apart(value, values)),
        _ => return false,
    }
    true
}

fn put_together(shape: &Value, values: &mut dyn Iterator<Item = f64>) -> Value {
    match shape {
        Value::Number(number) => {
            Number { value: values.next().unwrap_or(number.value), dim: number.dim }.into_value()
        }
        Value::Point(point) => {
            let parts = point.to_array().map(|part| values.next().unwrap_or(part));
            DVec3::from(parts).into_value()
        }
        Value::List(items) => {
            Value::List(items.iter().map(|item| put_together(item, values)).collect())
        }
        Value::Record(record) => {
            let field =
                |(label, value): (&str, &Value)| (Arc::from(label), put_together(value, values));
            Value::Record(Arc::new(Record::new(record.iter().map(field).collect::<Vec<_>>())))
        }
        other => other.clone(),
    }
}

/// The numbers that the function yields: each is to be zero.
fn residuals(value: &Value, span: Span, all: &mut Vec<f64>) -> Result<()> {
    match value {
        Value::Point(point) => all.extend(point.to_array()),
        Value::List(items) => items.iter().try_for_each(|item| residuals(item, span, all))?,
        Value::Record(record) => {
            record.iter().try_for_each(|(_, value)| residuals(value, span, all))?;
        }
        other => all.push(plain_number(other, span)?.value),
    }
    Ok(())
}

/// The unknowns near the start, and how they were found.
pub(super) fn solved(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    start: &Spanned<Value>,
) -> Result<(Value, LeastSquares)> {
    let unknowns = Unknowns::new(start)?;
    let mut n_residuals = None;
    let ask = |values: &[f64]| {
        let place = unknowns.with(values);
        let value =
            ctx.call(&function.value, std::slice::from_ref(&place)).map_err(|mut found| {
                found.others.retain(|other| other.span != ctx.span);
                Box::new(found.also(ctx.span, format!("asked at {place} from here")))
            })?;
        let mut all = Vec::new();
        residuals(&value, function.span, &mut all)?;
        let n_before = *n_residuals.get_or_insert(all.len());
        if all.len() != n_before || all.is_empty() {
            let message = format!(
                "the function yields {} numbers at {place}, and {n_before} before",
                all.len()
            );
            return Diagnostic::error(Code::WrongKind, function.span, message).fail();
        }
        Ok(all)
    };
    let found = find_least_squares(ask, &unknowns.values)?;
    let place = unknowns.with(&found.unknowns);
    let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let (left, first) = (size(&found.residuals), size(&found.first_residuals));
    let is_root = left <= SYSTEM_ROOT_RELATIVE * first;
    let is_overdetermined = unknowns.values.len() < found.residuals.len();
    if is_root || is_overdetermined && found.is_settled {
        return Ok((place, found));
    }
    let message = "no root was found from this start";
    Diagnostic::error(Code::NoAnswer, start.span, message)
        .label(format!("the search ended at {}", with_six_digits(&place)))
        .hint(format!(
            "of what is to be 0 there is {} left there, of {} at the start; another start may lead to a root",
            told(left, None),
            told(first, None)
        ))
        .fail()
}

/// A place as messages tell it.
fn with_six_digits(value: &Value) -> Value {
    let mut values = Vec::new();
    take_apart(value, &mut values);
    let six = |value: &f64| told(*value, Some(Dimension::NONE)).parse().unwrap_or(*value);
    put_together(value, &mut values.iter().map(six).collect::<Vec<f64>>().into_iter())
}
