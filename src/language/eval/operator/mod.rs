//! What the operators do to values: a table that the machine, lanes and jets share, and errors that
//! name both sides.
//!
//! The value of a result, its unit and every mistake are those of plain numbers; where a side
//! carries derivatives, those of the result come on top.

mod arithmetic;
mod mistake;
pub(super) mod operand;
pub(super) mod table;

#[cfg(test)]
mod agreement;

use std::{borrow::Cow, sync::Arc};

use glam::DVec3;

use super::ir::{BinaryOp, UnaryOp};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{GeomError, LocalError, Tolerance},
    value::{
        At, BARE_AND_ANGLE, Discrepancy, FromValue, IntoValue, JetRange, Number, Range, Real,
        Switch, Value, Vector, deviation, equal,
    },
};
use mistake::{OF_OTHER_UNIT, inapplicable, mismatch, overflow, refused};
pub(super) use mistake::{limit_of_other_unit, of_other_unit};
pub(super) use operand::OperandPlaces;
use operand::Sides;
use table::{
    Arithmetic, BinaryMeaning, ComparisonRow, UnaryMeaning, binary_meaning, unary_meaning,
};

/// Arithmetic and comparison of bare numbers, the common case; `None` where more care is needed.
pub(super) fn plain(op: BinaryOp, a: Number, b: Number) -> Option<Value> {
    if !a.dim.is_bare() || !b.dim.is_bare() {
        return None;
    }
    match binary_meaning(op) {
        BinaryMeaning::Arithmetic(row) => {
            let value = (row.plain)(a.value, b.value);
            let dim = match a.dim == b.dim {
                true => a.dim,
                false => (row.dimension)(a.dim, b.dim, Some(b.value)).ok()?,
            };
            value.is_finite().then_some(Value::Number(Number { value, dim }))
        }
        BinaryMeaning::Comparison(row) => Some(Value::Bool((row.numbers)(a.value, b.value))),
        _ => None,
    }
}

/// Any binary operator but `and` and `or`, which may leave their right side alone.
pub(super) fn binary(
    op: BinaryOp,
    a: &Value,
    b: &Value,
    places: OperandPlaces,
    tolerance: Tolerance,
) -> Result<Value> {
    match binary_meaning(op) {
        BinaryMeaning::Arithmetic(row) => arithmetic(op, row, [a, b], places),
        BinaryMeaning::Comparison(row) => compare(op, row, [a, b], places).map(Value::Bool),
        BinaryMeaning::Near => near(a, b, tolerance.distance, places.whole).map(Value::Bool),
        BinaryMeaning::Range { closed } => range(a, b, closed, places.whole),
        BinaryMeaning::Logic { .. } => unreachable!("the machine evaluates these itself"),
    }
}

fn arithmetic(
    op: BinaryOp,
    row: &Arithmetic,
    [a, b]: [&Value; 2],
    places: OperandPlaces,
) -> Result<Value> {
    let takes = |sides| row.sides.contains(&sides);
    match (a, b) {
        (Value::Number(x), Value::Number(y)) => numbers(row, [*x, *y], places).map(Value::Number),
        (Value::Point(p), Value::Point(q)) if takes(Sides::Points) => points(row, *p, *q, places),
        (Value::Point(p), Value::Number(n)) if takes(Sides::PointByNumber) => {
            points(row, *p, factor(row, *n, places.right, places)?, places)
        }
        (Value::Number(n), Value::Point(p)) if takes(Sides::NumberByPoint) => {
            points(row, *p, factor(row, *n, places.left, places)?, places)
        }
        _ if a.is_jet() || b.is_jet() => {
            let plain = arithmetic(op, row, [&a.looked_at(), &b.looked_at()], places)?;
            with_derivatives(row, [a, b], plain, places)
        }
        _ => inapplicable(op, a, b, places),
    }
}

fn numbers(row: &Arithmetic, sides: [Number; 2], places: OperandPlaces) -> Result<Number> {
    let number = row
        .numbers(sides[0], sides[1])
        .map_err(|refusal| refused(refusal, row.verb, sides, places))?;
    if number.value.is_finite() { Ok(number) } else { overflow(places.whole) }
}

/// Coordinate by coordinate.
fn points(row: &Arithmetic, p: DVec3, q: DVec3, places: OperandPlaces) -> Result<Value> {
    let point = DVec3::new((row.plain)(p.x, q.x), (row.plain)(p.y, q.y), (row.plain)(p.z, q.z));
    if point.is_finite() { Ok(Value::Point(point)) } else { overflow(places.whole) }
}

/// A number, at a place of its own, that goes with each coordinate of a point: lengths count in
/// document units, and what holds an angle does not.
fn factor(row: &Arithmetic, number: Number, span: Span, places: OperandPlaces) -> Result<DVec3> {
    if number.dim.angle_power() != 0 {
        let message = format!("a point cannot be scaled by {}", number.dim);
        return Diagnostic::error(Code::UnitMismatch, span, message).fail();
    }
    match (row.refusal)(1.0, number.value) {
        Some(refusal) => Err(refused(refusal, row.verb, [Number::bare(1.0), number], places)),
        None => Ok(DVec3::splat(number.value)),
    }
}

/// The result of numbers and points, one of them with derivatives at least, about the plain result.
fn with_derivatives(
    row: &Arithmetic,
    [a, b]: [&Value; 2],
    plain: Value,
    places: OperandPlaces,
) -> Result<Value> {
    let vector = |value: &Value| Vector::from_value(value, places.whole).ok();
    let one = |a: &Real, b: &Real, plain: f64| derivatives(row, a, b, plain).at(places.whole);
    match plain {
        Value::Number(plain) => match (real(a), real(b)) {
            (Some(x), Some(y)) => {
                let value = one(&x, &y, plain.value)?;
                Ok(Number { value, dim: plain.dim }.into_value())
            }
            _ => Ok(Value::Number(plain)),
        },
        Value::Point(plain) => {
            let [p, q] = match (vector(a), vector(b), real(a), real(b)) {
                (Some(p), Some(q), ..) => [p.coordinates(), q.coordinates()],
                (Some(p), None, _, Some(n)) | (None, Some(p), Some(n), _) => {
                    [p.coordinates(), std::array::from_fn(|_| (*n).clone())]
                }
                _ => return Ok(Value::Point(plain)),
            };
            let coordinate = |axis: usize| one(&p[axis], &q[axis], plain[axis]);
            Ok(Vector::new([coordinate(0)?, coordinate(1)?, coordinate(2)?]).into_value())
        }
        other => Ok(other),
    }
}

/// The number that a value is, with its derivatives.
fn real(value: &Value) -> Option<Cow<'_, Real>> {
    match value {
        Value::Number(number) => Some(Cow::Owned(Real::Plain(number.value))),
        Value::Jet(number) => Some(Cow::Borrowed(&number.value)),
        _ => None,
    }
}

/// Two numbers with derivatives, about the plain result.
fn derivatives(
    row: &Arithmetic,
    a: &Real,
    b: &Real,
    plain: f64,
) -> std::result::Result<Real, GeomError> {
    let found = (row.derivatives)(a, b, plain)?;
    if found.is_finite() {
        Ok(found.with_value(plain))
    } else {
        Err(LocalError::DerivativeBeyondNumbers.into())
    }
}

/// What an operator decided of numbers that carry derivatives.
pub(super) fn switch(
    op: BinaryOp,
    [a, b]: [&Value; 2],
    value: &Value,
    span: Span,
) -> Option<Switch> {
    if !a.is_jet() && !b.is_jet() {
        return None;
    }
    let sides = real(a).zip(real(b));
    match (binary_meaning(op), value) {
        (BinaryMeaning::Comparison(_) | BinaryMeaning::Near, Value::Bool(truth)) => {
            let margin = sides.map(|(a, b)| a.minus(&b));
            Some(Switch { span, state: f64::from(u8::from(*truth)), margin })
        }
        _ if op == BinaryOp::Remainder => {
            let margin = sides.and_then(|(a, b)| a.over(&b).ok());
            let state = margin.as_ref().map_or(0.0, |margin| margin.value().floor());
            Some(Switch { span, state, margin })
        }
        _ => None,
    }
}

fn compare(
    op: BinaryOp,
    row: &ComparisonRow,
    [a, b]: [&Value; 2],
    places: OperandPlaces,
) -> Result<bool> {
    if let Some(of_equals) = row.of_equals {
        let is_equal = equal(a, b).ok_or_else(|| mismatch("compared", a, b, places))?;
        return Ok(is_equal == of_equals);
    }
    match (a, b) {
        (Value::Number(x), Value::Number(y)) => {
            x.dim.common(y.dim).ok_or_else(|| mismatch("compared", a, b, places))?;
            Ok((row.numbers)(x.value, y.value))
        }
        (Value::Text(x), Value::Text(y)) => Ok((row.texts)(x, y)),
        _ if a.is_jet() || b.is_jet() => compare(op, row, [&a.looked_at(), &b.looked_at()], places),
        _ => inapplicable(op, a, b, places),
    }
}

/// Whether two values are nearer than a tolerance.
pub(super) fn near(a: &Value, b: &Value, tolerance: f64, span: Span) -> Result<bool> {
    if let (Value::Number(x), Value::Number(y)) = (a.looked_at(), b.looked_at())
        && x.dim.common(y.dim).is_none()
    {
        let message = format!("{} and {} cannot be compared", x.dim, y.dim);
        return Diagnostic::error(Code::UnitMismatch, span, message).hint(OF_OTHER_UNIT).fail();
    }
    match deviation(a, b) {
        Discrepancy::Apart(distance, _) => Ok(distance <= tolerance),
        Discrepancy::Different(_) => Ok(false),
        Discrepancy::Incomparable(what) => Diagnostic::error(
            Code::WrongKind,
            span,
            format!(
                "`~=` compares numbers, points, and lists, records and tables of them; found {what}"
            ),
        )
        .fail(),
    }
}

/// `-x` and `not x`.
pub(super) fn unary(op: UnaryOp, value: &Value, span: Span) -> Result<Value> {
    let wrong_kind = |what: &str| {
        let message = format!("`{}` takes {what}, found {}", op.symbol(), value.phrase());
        Diagnostic::error(Code::WrongKind, span, message).fail()
    };
    match (unary_meaning(op), value) {
        (UnaryMeaning::Arithmetic(row), Value::Number(Number { value, dim })) => {
            Ok(Value::Number(Number { value: (row.plain)(*value), dim: *dim }))
        }
        (UnaryMeaning::Arithmetic(row), Value::Point(point)) => {
            Ok(Value::Point(DVec3::from(point.to_array().map(row.plain))))
        }
        (UnaryMeaning::Arithmetic(row), Value::Jet(number)) => {
            let value = (row.derivatives)(&number.value);
            Ok(Number { value, dim: number.dim }.into_value())
        }
        (UnaryMeaning::Arithmetic(row), Value::JetPoint(jets)) => {
            let coordinates = Vector::Jets(Box::new((**jets).clone())).coordinates();
            Ok(Vector::new(coordinates.map(|coordinate| (row.derivatives)(&coordinate)))
                .into_value())
        }
        (UnaryMeaning::Logic(truth_of), Value::Bool(truth)) => Ok(Value::Bool(truth_of(*truth))),
        (UnaryMeaning::Arithmetic(_), _) => wrong_kind("a number or a point"),
        (UnaryMeaning::Logic(_), _) => wrong_kind("true or false"),
    }
}

/// The range between two numbers.
fn range(a: &Value, b: &Value, closed: bool, span: Span) -> Result<Value> {
    match (a, b) {
        (Value::Number(start), Value::Number(end)) if start.beside(*end).is_some() => {
            Ok(Value::Range(Range { start: *start, end: *end, closed }))
        }
        (Value::Number(start), Value::Number(end)) => {
            let message = format!("a range from {} to {}", start.dim, end.dim);
            let found = Diagnostic::error(Code::UnitMismatch, span, message);
            let is_bare = start.dim.is_bare() || end.dim.is_bare();
            if is_bare { found.hint(BARE_AND_ANGLE) } else { found }.fail()
        }
        _ if a.is_jet() || b.is_jet() => {
            // Units and mistakes are those of the values.
            let plain = range(&a.looked_at(), &b.looked_at(), closed, span)?;
            let real = |value: &Value| Number::<Real>::from_value(value, span).ok();
            match (real(a), real(b)) {
                (Some(start), Some(end)) => {
                    Ok(Value::JetRange(Arc::new(JetRange { start, end, closed })))
                }
                _ => Ok(plain),
            }
        }
        _ => {
            let message = format!(
                "a range runs between two numbers, found {} and {}",
                a.phrase(),
                b.phrase()
            );
            Diagnostic::error(Code::WrongKind, span, message).fail()
        }
    }
}
