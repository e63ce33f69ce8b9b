//! Lists.

mod any;
mod argmax;
mod argmin;
mod contains;
mod cosspace;
mod every;
mod filter;
mod first;
mod flatten;
mod fold;
mod index_of;
mod last;
mod len;
mod linspace;
mod map;
mod mean;
mod order;
mod product;
mod range;
mod reverse;
mod scan;
mod sort;
mod sum;
mod transpose;
mod unique;
mod zip;

use glam::DVec3;

use order::extreme_index;

use super::math::{common_dim, finite, mismatch};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    limits::{Ceiling, work},
    value::{
        Callback, CommonDimension, Ctx, Dimension, FromValue, List, Number, Op, Real, Value,
        Vector, Witness, WitnessOf,
    },
};

pub(super) static OPS: &[&Op] = &[
    &any::OP,
    &argmax::OP,
    &argmin::OP,
    &contains::OP,
    &cosspace::OP,
    &every::OP,
    &filter::OP,
    &first::OP,
    &flatten::OP,
    &fold::OP,
    &index_of::OP,
    &last::OP,
    &len::OP,
    &linspace::OP,
    &map::OP,
    &mean::OP,
    &product::OP,
    &range::OP,
    &reverse::OP,
    &scan::OP,
    &sort::OP,
    &sum::OP,
    &transpose::OP,
    &unique::OP,
    &zip::OP,
];

/// Fails when a list would grow beyond its ceiling.
pub(super) fn check_length(n: f64, ctx: &Ctx<'_>) -> Result<()> {
    let most = ctx.limits.list_length;
    if n <= most as f64 {
        return Ok(());
    }
    let many = if n < 1e15 { n.to_string() } else { "more than 1e15".to_owned() };
    let message = format!("a list of {many} elements; the ceiling is {most}");
    Diagnostic::error(Code::TooLarge, ctx.span, message).crossing(Ceiling::LIST_LENGTH).fail()
}

/// A sum.
enum RunningSum {
    Number(Number<Real>),
    Point(Vector),
}

/// The sum of numbers or points.
fn total(items: &List, span: Span) -> Result<RunningSum> {
    if let Some((values, dim)) = items.numbers() {
        return total_of_numbers(values, dim, span).map(RunningSum::Number);
    }
    let stranger = |item: &Value| {
        let message = format!("numbers can be added, and points, but not {}", item.phrase());
        Box::new(Diagnostic::error(Code::WrongKind, span, message))
    };
    let (mut value, mut dim) = (Real::Plain(0.0), CommonDimension::default());
    let mut point = Vector::Plain(DVec3::ZERO);
    let items: &[Value] = if work::passes(items.len()) { items } else { &[] };
    for (i, item) in items.iter().enumerate() {
        match (item.kind(), items[0].kind()) {
            ("number", "number") => {
                let number = Number::<Real>::from_value(item, span).map_err(|_| stranger(item))?;
                dim.take(number.looked_at()).map_err(|dims| mismatch(dims, span))?;
                value = value.plus(&number.value);
            }
            ("point", "point") => {
                let summand = Vector::from_value(item, span).map_err(|_| stranger(item))?;
                point = point.plus(&summand);
            }
            ("number" | "point", _) if i > 0 => {
                return Diagnostic::error(
                    Code::WrongKind,
                    span,
                    "numbers and points cannot be added",
                )
                .fail();
            }
            _ => return Err(stranger(item)),
        }
    }
    Ok(match items.first().map(Value::kind) {
        Some("point") => RunningSum::Point(point),
        _ => RunningSum::Number(Number { value: finite(value, span)?, dim: dim.dimension() }),
    })
}

/// The sum of numbers of one dimension, which are not spelled out as values for it.
fn total_of_numbers(values: &[f64], dim: Dimension, span: Span) -> Result<Number<Real>> {
    let values = if work::passes(values.len()) { values } else { &[] };
    let mut common = CommonDimension::default();
    let mut sum = 0.0;
    for &value in values {
        common.take(Number { value, dim }).map_err(|dims| mismatch(dims, span))?;
        sum += value;
    }
    Ok(Number { value: finite(Real::Plain(sum), span)?, dim: common.dimension() })
}

/// The first element that passes a test, or fails it; the claim that asks is told.
fn first_that(
    ctx: &mut Ctx<'_>,
    list: List,
    test: Option<Callback>,
    passes: bool,
) -> Result<Option<usize>> {
    let mut found = None;
    for (idx, item) in list.iter().enumerate() {
        let holds = match &test {
            Some(test) => truth(ctx, test, item)?,
            None => as_truth(item, ctx.span)?,
        };
        if holds == passes {
            found = Some(idx);
            break;
        }
    }
    let of = found.map_or(WitnessOf::All, WitnessOf::Element);
    ctx.decided(Witness { of, list, test: test.map(|test| test.0) });
    Ok(found)
}

/// What a test says of an element.
fn truth(ctx: &mut Ctx<'_>, test: &Callback, item: &Value) -> Result<bool> {
    let verdict = ctx.call(test, std::slice::from_ref(item))?;
    as_truth(&verdict, ctx.span)
}

fn as_truth(value: &Value, span: Span) -> Result<bool> {
    match value {
        Value::Bool(truth) => Ok(*truth),
        other => {
            let message = format!("the test must be true or false, found {}", other.phrase());
            Diagnostic::error(Code::WrongKind, span, message).fail()
        }
    }
}

/// `n` numbers from `a` to `b`, both exactly; `place` tells where between them, from 0 to 1, the
/// number at a fraction of the way through the list lies.
fn spaced(
    a: Number<Real>,
    b: Number<Real>,
    n: usize,
    ctx: &Ctx<'_>,
    place: fn(f64) -> f64,
) -> Result<Vec<Number<Real>>> {
    let dim = common_dim([&a, &b].into_iter().map(Number::looked_at), ctx.span)?;
    check_length(n as f64, ctx)?;
    let number = |i: usize| {
        let value = match i {
            0 => a.value.clone(),
            _ if i + 1 == n => b.value.clone(),
            _ => {
                let t = place(i as f64 / (n - 1) as f64);
                a.value.scaled(1.0 - t).plus(&b.value.scaled(t))
            }
        };
        Number { value, dim }
    };
    Ok((0..n).map(number).collect())
}
