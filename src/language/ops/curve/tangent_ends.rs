//! What tangents are asked for between, and which of them is meant.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, NurbsCurve, TangentEnd},
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Type, Value, shortest},
};

/// A point to go through, or a curve to touch.
#[derive(Clone)]
pub(super) enum TangentPlace {
    Point(DVec3),
    Curve(Curve),
}

impl FromValue for TangentPlace {
    const TYPE: Type = Type::OneOf(&[Type::Point, Type::Curve]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(point) => Ok(Self::Point(*point)),
            Value::Curve(curve) => Ok(Self::Curve(curve.clone())),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// It with the curve as a spline.
pub(super) enum TangentSource {
    Point(DVec3),
    Curve(Arc<NurbsCurve>),
}

impl TangentSource {
    fn of(place: &Spanned<TangentPlace>) -> Result<Self> {
        match &place.value {
            TangentPlace::Point(point) => Ok(Self::Point(*point)),
            TangentPlace::Curve(curve) => curve.spline().at(place.span).map(Self::Curve),
        }
    }

    /// It as the kernel takes it.
    pub(super) fn end(&self) -> TangentEnd<'_> {
        match self {
            Self::Point(point) => TangentEnd::Point(*point),
            Self::Curve(curve) => TangentEnd::Curve(curve),
        }
    }
}

/// Both ends, of which one is a curve at least.
///
/// # Errors
/// Two points; a parametric curve that no spline is near.
pub(super) fn sources(
    a: &Spanned<TangentPlace>,
    b: &Spanned<TangentPlace>,
    instead: &str,
    ctx: &Ctx<'_>,
) -> Result<[TangentSource; 2]> {
    if let [TangentPlace::Point(_), TangentPlace::Point(_)] = [&a.value, &b.value] {
        let message = "two points have nothing to touch: one of both must be a curve";
        return Diagnostic::error(Code::BadCall, ctx.span, message).hint(instead).fail();
    }
    Ok([TangentSource::of(a)?, TangentSource::of(b)?])
}

/// All tangents, or the one that is nearest to a point.
pub(super) struct Tangents(Value);

impl IntoValue for Tangents {
    const RETURNS: Type = Type::OneOf(&[Type::Curve, Type::List(&Type::Curve, 1)]);

    fn into_value(self) -> Value {
        self.0
    }
}

/// The tangents that were asked for.
///
/// # Errors
/// None at all; two that are equally near.
pub(super) fn chosen(
    what: &str,
    sources: &[TangentSource; 2],
    mut found: Vec<NurbsCurve>,
    near: Option<Spanned<DVec3>>,
    ctx: &Ctx<'_>,
) -> Result<Tangents> {
    if found.is_empty() {
        let message = match sources {
            [TangentSource::Curve(_), TangentSource::Curve(_)] => {
                format!("no {what} touches both curves")
            }
            [TangentSource::Point(point), _] | [_, TangentSource::Point(point)] => {
                let [x, y, z] = point.to_array().map(shortest);
                format!("no {what} from the point ({x}, {y}, {z}) touches the curve")
            }
        };
        let hint =
            "it touches a curve where that is, not where it could go on: `extend` makes it longer";
        return Diagnostic::error(Code::Degenerate, ctx.span, message).hint(hint).fail();
    }
    let Some(near) = near else { return Ok(Tangents(found.into_value())) };
    let mut order: Vec<(f64, usize)> = Vec::with_capacity(found.len());
    for (i, curve) in found.iter().enumerate() {
        order.push((curve.closest(near.value, ctx.tolerance.distance).distance, i));
    }
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let [first, second, ..] = order[..]
        && second.0 - first.0 <= ctx.tolerance.distance
    {
        let message = format!("of {} tangents two are equally near to the point", found.len());
        return Diagnostic::error(Code::Degenerate, near.span, message)
            .hint("give a point beside the one that is meant, or leave `near` out for the list of all")
            .fail();
    }
    let nearest = found.swap_remove(order[0].1);
    Ok(Tangents(nearest.into_value()))
}
