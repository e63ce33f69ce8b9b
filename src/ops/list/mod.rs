//! Lists.

mod any;
mod cosspace;
mod every;
mod filter;
mod first;
mod flatten;
mod fold;
mod last;
mod len;
mod linspace;
mod map;
mod mean;
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

use super::math::{common_dim, finite};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{Callback, Ctx, Dim, Number, Op, Value},
};

pub(super) static OPS: &[&Op] = &[
    &any::OP,
    &cosspace::OP,
    &every::OP,
    &filter::OP,
    &first::OP,
    &flatten::OP,
    &fold::OP,
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
    let message = format!("a list of {n} elements; the ceiling is {most}");
    Diagnostic::error(Code::TooLarge, ctx.span, message).fail()
}

/// The sum of numbers or points.
fn total(items: &[Value], span: Span) -> Result<Value> {
    let mismatch = |item: &Value| {
        let message = format!("numbers can be added, and points, but not {}", item.phrase());
        Diagnostic::error(Code::WrongKind, span, message).fail()
    };
    let (mut value, mut point, mut dim) = (0.0, DVec3::ZERO, Dim::NONE);
    for (i, item) in items.iter().enumerate() {
        match (item, &items[0]) {
            (Value::Number(number), Value::Number(_)) => {
                dim = common_dim(&[Number { value, dim }, *number], span)?;
                value += number.value;
            }
            (Value::Point(summand), Value::Point(_)) => point += *summand,
            (Value::Number(_) | Value::Point(_), _) if i > 0 => {
                return Diagnostic::error(
                    Code::WrongKind,
                    span,
                    "numbers and points cannot be added",
                )
                .fail();
            }
            _ => return mismatch(item),
        }
    }
    if let Some(Value::Point(_)) = items.first() {
        return Ok(Value::Point(point));
    }
    Ok(Value::Number(Number { value: finite(value, span)?, dim }))
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
    a: Number,
    b: Number,
    n: usize,
    ctx: &Ctx<'_>,
    place: fn(f64) -> f64,
) -> Result<Vec<Number>> {
    let dim = common_dim(&[a, b], ctx.span)?;
    check_length(n as f64, ctx)?;
    let number = |i: usize| {
        let value = match i {
            0 => a.value,
            _ if i + 1 == n => b.value,
            _ => {
                let t = place(i as f64 / (n - 1) as f64);
                a.value * (1.0 - t) + b.value * t
            }
        };
        Number { value, dim }
    };
    Ok((0..n).map(number).collect())
}
