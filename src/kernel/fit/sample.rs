//! Curves near many points, found from a sample of them.

use glam::DVec3;

use super::search::{FitSearch, FittedCurve};
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

/// Points of a sample for each control point of the curve that comes near to them at the parameters as they are: with fewer
/// it follows single points.
const POINTS_A_STILL_CONTROL: usize = 2;

/// The share of control points that is tried first where there may be too many, and from which on it is not worth the time.
const SHARES: [f64; 2] = [0.8, 0.95];

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
        let left = self.left.min(FIT_STEPS_A_POINT * self.points.len());
        let mut search = FitSearch { points: &points, tolerance, left, ..*self };
        let sample = search.run_soon(&places)?;
        self.left -= left - search.left;
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

    /// A curve of few control points that is found soon; none where the points are too few for it. Counts what is looked
    /// at to save control points alone.
    fn run_soon(&mut self, parameters: &[f64]) -> Option<FittedCurve> {
        let (all, left) = (self.points.len(), self.left);
        let room = all / POINTS_A_STILL_CONTROL;
        let most = self.most.min(room);
        let still = FitSearch { are_fixed: true, ..*self }.grown_anew(parameters, most).ok()?;
        if still.is_none() && room <= self.most {
            return None;
        }
        let most = still.as_ref().map_or(most, FittedCurve::n_control);
        let slid = if self.are_fixed { None } else { self.grown_anew(parameters, most).ok()? };
        let first = slid.or(still)?;
        if all <= POINTS_A_CONTROL * first.n_control() {
            return None;
        }
        self.left = left;
        let fewer = self.with_fewer(first);
        let fewer = self.thinned_at_once(fewer);
        Some(self.thinned(fewer).0)
    }

    /// Ever fewer control points, their knots where the curve needs them, while there are curves within the tolerance.
    fn with_fewer(&mut self, first: FittedCurve) -> FittedCurve {
        let [mut share, most] = SHARES;
        let mut best = first;
        while share < most && 0 < self.left {
            let n = (share * best.n_control() as f64) as usize;
            if n <= self.degree {
                break;
            }
            match self.spread(&best, n) {
                Ok(trial) => best = trial,
                // Halfway to all, by their logarithms.
                Err(_) => share = share.sqrt(),
            }
        }
        best
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
