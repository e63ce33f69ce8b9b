//! How a border turns at a corner.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{GeomError, NurbsCurve, Side, Tolerance};

/// Halvings of the way from a corner that turns back, along which the sides of it are compared.
const LOOKS: u32 = 30;

/// By how much a border turns left between two arcs, from -π at the bottom of a crevice without width to π at
/// the tip of a thorn without width.
///
/// Of those two the tangents are the same: which it is tells the side to which the arcs leave one another.
///
/// # Errors
/// Ends without a direction.
pub(super) fn corner_turn(
    before: &NurbsCurve,
    next: &NurbsCurve,
    tolerance: Tolerance,
) -> Result<f64, GeomError> {
    let ends = [
        before.tangent_at(before.domain().end(), Side::Left)?,
        next.tangent_at(next.domain().start(), Side::Right)?,
    ];
    let angle = libm::atan2(ends[0].cross(ends[1]).z, ends[0].dot(ends[1]));
    if tolerance.angle < PI - angle.abs() {
        return Ok(angle);
    }
    let left = DVec3::Z.cross(ends[1]);
    Ok(match 0.0 < leaves_to(before, next, left, tolerance)? {
        true => -angle.abs(),
        false => angle.abs(),
    })
}

/// How far the next arc leaves that before to a side, where both leave the corner in one direction: as near to
/// it as they are a tolerance apart.
fn leaves_to(
    before: &NurbsCurve,
    next: &NurbsCurve,
    side: DVec3,
    tolerance: Tolerance,
) -> Result<f64, GeomError> {
    let total = before.length(before.domain());
    let least = total.min(next.length(next.domain()));
    let mut apart = 0.0;
    for halvings in (0..=LOOKS).rev() {
        let way = least / f64::from(2_u32.pow(halvings));
        let places = [
            before.point_at(before.parameter_at_length((total - way).max(0.0))?),
            next.point_at(next.parameter_at_length(way)?),
        ];
        apart = (places[1] - places[0]).dot(side);
        if tolerance.distance < apart.abs() {
            break;
        }
    }
    Ok(apart)
}
