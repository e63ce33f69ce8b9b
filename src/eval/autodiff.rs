//! Calls of geometry in functions that are differentiated.
//!
//! The point and every mistake are those of the plain parameters; the derivatives come on top. What
//! operators do to derivatives stands in the table of operators.

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, Interval, Side, Surface, jet},
    value::{At, CARRIES_DERIVATIVES, IntoValue, Real, Value, Vector},
};

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
