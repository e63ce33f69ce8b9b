//! Curves near many points, found from a sample of them.

use glam::DVec3;

use super::search::{FitSearch, FittedCurve};
use crate::{
    ceiling::NEWTON_STEPS,
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

impl FitSearch<'_> {
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
        let last = self.points.len() - 1;
        let stride = last.div_ceil(n);
        let chosen: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
        let points: Vec<DVec3> = chosen.iter().map(|&i| self.points[i]).collect();
        let places: Vec<f64> = chosen.iter().map(|&i| parameters[i]).collect();
        let tolerance = SAMPLE_SHARE * self.tolerance;
        let mut search = FitSearch { points: &points, tolerance, ..*self };
        let sample = search.run_on_all(&places);
        self.left = search.left;
        let sample = sample.ok().filter(|s| POINTS_A_CONTROL * s.n_control() < chosen.len())?;
        let start = match self.are_fixed {
            true => parameters.to_vec(),
            false => self.feet_between(&sample, &chosen, parameters),
        };
        let places = sample.curve.evaluator();
        let pairs = self.points.iter().zip(&start);
        let misses = pairs.map(|(point, &t)| places.point_at(t).distance(*point)).collect();
        let whole = FittedCurve::new(sample.curve.clone(), start, misses);
        if self.keeps(&whole) {
            return Some(whole);
        }
        if ALMOST * self.tolerance < whole.worst {
            return None;
        }
        let start = whole.parameters;
        self.grown(
            sample.curve.knots().clone(),
            &start,
            sample.n_control() + sample.n_control() / 8,
        )
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
