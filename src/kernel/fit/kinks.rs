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
    // Of the points between those that are apart, the corner is the one furthest out.
    let corner = |k: usize| {
        let ends = [apart[k], apart[k + 2]];
        let chord = points[ends[1]] - points[ends[0]];
        let out = |i: usize| chord.cross(points[i] - points[ends[0]]).length_squared();
        (ends[0] + 1..ends[1])
            .fold(apart[k + 1], |best, i| if out(best) < out(i) { i } else { best })
    };
    let mut found: Vec<usize> = (0..turns.len()).filter(is_kink).map(corner).collect();
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
}
