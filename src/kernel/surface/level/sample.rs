//! Branches as points in space, so dense that a cubic between neighbours stays on the branch.

use glam::DVec3;

use super::{Branch, cubic::Cubic};
use crate::kernel::{NurbsSurface, frame::unit};

/// Halvings of the stretch between two samples.
const MAX_HALVINGS: usize = 24;

/// Samples are so dense that the tangent turns from one to the next by less than about half of
/// a right angle: the square of the chord between the unit tangents.
pub(super) const MOST_TURN: f64 = 0.6;

/// A point of a branch, with the unit tangents before and behind it; zero where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) point: DVec3,
    pub(super) before: DVec3,
    pub(super) behind: DVec3,
}

/// Samples of a branch, in order.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub(super) samples: Vec<Sample>,
}

impl Sample {
    pub(super) fn turned(self) -> Self {
        Self { point: self.point, before: -self.behind, behind: -self.before }
    }
}

impl Run {
    /// Samples of a branch on a Bézier patch; the cubics between them stay within `tolerance` of
    /// the branch in the middle.
    pub(super) fn of(branch: &Branch, patch: &NurbsSurface, tolerance: f64) -> Self {
        let sample = |fraction: f64| {
            let [u, v] = branch.place(fraction);
            let (u, v) = (patch.domain_u().at(u), patch.domain_v().at(v));
            let [point, by_u, by_v] = patch.tangents_at(u, v);
            let widths = [patch.domain_u().length(), patch.domain_v().length()];
            let [du, dv] = branch.direction(fraction);
            let along = by_u * (du * widths[0]) + by_v * (dv * widths[1]);
            let tangent = unit(along).unwrap_or(DVec3::ZERO);
            Sample { point, before: tangent, behind: tangent }
        };
        let mut samples = vec![sample(0.0)];
        // Two halves at least: the middle may look straight by symmetry.
        let mut todo = vec![(1.0, 0), (0.5, 0)];
        let mut from = 0.0;
        while let Some((to, n_halvings)) = todo.pop() {
            let middle = 0.5 * (from + to);
            let (start, end) = (samples[samples.len() - 1], sample(to));
            let inner = |share: f64| sample(from + (to - from) * share);
            if n_halvings < MAX_HALVINGS && !follows([start, end], inner, tolerance) {
                todo.extend([(to, n_halvings + 1), (middle, n_halvings + 1)]);
                continue;
            }
            samples.push(end);
            from = to;
        }
        Self { samples }
    }

    pub(super) fn start(&self) -> DVec3 {
        self.samples.first().map_or(DVec3::ZERO, |sample| sample.point)
    }

    pub(super) fn end(&self) -> DVec3 {
        self.samples.last().map_or(DVec3::ZERO, |sample| sample.point)
    }

    /// The length of its chords.
    pub(super) fn length(&self) -> f64 {
        self.samples.windows(2).map(|pair| pair[0].point.distance(pair[1].point)).sum()
    }

    pub(super) fn turned(mut self) -> Self {
        self.samples.reverse();
        self.samples.iter_mut().for_each(|sample| *sample = sample.turned());
        self
    }
}

/// Whether the cubic between two samples passes those between them: the one in the middle, and two
/// beside it, because a cubic that strays may cross the middle by chance.
fn follows([start, end]: [Sample; 2], inner: impl Fn(f64) -> Sample, tolerance: f64) -> bool {
    let chord = start.point.distance(end.point);
    let middle = inner(0.5);
    if chord <= tolerance {
        return middle.point.distance(start.point) <= tolerance;
    }
    let turn = start.behind.distance_squared(end.before);
    let is_known = start.behind != DVec3::ZERO && end.before != DVec3::ZERO;
    let length = if is_known { length_between(start, end) } else { chord };
    let cubic = Cubic::between(start, end, length);
    let passes = |share: f64| cubic.misses_near(inner(share).point, share) <= tolerance;
    (turn <= MOST_TURN || !is_known)
        && cubic.misses(middle.point) <= tolerance
        && passes(0.25)
        && passes(0.75)
}

/// The length of the arc between two near samples: that of a circle with this chord and turn.
pub(super) fn length_between(start: Sample, end: Sample) -> f64 {
    let turn = start.behind.distance_squared(end.before);
    start.point.distance(end.point) * (1.0 + turn / 24.0)
}
