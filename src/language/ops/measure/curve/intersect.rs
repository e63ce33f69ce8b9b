//! `intersect` a curve with another, or with a surface.

use std::sync::Arc;

use super::varying;
use crate::{
    diag::{Result, Span},
    kernel::{CurveIntersection, Side},
    ops::{face::RealSurfaceOrFace, measure::piercing::pierced},
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Real, RealCurve, Record, Type, Value, op},
};

op! {
    /// Every place where two curves come within the document's tolerance of one another, as
    /// `[{t, s, point}]` in the order of `t`: `t` on the first, `s` on the second; or of a curve and a
    /// surface, as `[{t, u, v, point}]`.
    ///
    /// Found completely, by halving pairs of pieces until they are apart, cross clearly or touch.
    /// Where they touch, in whatever order, is one place: the nearest, from which the distance rises on
    /// both sides. Curves that share a stretch are an error that tells which.
    /// A parametric curve is searched as the spline that `length` tells of; each place is then found
    /// on the function itself.
    /// Where two curves cross clearly, inside of both, derivatives pass through; of what moves out of the plane of both
    /// tangents there is none in `t` and `s`. So they do where a curve crosses a surface.
    /// Sederberg & Nishita, *Curve intersection using Bézier clipping*, CAD 22 (1990).
    intersect in Measure -> Vec<Record> {
        /// One curve.
        a: RealCurve,
        /// The other, or a surface or face.
        b: CurvePartner,
    }
    example "intersect(line((0, 0), (4, 4)), line((0, 2), (4, 2)))" => "[{t: 0.5, s: 0.5, point: (2, 2, 0)}]";
    example "intersect(line((0, 0), (1, 0)), line((0, 1), (1, 1)))" => "[]";
    example "intersect(line((0, 0, -1), (0, 0, 3)), plane_patch((-1, -1), (2, 0), (0, 2)))" => "[{t: 0.25, u: 0.5, v: 0.5, point: (0, 0, 0)}]";
    example "gradient(h => intersect(line((0, 0), (4, 4)), line((0, h), (4, h)))[0].t, 2) ~= 1/4" => "true";
    example "gradient(z => intersect(line((0, 0), (0, 0, 4)), plane_patch((-1, -1, z), (2, 0), (0, 2)))[0].t, 2) ~= 1/4" => "true";
    refuses "intersect(line((0, 0), (4, 0)), line((1, 0), (3, 0)))" => "E0607: the curves run together from parameter 0.25 to 0.75 of the first";
    scene r#"
        curve a = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        curve b = circle((2, 0.5), 1.2)
        points places = [for meeting in intersect(a, b): meeting.point] with (color = "red")
    "#;
}

/// What a curve meets.
#[derive(Clone)]
enum CurvePartner {
    Curve(RealCurve),
    Surface(RealSurfaceOrFace),
}

impl FromValue for CurvePartner {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::Surface, Type::Face]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(_) | Value::JetCurve(_) => {
                RealCurve::from_value(value, span).map(Self::Curve)
            }
            Value::Surface(_) | Value::JetSurface(_) | Value::Face(_) => {
                RealSurfaceOrFace::from_value(value, span).map(Self::Surface)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Record>> {
    let other = match &args.b {
        CurvePartner::Curve(curve) => curve,
        CurvePartner::Surface(surface) => return pierced(ctx, &args.a, surface),
    };
    let meetings = args.a.intersections(other, ctx.tolerance.distance).at(ctx.span)?;
    meetings
        .into_iter()
        .map(|meeting| varying_record([&args.a, other], meeting, ctx.span))
        .collect()
}

/// A meeting, with its derivatives where one of the curves varies.
fn varying_record(
    curves: [&RealCurve; 2],
    meeting: CurveIntersection,
    span: Span,
) -> Result<Record> {
    let Some([t, s]) = varying::meeting(curves, [meeting.first, meeting.second]).at(span)? else {
        return Ok(record(meeting));
    };
    let point = curves[0].series_beside(&t, Side::Right, 0).at(span)?.remove(0);
    Ok(Record::new([
        (Arc::from("t"), Real::Jet(t).into_value()),
        (Arc::from("s"), Real::Jet(s).into_value()),
        (Arc::from("point"), point.with_value(meeting.point).into_value()),
    ]))
}

/// A meeting as scripts see it.
pub(super) fn record(meeting: CurveIntersection) -> Record {
    Record::new([
        (Arc::from("t"), Value::number(meeting.first)),
        (Arc::from("s"), Value::number(meeting.second)),
        (Arc::from("point"), Value::Point(meeting.point)),
    ])
}
