//! Points at which data turn too sharply for a smooth curve.

use glam::DVec3;

use crate::tolerance::PARAMETER_RELATIVE;

/// The least turn of a kink, in radians: a sixteenth of a turn.
const LEAST_TURN: f64 = std::f64::consts::FRAC_PI_8;

/// A kink turns by so many times what is usual around it.
const PROMINENCE: f64 = 4.0;

/// Neighbours on each side that tell what is usual.
const N_NEIGHBOURS: usize = 4;

/// Points nearer than so many times the tolerance tell no direction: what they miss the curve by would
/// turn it.
const APART: f64 = 8.0;

/// Neighbours among points that are apart are close where they are no more than so many times as far as they must be.
const CLOSE: f64 = 2.0;

/// Indices of inner points at which the polygon of the points turns by much more than around them:
/// a corner of a shape that is smooth beside it, and neither a tight bend nor noise within the tolerance.
pub(super) fn kinks(points: &[DVec3], parameters: &[f64], tolerance: f64) -> Vec<usize> {
    // Points that share their parameter have no direction between them.
    let last = points.len() - 1;
    let same = PARAMETER_RELATIVE * (parameters[last] - parameters[0]);
    let mut apart: Vec<usize> = Vec::with_capacity(points.len());
    for i in 0..=last {
        let is_apart = |&before: &usize| {
            let way = points[before].distance(points[i]);
            same < parameters[i] - parameters[before] && APART * tolerance < way
        };
        if apart.last().is_none_or(is_apart) {
            apart.push(i);
        }
    }
    let turn = |around: &[usize]| {
        let [before, at, behind] = [0, 1, 2].map(|k| points[around[k]]);
        let (into, out) = (at - before, behind - at);
        libm::atan2(into.cross(out).length(), into.dot(out))
    };
    let turns: Vec<f64> = apart.windows(3).map(turn).collect();
    let is_kink = |&k: &usize| {
        if turns[k] < LEAST_TURN {
            return false;
        }
        let around = k.saturating_sub(N_NEIGHBOURS)..(k + N_NEIGHBOURS + 1).min(turns.len());
        let mut others: Vec<f64> = around.filter(|&i| i != k).map(|i| turns[i]).collect();
        others.sort_by(f64::total_cmp);
        others.get(others.len() / 2).is_some_and(|usual| PROMINENCE * usual < turns[k])
    };
    // Where points lie close together, what is between two that are just apart turns at both: a tip halfway between them
    // is one corner.
    let is_close = |k: usize| {
        let way = points[apart[k + 1]].distance(points[apart[k + 2]]);
        way <= CLOSE * APART * tolerance
    };
    let is_one = |&k: &usize, &next: &usize| next == k + 1 && is_close(k);
    // Of the points between those that are apart, the corner is the one furthest out.
    let corner = |turned: &[usize]| {
        let [first, last] = [turned[0], turned[turned.len() - 1]];
        let ends = [apart[first], apart[last + 2]];
        let chord = points[ends[1]] - points[ends[0]];
        let out = |i: usize| chord.cross(points[i] - points[ends[0]]).length_squared();
        (ends[0] + 1..ends[1])
            .fold(apart[first + 1], |best, i| if out(best) < out(i) { i } else { best })
    };
    let turned: Vec<usize> = (0..turns.len()).filter(is_kink).collect();
    let mut found: Vec<usize> = turned.chunk_by(is_one).map(corner).collect();
    found.dedup();
    found
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::kinks;

    fn of(points: &[DVec3]) -> Vec<usize> {
        let parameters: Vec<f64> = (0..points.len()).map(|i| i as f64).collect();
        kinks(points, &parameters, 1e-3)
    }

    #[test]
    fn corners_are_kinks_and_bends_are_not() {
        let tent: Vec<DVec3> =
            (0..=20).map(|i| DVec3::new(f64::from(i), f64::from(i32::abs(i - 10)), 0.0)).collect();
        assert_eq!(of(&tent), [10]);
        let coarse_circle: Vec<DVec3> = (0..12)
            .map(|i| {
                let angle = f64::from(i) * std::f64::consts::FRAC_PI_6;
                DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
            })
            .collect();
        assert!(of(&coarse_circle).is_empty());
        let zigzag: Vec<DVec3> =
            (0..20).map(|i| DVec3::new(f64::from(i), f64::from(i % 2), 0.0)).collect();
        assert!(of(&zigzag).is_empty());
        // Three points have one turn and nothing to compare it with.
        assert!(of(&tent[9..12]).is_empty());
    }
    #[test]
    fn a_tip_between_points_that_lie_close_together_is_one_corner() {
        let sides = |n_left_out: i32| {
            let places = (n_left_out - 100..100).map(|i| 2e-4 * (f64::from(i) + 0.5));
            places.map(|x| DVec3::new(x, -10.0 * x.abs(), 0.0)).collect::<Vec<_>>()
        };
        for n_left_out in 0..10 {
            let points = sides(n_left_out);
            let [tip] = of(&points)[..] else { panic!("one corner, {n_left_out} points left out") };
            assert!((points[tip].x.abs() - 1e-4).abs() < 1e-12, "{}", points[tip]);
        }
    }
}
