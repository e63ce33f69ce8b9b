//! Curves near many points, found from a sample of them.

use glam::DVec3;

use super::{balance::Unbalanced, fitted::FittedCurve, search::FitSearch};
use crate::{
    ceiling::{FIT_STEPS_A_POINT, NEWTON_STEPS},
    numeric::newton::{to_foot, within_limits},
    tolerance::PARAMETER_RELATIVE,
};

/// What a sample may miss of the tolerance: the points between are missed by more.
const SAMPLE_SHARE: f64 = 0.9;

/// So many points, evenly chosen, are searched for first, if there are more than twice as many.
const SAMPLE: usize = 400;

/// Points of a sample for each control point, so that none swings between them.
const POINTS_A_CONTROL: usize = 6;

/// A curve of a sample that misses other points by so many times the tolerance is given a few knots more.
const ALMOST: f64 = 2.0;

/// Samples that may miss other points before no more are looked at: those scatter.
const MISSING_SAMPLES: usize = 2;

impl FitSearch<'_> {
    /// The curve that ever more of the points ask for, in the end all of them, until the others are near to it too;
    /// `None` where they are few, or scatter.
    ///
    /// Polygons, whose knots are their corners, are none of its matter.
    pub(super) fn run_on_balanced_samples(&mut self, parameters: &[f64]) -> Option<FittedCurve> {
        if self.degree == 1 || self.points.len() <= 2 * SAMPLE {
            return None;
        }
        let left = self.left.min(FIT_STEPS_A_POINT * self.points.len());
        let mut search = FitSearch { left, ..*self };
        let (mut n, mut n_missed, mut found) = (SAMPLE, 0, None);
        while found.is_none() && n_missed < MISSING_SAMPLES && 0 < search.left {
            let is_all = self.points.len() < 2 * n;
            let n_chosen = if is_all { self.points.len() } else { n };
            match search.run_on_balanced_sample(n_chosen, parameters) {
                Ok(curve) => found = Some(curve),
                Err(Unbalanced::TooFewPoints) if !is_all => {}
                Err(Unbalanced::OthersMissed) => n_missed += 1,
                Err(_) => break,
            }
            n *= 2;
        }
        self.left -= left - search.left;
        found
    }

    /// The curve that about `n` of the points ask for, if the others are near to it, or are once it is fitted to all.
    fn run_on_balanced_sample(
        &mut self,
        n: usize,
        parameters: &[f64],
    ) -> Result<FittedCurve, Unbalanced> {
        let sample = Sample::new(n, self.points, parameters);
        let is_all = sample.chosen.len() == self.points.len();
        let share = if is_all { 1.0 } else { SAMPLE_SHARE };
        let tolerance = share * self.tolerance;
        let mut search = FitSearch { points: &sample.points, tolerance, ..*self };
        let found = search.balanced(&sample.parameters);
        self.left = search.left;
        let found = found?;
        if is_all {
            return Ok(found);
        }
        if sample.chosen.len() <= POINTS_A_CONTROL * found.n_control() {
            return Err(Unbalanced::TooFewPoints);
        }
        let whole = self.of_all(&found, &sample.chosen, parameters);
        if self.keeps(&whole) {
            return Ok(whole);
        }
        let again = (whole.worst <= ALMOST * self.tolerance)
            .then(|| self.slid_soon(found.curve.knots(), &whole.parameters));
        again.flatten().filter(|curve| self.keeps(curve)).ok_or(Unbalanced::OthersMissed)
    }

    /// The curve that a sample of the points asks for: of ever more points until the others are near to
    /// it too, or are once it has a few knots more; `None` where no sample tells enough.
    pub(super) fn run_on_samples(&mut self, parameters: &[f64]) -> Option<FittedCurve> {
        let mut n = SAMPLE;
        while 2 * n < self.points.len() {
            if let Some(found) = self.run_on_sample(n, parameters) {
                return Some(found);
            }
            n *= 2;
        }
        None
    }

    /// The curve that about `n` of the points ask for, if the others are near to it.
    fn run_on_sample(&mut self, n: usize, parameters: &[f64]) -> Option<FittedCurve> {
        let sample = Sample::new(n, self.points, parameters);
        let tolerance = SAMPLE_SHARE * self.tolerance;
        let mut search = FitSearch { points: &sample.points, tolerance, ..*self };
        let found = search.run_on_all(&sample.parameters);
        self.left = search.left;
        let found =
            found.ok().filter(|s| POINTS_A_CONTROL * s.n_control() < sample.chosen.len())?;
        let whole = self.of_all(&found, &sample.chosen, parameters);
        if self.keeps(&whole) {
            return Some(whole);
        }
        if ALMOST * self.tolerance < whole.worst {
            return None;
        }
        let start = whole.parameters;
        self.grown(found.curve.knots().clone(), &start, found.n_control() + found.n_control() / 8)
    }

    /// The curve of a sample with the places of all points on it.
    fn of_all(&self, found: &FittedCurve, chosen: &[usize], parameters: &[f64]) -> FittedCurve {
        let start = match self.are_fixed {
            true => parameters.to_vec(),
            false => self.feet_between(found, chosen, parameters),
        };
        let mut misses = Vec::with_capacity(start.len());
        found.curve.evaluator().each_point(&start, |place| {
            misses.push(place.distance(self.points[misses.len()]));
        });
        FittedCurve::new(found.curve.clone(), start, misses)
    }

    /// The nearest places of all points on the curve of a sample: each lies between those of the two around it
    /// that were chosen.
    fn feet_between(&self, sample: &FittedCurve, chosen: &[usize], parameters: &[f64]) -> Vec<f64> {
        let curve = sample.curve.evaluator();
        let still = PARAMETER_RELATIVE * sample.curve.domain().length();
        let is_still = |[t]: [f64; 1], [next]: [f64; 1]| (next - t).abs() <= still;
        let mut feet = parameters.to_vec();
        for (k, ends) in chosen.windows(2).enumerate() {
            let old = [parameters[ends[0]], parameters[ends[1]]];
            let new = [sample.parameters[k], sample.parameters[k + 1]];
            let mut last = new[0];
            let between = ends[0]..ends[1];
            for (t, &point) in feet[between.clone()].iter_mut().zip(&self.points[between]) {
                let fraction = (*t - old[0]) / (old[1] - old[0]).max(f64::MIN_POSITIVE);
                let start = new[0] + fraction * (new[1] - new[0]);
                let found = within_limits([new], [start], NEWTON_STEPS, is_still, |[t]| {
                    let [value, velocity, _] = curve.second_order_at(t);
                    to_foot(point - value, velocity)
                });
                last = found.place()[0].max(last);
                *t = last;
            }
        }
        feet[parameters.len() - 1] = sample.parameters[chosen.len() - 1];
        feet
    }
}

/// Some of the points, evenly chosen, with the first and the last.
struct Sample {
    chosen: Vec<usize>,
    points: Vec<DVec3>,
    parameters: Vec<f64>,
}

impl Sample {
    /// About `n` of them.
    fn new(n: usize, points: &[DVec3], parameters: &[f64]) -> Self {
        let last = points.len() - 1;
        let stride = last.div_ceil(n).max(1);
        let chosen: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
        Self {
            points: chosen.iter().map(|&i| points[i]).collect(),
            parameters: chosen.iter().map(|&i| parameters[i]).collect(),
            chosen,
        }
    }
}
