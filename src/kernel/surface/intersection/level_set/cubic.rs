//! From samples of a line in space to a spline through them.

use glam::DVec3;

use super::branch_sample::{BranchSample, length_between};
use crate::{
    GeomError, KnotVector, NurbsCurve,
    ceiling::CUBIC_FOOT_STEPS,
    frame::unit,
    numeric::newton::{to_foot, within_limits},
    tolerance::CORNER_RELATIVE,
    work,
};

/// Where between two samples a spline is compared with the cubic between them.
const SHARES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

/// A cubic over its length, by its Bézier points.
#[derive(Clone, Copy, Debug)]
pub(super) struct CubicSegment {
    points: [DVec3; 4],
}

impl CubicSegment {
    /// Between two samples, where it runs with their tangents at the speed of one.
    pub(super) fn between(start: BranchSample, end: BranchSample, length: f64) -> Self {
        let third = length / 3.0;
        let chord = unit(end.point - start.point).unwrap_or(DVec3::ZERO);
        let leaves = tangent(start.behind, end.before, chord);
        let arrives = tangent(end.before, start.behind, chord);
        let points =
            [start.point, start.point + leaves * third, end.point - arrives * third, end.point];
        Self { points }
    }

    fn at(&self, t: f64) -> [DVec3; 2] {
        let [a, b, c, d] = self.points;
        let [ab, bc, cd] = [a.lerp(b, t), b.lerp(c, t), c.lerp(d, t)];
        let (left, right) = (ab.lerp(bc, t), bc.lerp(cd, t));
        [left.lerp(right, t), (right - left) * 3.0]
    }

    pub(super) fn middle(&self) -> DVec3 {
        self.at(0.5)[0]
    }

    /// How far a point near the middle is from it.
    pub(super) fn misses(&self, point: DVec3) -> f64 {
        self.misses_near(point, 0.5)
    }

    /// How far a point is from it, by the foot near a parameter.
    pub(super) fn misses_near(&self, point: DVec3, start: f64) -> f64 {
        let found = within_limits(
            [[0.0, 1.0]],
            [start],
            CUBIC_FOOT_STEPS,
            |_, _| false,
            |[t]| {
                let [place, slope] = self.at(t);
                to_foot(point - place, slope)
            },
        );
        self.at(found.place()[0])[0].distance(point)
    }
}

/// A tangent, or without one that of the circle with the other one and the chord.
fn tangent(own: DVec3, other: DVec3, chord: DVec3) -> DVec3 {
    match (own == DVec3::ZERO, other == DVec3::ZERO) {
        (false, _) => own,
        (true, false) => chord * (2.0 * chord.dot(other)) - other,
        (true, true) => chord,
    }
}

/// The spline through samples of a line that has a length, parametrized about by that, within `tolerance` of
/// all of them; a closed one's last sample is the first.
pub(super) fn spline(samples: &[BranchSample], tolerance: f64) -> Result<NurbsCurve, GeomError> {
    let kept = thinned(samples, tolerance);
    let mut knots = vec![0.0; 4];
    let mut points = vec![kept[0].0.point];
    let mut t = 0.0;
    for (i, pair) in kept.windows(2).enumerate() {
        let [(start, from), (end, to)] = [pair[0], pair[1]];
        let length = to - from;
        let cubic = CubicSegment::between(start, end, length);
        if 0 < i {
            // A smooth joint does without its own point.
            let is_corner = is_corner(start);
            if is_corner {
                points.push(start.point);
            }
            knots.extend(std::iter::repeat_n(t, if is_corner { 3 } else { 2 }));
        }
        points.extend([cubic.points[1], cubic.points[2]]);
        t += length;
    }
    points.push(kept[kept.len() - 1].0.point);
    knots.extend([t; 4]);
    NurbsCurve::polynomial(KnotVector::new(3, knots)?, &points)
}

fn is_corner(sample: BranchSample) -> bool {
    sample.before == DVec3::ZERO
        || sample.behind == DVec3::ZERO
        || CORNER_RELATIVE < sample.before.distance(sample.behind)
}

/// As few of the samples as cubics need to stay within the tolerance of all, each with its place
/// along the line; corners and ends are kept.
fn thinned(samples: &[BranchSample], tolerance: f64) -> Vec<(BranchSample, f64)> {
    let mut length = 0.0;
    let mut places = vec![0.0];
    for pair in samples.windows(2) {
        length += length_between(pair[0], pair[1]);
        places.push(length);
    }
    let follows = |from: usize, to: usize| {
        let whole = places[to] - places[from];
        let cubic = CubicSegment::between(samples[from], samples[to], whole);
        // Beside the samples what is between them counts, as they tell it: few samples under a long
        // cubic may be met by chance.
        let passes = |k: usize, share: f64, point: DVec3| {
            let place = places[k] + (places[k + 1] - places[k]) * share;
            cubic.misses_near(point, (place - places[from]) / whole) <= tolerance
        };
        (from..to).all(|k| {
            let fine = CubicSegment::between(samples[k], samples[k + 1], places[k + 1] - places[k]);
            (k == from || !is_corner(samples[k]))
                && SHARES.iter().all(|&share| passes(k, share, fine.at(share)[0]))
        })
    };
    let mut kept = vec![(samples[0], 0.0)];
    let mut from = 0;
    let mut todo = vec![samples.len() - 1];
    while work::goes_on(1)
        && let Some(to) = todo.pop()
    {
        if to - from > 1 && !follows(from, to) {
            let middle = 0.5 * (places[from] + places[to]);
            let cut = places.partition_point(|&place| place < middle);
            todo.extend([to, cut.clamp(from + 1, to - 1)]);
            continue;
        }
        from = to;
        // What is one place twice has no length between.
        match kept.last_mut() {
            Some((last, place)) if places[to] <= *place => last.behind = samples[to].behind,
            _ => kept.push((samples[to], places[to])),
        }
    }
    kept
}
