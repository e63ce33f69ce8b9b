//! Offsets of circular arcs, and arcs about corners.

use glam::{DVec3, DVec4};

use super::CurveOffsetTarget;
use crate::{
    ConstructionError, Curve, GeomError, Interval, KnotVector, NurbsCurve, Side,
    bernstein::product,
    bezier,
    frame::unit,
    tolerance::{ROUND_RELATIVE, VANISHING_RELATIVE},
};

/// The offset of a circular arc about the normal: the arc about the same centre; none for other
/// curves.
pub(super) fn offset(
    curve: &NurbsCurve,
    aim: CurveOffsetTarget,
) -> Result<Option<NurbsCurve>, GeomError> {
    let start = curve.domain().start();
    let local = Curve::from(curve.clone()).local_at(start, Side::Right);
    let Ok((Ok(radius), Ok(inward))) =
        local.map(|local| (local.radius_of_curvature(), local.normal()))
    else {
        return Ok(None);
    };
    let center = curve.start() + inward * radius;
    let slack = ROUND_RELATIVE * (radius + aim.magnitude);
    if !is_arc(curve, (center, radius), aim.normal, slack) {
        return Ok(None);
    }
    let side = aim.side(curve.tangent_at(start, Side::Right)?, start)?;
    let factor = (radius - side.dot(inward)) / radius;
    if factor.abs() <= ROUND_RELATIVE {
        return Err(ConstructionError::VanishingOffset { radius }.into());
    }
    let moved = |&point: &DVec4| {
        let w = point.w;
        ((point.truncate() - center * w) * factor + center * w).extend(w)
    };
    let points = curve.control_points().iter().map(moved).collect();
    NurbsCurve::new(curve.knots().clone(), points).map(Some)
}

/// Whether each piece keeps the distance to the centre, in the plane normal to the normal.
fn is_arc(curve: &NurbsCurve, (center, radius): (DVec3, f64), normal: DVec3, slack: f64) -> bool {
    curve.knots().spans().all(|span| {
        let arms: Vec<DVec4> = bezier::piece(curve.knots(), curve.control_points(), span)
            .into_iter()
            .map(|point| (point.truncate() - center * point.w).extend(point.w))
            .collect();
        let is_flat =
            arms.iter().all(|arm| arm.truncate().dot(normal).abs() <= slack * arm.w.abs());
        let excess = product(&arms, &arms, |a, b| {
            a.truncate().dot(b.truncate()) - radius * radius * a.w * b.w
        });
        let weight = arms.iter().map(|arm| arm.w).fold(0.0, f64::max);
        is_flat && excess.iter().all(|e| e.abs() <= slack * radius * weight * weight)
    })
}

/// How the offset goes on from one smooth part to the next.
pub(super) struct OffsetCorner {
    /// The arc about the corner, unless the parts meet without one.
    pub(super) arc: Vec<NurbsCurve>,
    /// Whether the offset lies on the side that the corner turns to.
    pub(super) is_inner: bool,
}

/// The arc about the corner between two parts, the shorter way around; where the curve turns back,
/// around the tip.
pub(super) fn corner(
    before: &NurbsCurve,
    after: &NurbsCurve,
    aim: CurveOffsetTarget,
) -> Result<OffsetCorner, GeomError> {
    let (end, start) = (before.domain().end(), after.domain().start());
    let (out, into) = (before.tangent_at(end, Side::Left)?, after.tangent_at(start, Side::Right)?);
    let (from, to) = (aim.side(out, end)?, aim.side(into, start)?);
    if from.distance(to) <= aim.accuracy {
        return Ok(OffsetCorner { arc: Vec::new(), is_inner: false });
    }
    let turn = from.cross(to).dot(aim.normal) / (aim.distance * aim.distance);
    let turns_back = from.dot(to) < 0.0 && turn.abs() <= VANISHING_RELATIVE;
    let forth = unit(aim.normal.cross(from) * aim.distance.signum()).unwrap_or(out);
    let is_inner = !turns_back && turn * aim.distance < 0.0;

    // Two pieces, each below a quarter turn.
    let middle =
        if turns_back { forth } else { unit(from + to).unwrap_or(forth) } * aim.distance.abs();
    let center = before.end();
    let domain = |share: f64| {
        let width = before.domain().length() * share / before.length(before.domain());
        Interval::new(0.0, width).unwrap_or(Interval::UNIT)
    };
    let arc = |(a, b): (DVec3, DVec3)| -> Result<NurbsCurve, GeomError> {
        let pole = (a + b) * (aim.distance * aim.distance / (a + b).length_squared() * 2.0);
        let weight = (0.5 * (1.0 + a.dot(b) / (aim.distance * aim.distance))).sqrt();
        let points = [center + a, center + pole, center + b];
        let arc = NurbsCurve::rational(KnotVector::bezier(2)?, &points, &[1.0, weight, 1.0])?;
        Ok(arc.reparametrized(domain((b - a).length())))
    };
    Ok(OffsetCorner { arc: vec![arc((from, middle))?, arc((middle, to))?], is_inner })
}
