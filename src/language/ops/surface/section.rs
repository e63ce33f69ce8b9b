//! Sections of skins: what scripts give, brought to run beside one another.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Span},
    kernel::{Bounds, Curve, GeomError, NurbsCurve, SectionParameters, SectionSlope},
    value::{Choice, Ctx, FromValue, IntoValue, Mismatch, Type, Value, rounded},
};

/// A curve, or a point where a surface begins or ends.
#[derive(Clone, Debug)]
pub(super) enum SkinSection {
    Curve(Curve),
    Point(DVec3),
}

impl FromValue for SkinSection {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::Point]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self::Curve(curve.clone())),
            Value::Point(point) => Ok(Self::Point(*point)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl SkinSection {
    /// The section as a curve, which a point is one of.
    pub(super) fn curve(self) -> std::result::Result<Curve, GeomError> {
        match self {
            Self::Point(point) => NurbsCurve::bezier(&[point]).map(Curve::from),
            Self::Curve(curve) => Ok(curve),
        }
    }
}

/// Warns of neighbours with different numbers of corners: an edge of the surface ends between them.
pub(super) fn warn_of_lost_corners(
    ctx: &mut Ctx<'_>,
    unpaired: &[[(usize, usize); 2]],
    span: Span,
) {
    let Some(&[(own, n), (other, n_others)]) = unpaired.first() else { return };
    let [(a, of_a), (b, _)] = [own, other].map(|i| ctx.element(span, i, "sections"));
    let corners = |n: usize| if n == 1 { "1 corner".to_owned() } else { format!("{n} corners") };
    let message = format!(
        "{a} has {}, its neighbour {b} has {}, so that not all of them lie on an edge of the surface",
        corners(n),
        corners(n_others)
    );
    ctx.warn(
        Diagnostic::warning(Code::Unclean, of_a, message)
            .hint("their seams are at corners; with `align = false` all sections stay as they are"),
    );
}

/// Where sections stand along v.
#[derive(Clone, Debug)]
pub(in crate::ops) enum SectionPlaces {
    By(SectionParameters),
    Listed(Vec<f64>),
}

impl Choice for SectionParameters {
    const WORDS: &'static [&'static str] = &["average", "places", "centripetal", "uniform"];
    const MEANINGS: &'static [Self] =
        &[Self::Average, Self::Places, Self::Centripetal, Self::Uniform];
}

impl FromValue for SectionPlaces {
    const TYPE: Type = Type::OneOf(&[SectionParameters::TYPE, Type::List(&Type::Ratio, 0)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Text(_) => SectionParameters::from_value(value, span).map(Self::By),
            Value::List(_) | Value::Range(_) => Vec::from_value(value, span).map(Self::Listed),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl IntoValue for SectionPlaces {
    const RETURNS: Type = Self::TYPE;

    fn into_value(self) -> Value {
        match self {
            Self::By(rule) => rule.into_value(),
            Self::Listed(parameters) => parameters.into_value(),
        }
    }
}

/// A derivative along a section.
#[derive(Clone, Debug)]
pub(in crate::ops) enum SectionTangent {
    Vector(DVec3),
    Curve(Arc<NurbsCurve>),
}

impl SectionTangent {
    /// What it is to a skin.
    pub(super) fn slope(&self) -> SectionSlope {
        match self {
            Self::Vector(vector) => SectionSlope::Vector(*vector),
            Self::Curve(curve) => SectionSlope::Curve(Arc::clone(curve)),
        }
    }
}

impl FromValue for SectionTangent {
    const TYPE: Type = Type::OneOf(&[Type::Point, Type::Curve]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(vector) => Ok(Self::Vector(*vector)),
            Value::Curve(_) => Arc::from_value(value, span).map(Self::Curve),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// What the surface may do between sections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::ops) enum SectionShape {
    Free,
    Monotone,
}

impl Choice for SectionShape {
    const WORDS: &'static [&'static str] = &["free", "monotone"];
    const MEANINGS: &'static [Self] = &[Self::Free, Self::Monotone];
}

/// Which points of two sections belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::ops) enum SectionPairing {
    Parameter,
    Length,
}

impl Choice for SectionPairing {
    const WORDS: &'static [&'static str] = &["parameter", "length"];
    const MEANINGS: &'static [Self] = &[Self::Parameter, Self::Length];
}

/// Warns of neighbouring sections that cross.
pub(super) fn warn_of_crossings(
    ctx: &mut Ctx<'_>,
    sections: &[NurbsCurve],
    span: Span,
    tolerance: f64,
) {
    for (k, pair) in sections.windows(2).enumerate() {
        if pair.iter().any(NurbsCurve::is_point) {
            continue;
        }
        let [a, b] = [0, 1].map(|i| Bounds::of(pair[i].points()));
        let are_apart = a.zip(b).is_none_or(|(a, b)| !a.is_near(b, tolerance));
        if are_apart {
            continue;
        }
        let Ok(meetings) = pair[0].intersections(&pair[1], tolerance) else { continue };
        let is_inner = |curve: &NurbsCurve, t: f64| {
            let domain = curve.domain();
            domain.start() < t && t < domain.end()
        };
        // At common ends surfaces may well come together in a point.
        let crossing =
            meetings.iter().find(|m| is_inner(&pair[0], m.first) && is_inner(&pair[1], m.second));
        let Some(meeting) = crossing else { continue };
        let [x, y, z] = meeting.point.to_array().map(rounded);
        let [(a, _), (b, of_b)] = [k, k + 1].map(|i| ctx.element(span, i, "sections"));
        let message =
            format!("{a} and {b} cross at ({x}, {y}, {z}), so that the surface crosses itself");
        ctx.warn(
            Diagnostic::warning(Code::SelfIntersecting, of_b, message)
                .hint("sections lie beside one another; leave one of them out, or move it"),
        );
        return;
    }
}
