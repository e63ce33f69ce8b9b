//! Curves near many points, found from a sample of them.

use glam::DVec3;

use super::search::{FitSearch, FittedCurve, MANY, SAMPLE};
use crate::{
    ceiling::NEWTON_STEPS,
    numeric::newton::{to_foot, within_limits},
    tolerance::PARAMETER_RELATIVE,
};

/// What a sample may miss of the tolerance: the points between are missed by more.
const SAMPLE_SHARE: f64 = 0.9;

impl FitSearch<'_> {
    /// The curve that a sample of the points asks for, with more knots where others are missed; `None`
    /// where the sample tells nothing.
    pub(super) fn run_on_sample(&mut self, parameters: &[f64]) -> Option<FittedCurve> {
        let last = self.points.len() - 1;
        let stride = last.div_ceil(SAMPLE);
        let chosen: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
        let points: Vec<DVec3> = chosen.iter().map(|&i| self.points[i]).collect();
        let places: Vec<f64> = chosen.iter().map(|&i| parameters[i]).collect();
        let tolerance = SAMPLE_SHARE * self.tolerance;
        let mut search = FitSearch { points: &points, tolerance, ..*self };
        let sample = search.run(&places).ok()?;
        if SAMPLE < 2 * sample.n_control() {
            return None;
        }
        let start = match self.are_fixed {
            true => parameters.to_vec(),
            false => self.feet_between(&sample, &chosen, parameters),
        };
        let places = sample.curve.evaluator();
        let pairs = self.points.iter().zip(&start);
        let misses = pairs.map(|(point, &t)| places.point_at(t).distance(*point)).collect();
        let whole = FittedCurve::new(sample.curve.clone(), start.clone(), misses);
        if self.keeps(&whole) {
            return Some(whole);
        }
        let found = self.grown(sample.curve.knots().clone(), &start, self.points.len())?;
        let spread = self.respread(found, sample.n_control());
        let thinned = self.thinned_at_once(spread);
        let are_many = MANY < self.points.len();
        Some(if are_many { thinned } else { self.thinned(thinned) })
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
