//! Arithmetic and calls of geometry in functions that are differentiated.
//!
//! The value of a result, its unit and every mistake are those of plain arithmetic on the values;
//! the derivatives come on top.

use super::{
    ir::BinaryOp,
    operator::{self, OperandPlaces},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, GeomError, Interval, LocalError, Side, Surface, jet},
    value::{At, CARRIES_DERIVATIVES, FromValue, IntoValue, Number, Real, Value, Vector},
};

/// Arithmetic of numbers and points, one of them with derivatives at least.
pub(super) fn arithmetic(
    op: BinaryOp,
    a: &Value,
    b: &Value,
    places: OperandPlaces,
) -> Result<Value> {
    use BinaryOp as Op;
    let plain = operator::arithmetic(op, &a.looked_at(), &b.looked_at(), places)?;
    let real =
        |value: &Value| Number::<Real>::from_value(value, places.whole).ok().map(|n| n.value);
    let vector = |value: &Value| Vector::from_value(value, places.whole).ok();
    if let Value::Number(plain) = plain
        && let (Some(x), Some(y)) = (real(a), real(b))
    {
        let value = numbers(op, &x, &y, plain.value, places)?;
        return Ok(Number { value, dim: plain.dim }.into_value());
    }
    let found = match (op, vector(a), vector(b)) {
        (Op::Add, Some(p), Some(q)) => Some(p.plus(&q)),
        (Op::Subtract, Some(p), Some(q)) => Some(p.minus(&q)),
        (Op::Multiply, Some(p), None) => real(b).map(|n| p.times(&n)),
        (Op::Multiply, None, Some(p)) => real(a).map(|n| p.times(&n)),
        (Op::Divide, Some(p), None) => match real(b) {
            Some(n) => Some(p.over(&n).at(places.whole)?),
            None => None,
        },
        _ => None,
    };
    Ok(found.map_or(plain, IntoValue::into_value))
}

/// Arithmetic of two numbers whose result, without derivatives, is `plain`.
fn numbers(op: BinaryOp, a: &Real, b: &Real, plain: f64, places: OperandPlaces) -> Result<Real> {
    use BinaryOp as Op;
    let found = match op {
        Op::Add => a.plus(b),
        Op::Subtract => a.minus(b),
        Op::Multiply => a.times(b),
        Op::Divide => a.over(b).at(places.whole)?,
        Op::Remainder => {
            if plain == 0.0 {
                let error = GeomError::Local(LocalError::NotDifferentiable {
                    what: "the remainder",
                    at: a.value(),
                });
                return Err(error).at(places.whole);
            }
            // Between its jumps the remainder is a difference.
            let n_times = ((a.value() - plain) / b.value()).round();
            a.minus(&b.scaled(n_times))
        }
        _ => power(a, b).at(places.whole)?,
    };
    if !found.is_finite() {
        return Err(LocalError::DerivativeBeyondNumbers.into()).at(places.whole);
    }
    Ok(match found {
        Real::Jet(jet) => Real::Jet(jet.with_value(plain)),
        Real::Plain(_) => Real::Plain(plain),
    })
}

fn power(base: &Real, exponent: &Real) -> std::result::Result<Real, GeomError> {
    match (base, exponent) {
        (Real::Jet(base), Real::Plain(exponent)) => base.power(*exponent).map(Real::Jet),
        (_, Real::Jet(exponent)) => base.like(exponent).power_of(exponent).map(Real::Jet),
        (Real::Plain(base), Real::Plain(exponent)) => Ok(Real::Plain(libm::pow(*base, *exponent))),
    }
}

/// `-x` of what carries derivatives.
pub(super) fn negated(value: &Value, span: Span) -> Result<Value> {
    let minus = Real::Plain(-1.0);
    if let Ok(vector) = Vector::from_value(value, span) {
        return Ok(vector.times(&minus).into_value());
    }
    match Number::<Real>::from_value(value, span) {
        Ok(number) => {
            Ok(Number { value: number.value.times(&minus), dim: number.dim }.into_value())
        }
        Err(_) => Ok(value.clone()),
    }
}

/// A parameter inside a domain.
fn inside(domain: Interval, t: Spanned<Real>) -> Result<Real> {
    let clamped = domain.clamp_inside(t.value.value()).at(t.span)?;
    Ok(match t.value {
        Real::Plain(_) => Real::Plain(clamped),
        Real::Jet(jet) => Real::Jet(jet.with_value(clamped)),
    })
}

/// The point of a curve at a parameter that may carry derivatives.
pub(super) fn point_on_curve(curve: &Curve, t: Spanned<Real>, span: Span) -> Result<Value> {
    match &inside(curve.domain(), t)? {
        Real::Plain(t) => curve.point_at(*t).at(span).map(Value::Point),
        Real::Jet(t) => {
            // At a knot the piece counts that the parameter moves into.
            let side = if t.is_growing() { Side::Right } else { Side::Left };
            let derivatives = curve.derivatives_beside(t.value(), side, t.order()).at(span)?;
            let jets = jet::along(&derivatives, t).at(span)?;
            Ok(Vector::Jets(Box::new(jets)).into_value())
        }
    }
}

/// The point of a surface at parameters that may carry derivatives.
pub(super) fn point_on_surface(
    surface: &Surface,
    parameters: [Spanned<Real>; 2],
    span: Span,
) -> Result<Value> {
    let [u, v] = parameters;
    let (u, v) = match (inside(surface.domain_u(), u)?, inside(surface.domain_v(), v)?) {
        (Real::Plain(u), Real::Plain(v)) => {
            return surface.point_at(u, v).at(span).map(Value::Point);
        }
        (Real::Jet(u), v) => {
            let v = v.like(&u);
            (u, v)
        }
        (u, Real::Jet(v)) => (u.like(&v), v),
    };
    let derivatives = surface.derivatives_at(u.value(), v.value(), u.order()).at(span)?;
    let jets = jet::across(&derivatives, &u, &v).at(span)?;
    Ok(Vector::Jets(Box::new(jets)).into_value())
}

/// Fails: nothing there could carry the derivatives on.
pub(super) fn no_derivative<T>(what: &str, span: Span) -> Result<T> {
    let message = format!("{what} cannot be differentiated");
    Diagnostic::error(Code::NoDerivative, span, message).hint(CARRIES_DERIVATIVES).fail()
}
