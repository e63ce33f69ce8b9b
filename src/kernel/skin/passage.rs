//! Which sides closed sections turn to the way between them.

use glam::DVec3;

use super::aligned_section::N_PLACES;
use crate::{NurbsCurve, frame::unit, tolerance::CLEAR_WAY};

/// Whether the way between two closed curves leads to the left side of one and to the right side of the
/// other; none where it runs along the plane of one, or one is not flat enough to have sides.
///
/// Seen along the way, a surface between them would have no area halfway if they did.
pub(super) fn passes_back(curve: &NurbsCurve, beside: &NurbsCurve) -> Option<bool> {
    let [own, others] = [curve, beside].map(|curve| {
        let points = curve.sample(N_PLACES + 1);
        let centre = points[..N_PLACES].iter().sum::<DVec3>() / N_PLACES as f64;
        let spokes = points.iter().map(|point| *point - centre).collect::<Vec<_>>();
        let doubled: DVec3 = spokes.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
        let round: f64 = spokes.windows(2).map(|pair| pair[0].cross(pair[1]).length()).sum();
        (centre, doubled, round)
    });
    let way = unit(own.0 - others.0)?;
    let side = |(_, doubled, round): (DVec3, DVec3, f64)| {
        let share = way.dot(doubled) / round;
        (CLEAR_WAY < share.abs()).then_some(share.is_sign_negative())
    };
    Some(side(own)? != side(others)?)
}
