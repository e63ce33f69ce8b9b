//! Offsets of polygons.

use glam::DVec3;

use super::{CurveOffsetTarget, Offset};
use crate::{
    GeomError, NurbsCurve,
    tolerance::{LEAST_MITRE, VANISHING_RELATIVE},
};

/// The offset of a polygon in a plane normal to the normal: each leg moved to its side, and cut
/// or prolonged to meet the next; none for other curves, and where a corner would grow to a spike.
pub(super) fn offset(
    curve: &NurbsCurve,
    aim: CurveOffsetTarget,
) -> Result<Option<Offset>, GeomError> {
    let knots = curve.knots().as_slice();
    let n_points = curve.control_points().len();
    let is_plain = knots.windows(2).skip(1).take(n_points - 1).all(|pair| pair[0] < pair[1]);
    if curve.degree() != 1 || curve.is_rational() || !is_plain {
        return Ok(None);
    }
    let points = curve.points();
    let legs: Vec<DVec3> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let is_flat = |leg: &DVec3| leg.dot(aim.normal).abs() <= VANISHING_RELATIVE * leg.length();
    if !legs.iter().all(is_flat) {
        return Ok(None);
    }
    let parameters = &knots[1..=n_points];
    let side = |(leg, &t): (&DVec3, &f64)| aim.side(*leg, t);
    let sides: Vec<DVec3> = legs.iter().zip(parameters).map(side).collect::<Result<_, _>>()?;

    let is_closed = points[0].distance(points[n_points - 1]) <= aim.accuracy;
    let mut moved = Vec::with_capacity(n_points);
    for (i, &point) in points.iter().enumerate() {
        let (before, after) = match i {
            0 if is_closed => (sides[sides.len() - 1], sides[0]),
            0 => (sides[0], sides[0]),
            i if i < sides.len() => (sides[i - 1], sides[i]),
            i if is_closed => (sides[i - 1], sides[0]),
            i => (sides[i - 1], sides[i - 1]),
        };
        // Both legs meet at the multiple of the sum that is at the distance from both.
        let sum = before + after;
        let squared = aim.distance * aim.distance;
        let shortening = (squared + before.dot(after)) / (2.0 * squared);
        if shortening < LEAST_MITRE {
            return Ok(None);
        }
        moved.push(point + sum * (0.5 / shortening));
    }
    let mut folds = Vec::new();
    for (i, leg) in legs.iter().enumerate() {
        if (moved[i + 1] - moved[i]).dot(*leg) <= 0.0 {
            folds.push(parameters[i]);
        }
    }
    let curve = NurbsCurve::polynomial(curve.knots().clone(), &moved)?;
    Ok(Some(Offset { folds, ..Offset::exact(curve) }))
}
