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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    /// The parabola y = x² from `a` to `b`.
    fn parabola([a, b]: [f64; 2], aside: f64) -> [DVec4; 3] {
        let point = |x: f64, y: f64| DVec4::new(x, y, aside, 1.0);
        [point(a, a * a), point(0.5 * (a + b), a * b), point(b, b * b)]
    }

    #[test]
    fn a_joint_of_one_pace_needs_no_point() {
        let (first, last) = (parabola([0.0, 0.3], 0.0), parabola([0.3, 1.0], 0.0));
        let found = spline(&[([0.0, 0.3], &first), ([0.3, 1.0], &last)]).expect("a spline");
        assert_eq!(found.knots().as_slice(), [0.0, 0.0, 0.0, 0.3, 1.0, 1.0, 1.0]);
        for k in 0..=20 {
            let t = 0.05 * k as f64;
            assert!(found.point_at(t).distance(DVec3::new(t, t * t, 0.0)) < 1e-14);
        }
    }

    #[test]
    fn a_joint_of_two_paces_keeps_its_point_and_a_jump_has_two() {
        let (first, last) = (parabola([0.0, 0.3], 0.0), parabola([0.3, 1.0], 0.0));
        let uneven = spline(&[([0.0, 0.5], &first), ([0.5, 1.0], &last)]).expect("a spline");
        assert_eq!(uneven.knots().as_slice(), [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0]);
        let aside = parabola([0.3, 1.0], 4.0);
        let jumping = spline(&[([0.0, 0.3], &first), ([0.3, 1.0], &aside)]).expect("a spline");
        assert_eq!(jumping.knots().as_slice(), [0.0, 0.0, 0.0, 0.3, 0.3, 0.3, 1.0, 1.0, 1.0]);
        for k in 0..20 {
            let share = 0.05 * k as f64 + 0.01;
            let (x, y) = (0.3 * share, 0.3 + 0.7 * share);
            let before = DVec3::new(x, x * x, 0.0);
            assert!(uneven.point_at(0.5 * share).distance(before) < 1e-14);
            assert!(jumping.point_at(0.3 * share).distance(before) < 1e-14);
            let behind = DVec3::new(y, y * y, 0.0);
            assert!(uneven.point_at(0.5 + 0.5 * share).distance(behind) < 1e-14);
            assert!(jumping.point_at(y).distance(behind + 4.0 * DVec3::Z) < 1e-14);
        }
    }

    #[test]
    fn legs_of_a_polygon_keep_their_joints() {
        let point = |x: f64| DVec4::new(x, 2.0 * x, 0.0, 1.0);
        let (first, last) = ([point(0.0), point(1.0)], [point(1.0), point(2.0)]);
        let found = spline(&[([0.0, 1.0], &first), ([1.0, 2.0], &last)]).expect("a spline");
        assert_eq!(found.knots().as_slice(), [0.0, 0.0, 1.0, 2.0, 2.0]);
        assert!(found.point_at(1.5).distance(DVec3::new(1.5, 3.0, 0.0)) < 1e-15);
    }
}
