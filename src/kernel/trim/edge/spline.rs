//! Pieces with Bézier points as one spline.

use glam::DVec4;

use crate::{GeomError, KnotVector, NurbsCurve, tolerance::LAST_BIT};

/// Last bits of its coordinates by which a joint may miss the point that a spline without it has there.
const JOINT_BITS: f64 = 16.0;

/// The spline of pieces of one degree that follow one another, each with its interval. Joints at which it goes on
/// at the same pace have no point of their own; where a piece begins elsewhere than the one before it ends, it jumps.
pub(super) fn spline(pieces: &[([f64; 2], &[DVec4])]) -> Result<NurbsCurve, GeomError> {
    let degree = pieces[0].1.len() - 1;
    let mut knots = vec![pieces[0].0[0]; degree + 1];
    let mut points = vec![pieces[0].1[0]];
    for (i, &(ends, own)) in pieces.iter().enumerate() {
        if let Some((before, last)) = i.checked_sub(1).map(|i| pieces[i]) {
            let joint = own[0];
            let end = last[degree];
            let size = joint.abs().max(end.abs()).max_element();
            let near = JOINT_BITS * LAST_BIT * size;
            let [width, next] = [before[1] - before[0], ends[1] - ends[0]];
            let implied = (last[degree - 1] * next + own[1] * width) / (width + next);
            let is_one = (end - joint).abs().max_element() <= near;
            let times = match is_one {
                true if (implied - joint).abs().max_element() <= near && 1 < degree => {
                    points.pop();
                    degree - 1
                }
                true => degree,
                false => {
                    points.push(joint);
                    degree + 1
                }
            };
            knots.extend(std::iter::repeat_n(ends[0], times));
        }
        points.extend_from_slice(&own[1..]);
    }
    let end = pieces[pieces.len() - 1].0[1];
    knots.extend(std::iter::repeat_n(end, degree + 1));
    NurbsCurve::new(KnotVector::new(degree, knots)?, points)
}
