//! Branches as points in space, so dense that a cubic between neighbours stays on the branch.

use glam::DVec3;

use super::{
    branch::Branch,
    branch_sample::{BranchSample, length_between},
    cubic::CubicSegment,
    error::PictureError,
};
use crate::{
    Bounds, GeomError, NurbsSurface,
    ceiling::{BRANCH_SAMPLES, SAMPLE_HALVINGS},
    frame::unit,
    work,
};

/// Samples are so dense that the tangent turns from one to the next by less than about half of
/// a right angle: the square of the chord between the unit tangents.
pub(super) const MOST_TURN: f64 = 0.6;

/// How far, in tolerances, a curve of two surfaces that are nearly parallel may be told beside it.
const FAR_ASIDE: f64 = 64.0;

/// A place where the field vanishes with its slopes, up to a radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct VanishingPlace {
    pub(super) point: DVec3,
    pub(super) radius: f64,
    /// Whether the slopes vanish at the point itself, to rounding, and not at one nearby.
    pub(super) is_exact: bool,
}

impl VanishingPlace {
    /// How many curves end in it.
    pub(super) fn n_ends(&self, runs: &[BranchSamples]) -> usize {
        let ends = runs.iter().flat_map(|run| [run.start(), run.end()]);
        ends.filter(|end| end.distance(self.point) <= self.radius).count()
    }

    /// Whether curves meet in it, and do not only go on in one another.
    pub(super) fn is_met(&self, runs: &[BranchSamples], tolerance: f64) -> bool {
        match self.n_ends(runs) {
            0 => runs.iter().any(|run| run.passes(self.point, tolerance)),
            n => n != 2,
        }
    }
}

/// Samples of a branch, in order.
#[derive(Clone, Debug)]
pub(super) struct BranchSamples {
    pub(super) samples: Vec<BranchSample>,
}

impl BranchSamples {
    /// Whether all of it is within a spot.
    pub(super) fn is_within(&self, spot: &VanishingPlace) -> bool {
        self.samples.iter().all(|sample| sample.point.distance(spot.point) <= spot.radius)
    }

    /// Whether it lies on others.
    pub(super) fn is_on(&self, runs: &[Self], tolerance: f64) -> bool {
        let point = self.samples[self.samples.len() / 2].point;
        runs.iter().any(|other| other.passes(point, tolerance))
    }

    /// Whether it begins or ends in both of two boxes, within a distance, and does not close there.
    pub(super) fn ends_within(&self, boxes: [Bounds; 2], distance: f64) -> bool {
        let [start, end] = [self.start(), self.end()];
        let is_here = |point| boxes.iter().all(|bounds| bounds.contains(point, distance));
        start != end && (is_here(start) || is_here(end))
    }

    /// Whether it passes through a point.
    pub(super) fn passes(&self, point: DVec3, tolerance: f64) -> bool {
        self.samples.windows(2).any(|pair| {
            let chord = pair[1].point - pair[0].point;
            let along = (point - pair[0].point).dot(chord) / chord.length_squared();
            let reach = pair[0].point.distance(point).min(pair[1].point.distance(point));
            reach <= chord.length()
                && CubicSegment::between(pair[0], pair[1], length_between(pair[0], pair[1]))
                    .misses_near(point, along.clamp(0.0, 1.0))
                    <= 4.0 * tolerance
        })
    }

    /// Whether it is another one again, between the same ends: where surfaces cross at a small angle,
    /// places that are on both may be far from the curve. A neighbour of it would run the other way. Within a spot curves
    /// end anywhere.
    pub(super) fn repeats(&self, known: &Self, spots: &[VanishingPlace], tolerance: f64) -> bool {
        let near = FAR_ASIDE * tolerance;
        let is_in = |spot: &VanishingPlace, point: DVec3| spot.point.distance(point) <= spot.radius;
        let is_one_end = |a: DVec3, b: DVec3| {
            a.distance(b) <= near || spots.iter().any(|spot| is_in(spot, a) && is_in(spot, b))
        };
        let is_at_end =
            |spot: &&VanishingPlace| is_in(spot, self.start()) || is_in(spot, self.end());
        let at_ends: Vec<&VanishingPlace> = spots.iter().filter(is_at_end).collect();
        let is_beside_known = |sample: &BranchSample| {
            known.passes(sample.point, 0.25 * near)
                || at_ends.iter().any(|spot| is_in(spot, sample.point))
        };
        let middle = self.samples[self.samples.len() / 2];
        let beside = known.samples.iter().min_by(|a, b| {
            let away = |sample: &BranchSample| sample.point.distance(middle.point);
            away(a).total_cmp(&away(b))
        });
        is_one_end(self.start(), known.start())
            && is_one_end(self.end(), known.end())
            && self.samples.iter().all(is_beside_known)
            && beside.is_some_and(|sample| 0.0 < sample.behind.dot(middle.behind))
    }

    /// Samples of a branch on a Bézier patch; the cubics between them stay within `tolerance` of
    /// the branch in the middle.
    ///
    /// # Errors
    /// [`PictureError::Unresolved`] where [`BRANCH_SAMPLES`] do not do.
    pub(super) fn of(
        branch: &Branch,
        patch: &NurbsSurface,
        tolerance: f64,
    ) -> Result<Self, GeomError> {
        let sample = |fraction: f64| {
            let [[u, v], [du, dv]] = branch.at(fraction);
            let (u, v) = (patch.domain_u().at(u), patch.domain_v().at(v));
            let [point, by_u, by_v] = patch.tangents_at(u, v);
            let widths = [patch.domain_u().length(), patch.domain_v().length()];
            let along = by_u * (du * widths[0]) + by_v * (dv * widths[1]);
            let tangent = unit(along).unwrap_or(DVec3::ZERO);
            BranchSample { point, before: tangent, behind: tangent }
        };
        let whole = [0.0, 0.25, 0.5, 0.75, 1.0].map(sample);
        let stretch = |ends: [f64; 2], [start, middle, end]: [BranchSample; 3], n_halvings| {
            let share = |t: f64| sample(ends[0] + (ends[1] - ends[0]) * t);
            (ends, [start, share(0.25), middle, share(0.75), end], n_halvings)
        };
        let halves = |[from, to]: [f64; 2], [a, b, c, d, e]: [BranchSample; 5], n_halvings| {
            let middle = 0.5 * (from + to);
            [
                stretch([middle, to], [c, d, e], n_halvings),
                stretch([from, middle], [a, b, c], n_halvings),
            ]
        };
        let mut samples = vec![whole[0]];
        // Two halves at least: the middle may look straight by symmetry.
        let mut todo = Vec::from(halves([0.0, 1.0], whole, 0));
        while let Some((ends, inside, n_halvings)) = todo.pop() {
            if !work::goes_on(1) {
                return Err(GeomError::Ended);
            }
            if BRANCH_SAMPLES < samples.len() {
                let [u, v] = branch.place(0.5 * (ends[0] + ends[1]));
                let (u, v) = (patch.domain_u().at(u), patch.domain_v().at(v));
                return Err(PictureError::Unresolved { u, v }.into());
            }
            if n_halvings < SAMPLE_HALVINGS && !follows(&inside, tolerance) {
                todo.extend(halves(ends, inside, n_halvings + 1));
            } else {
                samples.push(inside[4]);
            }
        }
        Ok(Self { samples })
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

/// Whether the cubic between the first and the last sample passes those between them: the one in the
/// middle, and two beside it, because a cubic that strays may cross the middle by chance.
fn follows(&[start, before, middle, behind, end]: &[BranchSample; 5], tolerance: f64) -> bool {
    let chord = start.point.distance(end.point);
    if chord <= tolerance {
        return middle.point.distance(start.point) <= tolerance;
    }
    let turn = start.behind.distance_squared(end.before);
    let is_known = start.behind != DVec3::ZERO && end.before != DVec3::ZERO;
    let length = if is_known { length_between(start, end) } else { chord };
    let cubic = CubicSegment::between(start, end, length);
    let passes =
        |(sample, share): (BranchSample, f64)| cubic.misses_near(sample.point, share) <= tolerance;
    (turn <= MOST_TURN || !is_known)
        && [(middle, 0.5), (before, 0.25), (behind, 0.75)].into_iter().all(passes)
}
