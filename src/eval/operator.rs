//! What the operators do to values: one function a family, and the errors that name both sides.

use std::sync::Arc;

use super::{
    autodiff,
    ir::{BinaryOp, UnaryOp},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::Tolerance,
    value::{
        Dimension, Discrepancy, FromValue, JetRange, Number, Range, Real, Value, deviation, equal,
    },
};

/// Where an operation and its two sides stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct OperandPlaces {
    pub(super) whole: Span,
    pub(super) left: Span,
    pub(super) right: Span,
}

/// Arithmetic and comparison of bare numbers, the common case; `None` where more care is needed.
#[expect(clippy::float_cmp, reason = "exact equality is what `==` means")]
pub(super) fn plain(op: BinaryOp, a: Number, b: Number) -> Option<Value> {
    if !a.dim.is_none() || !b.dim.is_none() {
        return None;
    }
    let (a, b) = (a.value, b.value);
    let value = match op {
        BinaryOp::Add => a + b,
        BinaryOp::Subtract => a - b,
        BinaryOp::Multiply => a * b,
        BinaryOp::Divide if b != 0.0 => a / b,
        BinaryOp::Less => return Some(Value::Bool(a < b)),
        BinaryOp::LessEqual => return Some(Value::Bool(a <= b)),
        BinaryOp::Greater => return Some(Value::Bool(a > b)),
        BinaryOp::GreaterEqual => return Some(Value::Bool(a >= b)),
        BinaryOp::Equal => return Some(Value::Bool(a == b)),
        BinaryOp::NotEqual => return Some(Value::Bool(a != b)),
        _ => return None,
    };
    value.is_finite().then(|| Value::number(value))
}

/// Any binary operator but `and` and `or`, which may leave their right side alone.
pub(super) fn binary(
    op: BinaryOp,
    a: &Value,
    b: &Value,
    places: OperandPlaces,
    tolerance: Tolerance,
) -> Result<Value> {
    use BinaryOp as Op;
    match op {
        Op::Add | Op::Subtract | Op::Multiply | Op::Divide | Op::Remainder | Op::Power => {
            arithmetic(op, a, b, places)
        }
        Op::Equal | Op::NotEqual => {
            let is_equal = equal(a, b).ok_or_else(|| mismatch("compared", a, b, places))?;
            Ok(Value::Bool(is_equal == (op == Op::Equal)))
        }
        Op::Less | Op::LessEqual | Op::Greater | Op::GreaterEqual => {
            order(op, a, b, places).map(Value::Bool)
        }
        Op::Near => near(a, b, tolerance.distance, places.whole).map(Value::Bool),
        Op::Range => range(a, b, true, places.whole),
        Op::RangeBelow => range(a, b, false, places.whole),
        Op::And | Op::Or => unreachable!("the machine evaluates these itself"),
    }
}

pub(super) fn arithmetic(
    op: BinaryOp,
    a: &Value,
    b: &Value,
    places: OperandPlaces,
) -> Result<Value> {
    use BinaryOp as Op;
    match (a, op, b) {
        (Value::Number(x), _, Value::Number(y)) => numbers(op, *x, *y, places).map(Value::Number),
        (Value::Point(p), Op::Add, Value::Point(q)) => finite_point(*p + *q, places),
        (Value::Point(p), Op::Subtract, Value::Point(q)) => finite_point(*p - *q, places),
        (Value::Point(p), Op::Multiply, Value::Number(n)) => {
            finite_point(*p * factor(*n, places.right)?, places)
        }
        (Value::Number(n), Op::Multiply, Value::Point(p)) => {
            finite_point(*p * factor(*n, places.left)?, places)
        }
        (Value::Point(p), Op::Divide, Value::Number(n)) => {
            let n = factor(*n, places.right)?;
            if n == 0.0 {
                return zero_divisor(places);
            }
            finite_point(*p / n, places)
        }
        _ if a.is_jet() || b.is_jet() => autodiff::arithmetic(op, a, b, places),
        _ => inapplicable(op, a, b, places),
    }
}

/// A number that a point can be multiplied by: lengths count in document units.
fn factor(number: Number, span: Span) -> Result<f64> {
    let has_angle = Dimension::LENGTH.over(number.dim).is_none() || number.dim == Dimension::ANGLE;
    if has_angle {
        return Diagnostic::error(Code::UnitMismatch, span, "a point cannot be scaled by an angle")
            .fail();
    }
    Ok(number.value)
}

fn finite_point(point: glam::DVec3, places: OperandPlaces) -> Result<Value> {
    if point.is_finite() { Ok(Value::Point(point)) } else { overflow(places.whole) }
}

/// Arithmetic of two numbers with their dimensions.
pub(super) fn numbers(op: BinaryOp, a: Number, b: Number, places: OperandPlaces) -> Result<Number> {
    use BinaryOp as Op;
    let common = || {
        a.dim.common(b.dim).ok_or_else(|| {
            let verb = match op {
                Op::Add => "added",
                Op::Subtract => "subtracted",
                _ => "divided with remainder",
            };
            mismatch(verb, &Value::Number(a), &Value::Number(b), places)
        })
    };
    let too_high = || {
        Box::new(Diagnostic::error(
            Code::UnitMismatch,
            places.whole,
            "the power of the unit is too high",
        ))
    };
    let (value, dim) = match op {
        Op::Add => (a.value + b.value, common()?),
        Op::Subtract => (a.value - b.value, common()?),
        Op::Multiply => (a.value * b.value, a.dim.times(b.dim).ok_or_else(too_high)?),
        Op::Divide | Op::Remainder if b.value == 0.0 => return zero_divisor(places),
        Op::Divide => (a.value / b.value, a.dim.over(b.dim).ok_or_else(too_high)?),
        Op::Remainder => (remainder(a.value, b.value), common()?),
        _ => return power(a, b, places),
    };
    if value.is_finite() { Ok(Number { value, dim }) } else { overflow(places.whole) }
}

/// The remainder with the sign of the divisor.
pub(super) fn remainder(a: f64, b: f64) -> f64 {
    let rest = a % b;
    if rest != 0.0 && (rest < 0.0) != (b < 0.0) { rest + b } else { rest }
}

fn power(base: Number, exponent: Number, places: OperandPlaces) -> Result<Number> {
    if !exponent.dim.is_none() {
        let message = format!("an exponent has no unit, found {}", exponent.dim);
        return Diagnostic::error(Code::UnitMismatch, places.right, message).fail();
    }
    if base.value == 0.0 && exponent.value < 0.0 {
        return Diagnostic::error(Code::DivisionByZero, places.whole, "zero has no negative power")
            .also(places.left, "this is 0")
            .fail();
    }
    if base.value < 0.0 && exponent.value.fract() != 0.0 {
        let message = format!("a negative number ({base}) has no power of {exponent}");
        return Diagnostic::error(Code::Domain, places.whole, message).fail();
    }
    let Some(dim) = base.dim.power(exponent.value) else {
        let message = format!("{} cannot be raised to the power {exponent}", base.dim);
        return Diagnostic::error(Code::UnitMismatch, places.whole, message)
            .hint("divide by `1mm` or `1rad` first to take the unit away")
            .fail();
    };
    let value = libm::pow(base.value, exponent.value);
    if value.is_finite() { Ok(Number { value, dim }) } else { overflow(places.whole) }
}

fn zero_divisor<T>(places: OperandPlaces) -> Result<T> {
    Diagnostic::error(Code::DivisionByZero, places.whole, "division by zero")
        .also(places.right, "this is 0")
        .fail()
}

fn overflow<T>(span: Span) -> Result<T> {
    Diagnostic::error(Code::Domain, span, "the result is beyond the largest number, 1.8e308")
        .label("too large")
        .fail()
}

/// Two values whose units do not go together.
fn mismatch(verb: &str, a: &Value, b: &Value, places: OperandPlaces) -> Box<Diagnostic> {
    let message = format!("{} and {} cannot be {verb}", noun(a), noun(b));
    Box::new(
        Diagnostic::error(Code::UnitMismatch, places.whole, message)
            .also(places.left, format!("this is {}", noun(a)))
            .also(places.right, format!("this is {}", noun(b)))
            .hint(
                "divide by a unit, such as `1mm` or `1deg`, to make a plain number of a quantity",
            ),
    )
}

/// A value by its dimension, else by its kind.
fn noun(value: &Value) -> String {
    match value {
        Value::Number(number) => number.dim.to_string(),
        other => other.phrase(),
    }
}

fn inapplicable(op: BinaryOp, a: &Value, b: &Value, places: OperandPlaces) -> Result<Value> {
    use BinaryOp as Op;
    let message = format!("`{}` cannot work on {} and {}", op.symbol(), a.phrase(), b.phrase());
    let diagnostic = Diagnostic::error(Code::WrongKind, places.whole, message)
        .also(places.left, format!("this is {}", a.phrase()))
        .also(places.right, format!("this is {}", b.phrase()));
    match (a, op, b) {
        (Value::List(_), Op::Add, Value::List(_)) => {
            diagnostic.hint("join lists by `[...a, ...b]`")
        }
        (Value::Text(_), Op::Add, _) | (_, Op::Add, Value::Text(_)) => {
            diagnostic.hint("join texts by interpolation: \"{a}{b}\"")
        }
        (Value::List(_), _, Value::Number(_)) | (Value::Number(_), _, Value::List(_)) => {
            diagnostic.hint("for each element: `[for x in xs: ...]`")
        }
        (Value::Point(_), Op::Add | Op::Subtract, Value::Number(_))
        | (Value::Number(_), Op::Add | Op::Subtract, Value::Point(_)) => {
            diagnostic.hint("points are added to points: `p + (1, 0, 0)`; numbers multiply them")
        }
        (Value::Point(_), Op::Multiply, Value::Point(_)) => {
            diagnostic.hint("`dot(a, b)` and `cross(a, b)` multiply vectors")
        }
        (Value::Curve(_) | Value::Surface(_) | Value::Mesh(_), _, Value::Point(_)) => {
            diagnostic.hint("move geometry by `translate(g, v)`")
        }
        _ => diagnostic,
    }
    .fail()
}

fn order(op: BinaryOp, a: &Value, b: &Value, places: OperandPlaces) -> Result<bool> {
    let ordering = match (a, b) {
        (Value::Number(x), Value::Number(y)) => {
            x.dim.common(y.dim).ok_or_else(|| mismatch("compared", a, b, places))?;
            x.value.partial_cmp(&y.value)
        }
        (Value::Text(x), Value::Text(y)) => Some(x.cmp(y)),
        _ if a.is_jet() || b.is_jet() => {
            return order(op, &a.looked_at(), &b.looked_at(), places);
        }
        _ => return inapplicable(op, a, b, places).map(|_| false),
    };
    Ok(match op {
        BinaryOp::Less => ordering.is_some_and(std::cmp::Ordering::is_lt),
        BinaryOp::LessEqual => ordering.is_some_and(std::cmp::Ordering::is_le),
        BinaryOp::Greater => ordering.is_some_and(std::cmp::Ordering::is_gt),
        _ => ordering.is_some_and(std::cmp::Ordering::is_ge),
    })
}

/// Whether two values are nearer than a tolerance.
pub(super) fn near(a: &Value, b: &Value, tolerance: f64, span: Span) -> Result<bool> {
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
    match (op, value) {
        (UnaryOp::Negate, Value::Number(number)) => {
            Ok(Value::Number(Number { value: -number.value, dim: number.dim }))
        }
        (UnaryOp::Negate, Value::Point(point)) => Ok(Value::Point(-*point)),
        (UnaryOp::Negate, Value::Jet(_) | Value::JetPoint(_)) => autodiff::negated(value, span),
        (UnaryOp::Not, Value::Bool(truth)) => Ok(Value::Bool(!truth)),
        (UnaryOp::Negate, other) => Diagnostic::error(
            Code::WrongKind,
            span,
            format!("`-` takes a number or a point, found {}", other.phrase()),
        )
        .fail(),
        (UnaryOp::Not, other) => Diagnostic::error(
            Code::WrongKind,
            span,
            format!("`not` takes true or false, found {}", other.phrase()),
        )
        .fail(),
    }
}

/// The range between two numbers.
fn range(a: &Value, b: &Value, closed: bool, span: Span) -> Result<Value> {
    match (a, b) {
        (Value::Number(start), Value::Number(end)) if start.dim.common(end.dim).is_some() => {
            Ok(Value::Range(Range { start: *start, end: *end, closed }))
        }
        (Value::Number(start), Value::Number(end)) => {
            let message = format!("a range from {} to {}", start.dim, end.dim);
            Diagnostic::error(Code::UnitMismatch, span, message).fail()
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
