//! The search for a curve within a tolerance that has few control points.

use glam::{DVec3, DVec4};

use super::{Ends, Interpolator, least::Approximator, slide::slid, spread};
use crate::{
    FitError, GeomError, KnotVector, NurbsCurve,
    removal::removal,
    tolerance::{PARAMETER_RELATIVE, SLIDE_RELATIVE},
};

/// How often the points of one trial slide along it.
const MAX_CORRECTIONS: usize = 12;

/// So many points are many: what costs more than it saves is left out.
pub(super) const MANY: usize = 2000;

/// Many points slide along a curve that misses by less than so many times the tolerance: on one that
/// is far from them they would only crowd.
const NEAR: f64 = 128.0;

/// Each round divides the data of every span that misses, so that this many divide any number.
const MAX_ROUNDS: usize = 64;

/// A step that leaves more than this of the sum of the squares gains nothing.
const GAIN: f64 = 0.98;

/// Control points up to which every number is tried; above, halving finds a good one.
const FEW: usize = 64;

/// So many steps in a row that gain nothing are the last.
const MAX_IDLE: usize = 2;

/// A curve that is slower at a point than this share of its mean speed is about to turn back.
const LEAST_SPEED: f64 = 0.2;

/// How often the knots of one number of control points are spread anew.
const MAX_SPREADS: usize = 3;

/// Halving stops at this share of the number of control points.
const SHARE: usize = 64;

/// The search for a curve within the tolerance.
pub(super) struct FitSearch<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) degree: usize,
    pub(super) tolerance: f64,
    /// Whether the parameters stay as they are.
    pub(super) are_fixed: bool,
    /// Points that may still be looked at to save control points.
    pub(super) left: usize,
}

/// A curve fitted to the points.
#[derive(Clone)]
pub(super) struct FittedCurve {
    pub(super) curve: NurbsCurve,
    pub(super) parameters: Vec<f64>,
    /// Distances of the points from the curve at their parameters.
    misses: Vec<f64>,
    worst: f64,
    /// The sum of their squares.
    squares: f64,
}

impl FittedCurve {
    fn new(curve: NurbsCurve, parameters: Vec<f64>, misses: Vec<f64>) -> Self {
        let worst = misses.iter().fold(0.0_f64, |worst, &miss| worst.max(miss));
        let squares = misses.iter().map(|miss| miss * miss).sum();
        Self { curve, parameters, misses, worst, squares }
    }

    fn n_control(&self) -> usize {
        self.curve.control_points().len()
    }
}

impl FitSearch<'_> {
    /// The curve with the fewest control points that is found.
    ///
    /// # Errors
    /// [`FitError::ToleranceNotKept`] below the rounding of the coordinates.
    pub(super) fn run(&mut self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        let domain = [parameters[0], parameters[parameters.len() - 1]];
        let ends = domain.map(|t| vec![t; self.degree + 1]);
        let coarsest = KnotVector::for_points(self.degree, self.degree + 1, ends.concat())?;
        // Points that slide along a curve that is still far from them can crowd, and then no number
        // of knots is enough; at parameters that stand still knots only ever help.
        let all = self.points.len();
        let still = FitSearch { are_fixed: true, ..*self }.grown(coarsest.clone(), parameters, all);
        let most = still.as_ref().map_or(all, FittedCurve::n_control);
        let slid = if self.are_fixed { None } else { self.grown(coarsest, parameters, most) };
        let Some(first) = slid.or(still) else {
            return self.interpolated(parameters);
        };
        let spread = self.respread(first);
        let thinned = self.thinned_at_once(spread);
        Ok(self.thinned(thinned))
    }

    fn keeps(&self, trial: &FittedCurve) -> bool {
        trial.worst <= self.tolerance
    }

    /// The nearest curve over the knots, to which the points slide while that helps.
    fn trial(&mut self, knots: &KnotVector, parameters: &[f64]) -> Option<FittedCurve> {
        let mut best = self.fitted(knots, parameters.to_vec())?;
        let are_many = MANY < self.points.len();
        let is_far = are_many && NEAR * self.tolerance < best.worst;
        if self.are_fixed || is_far {
            return Some(best);
        }
        let (mut last, mut along, mut n_idle) = (best.clone(), SLIDE_RELATIVE, 0);
        for _ in 0..MAX_CORRECTIONS {
            if self.keeps(&best) || n_idle == MAX_IDLE || 1.0 < along {
                break;
            }
            match self.slid(&last, along).filter(|next| next.squares < last.squares) {
                Some(next) => {
                    along = (along / 4.0).max(SLIDE_RELATIVE);
                    n_idle = if next.squares < GAIN * last.squares { 0 } else { n_idle + 1 };
                    if next.worst < best.worst {
                        best = next.clone();
                    }
                    last = next;
                }
                None => along *= 8.0,
            }
        }
        Some(best)
    }

    /// A step towards the nearest curve of the same knots, unless it comes to a stop on the way.
    fn slid(&mut self, trial: &FittedCurve, along: f64) -> Option<FittedCurve> {
        self.left = self.left.saturating_sub(self.points.len());
        let parameters = self.corrected(&trial.curve, trial.parameters.clone());
        let places = slid(&trial.curve, &parameters, self.points, along)?;
        let curve = NurbsCurve::polynomial(trial.curve.knots().clone(), &places).ok()?;
        let parameters = self.corrected(&curve, parameters);
        let found = curve.evaluator();
        let looks = || parameters.iter().map(|&t| found.second_order_at(t));
        let speeds = || looks().map(|[_, velocity, _]| velocity.length());
        let (least, sum) = speeds().fold((f64::MAX, 0.0), |(l, s), v| (v.min(l), s + v));
        if least < LEAST_SPEED * sum / parameters.len() as f64 {
            return None;
        }
        let misses = looks().zip(self.points).map(|(look, p)| look[0].distance(*p)).collect();
        Some(FittedCurve::new(curve, parameters, misses))
    }

    fn fitted(&mut self, knots: &KnotVector, parameters: Vec<f64>) -> Option<FittedCurve> {
        self.left = self.left.saturating_sub(self.points.len());
        let fit = Approximator::new(&parameters, knots.clone()).ok()?;
        let wanted: Vec<DVec4> = self.points.iter().map(|point| point.extend(1.0)).collect();
        let found = fit.near(&wanted).ok()?;
        let pairs = fit.values(&found).zip(self.points);
        let misses = pairs.map(|(value, point)| value.truncate().distance(*point)).collect();
        let places: Vec<DVec3> = found.into_iter().map(DVec4::truncate).collect();
        let curve = NurbsCurve::polynomial(knots.clone(), &places).ok()?;
        Some(FittedCurve::new(curve, parameters, misses))
    }

    /// One step of each inner parameter towards the nearest place of the curve, in order.
    fn corrected(&self, curve: &NurbsCurve, mut parameters: Vec<f64>) -> Vec<f64> {
        let curve = curve.evaluator();
        for i in 1..parameters.len() - 1 {
            let (t, point) = (parameters[i], self.points[i]);
            let [value, first, second] = curve.second_order_at(t);
            let miss = value - point;
            let speed = first.length_squared();
            let bent = speed + miss.dot(second);
            let slope = if 0.0 < bent { bent } else { speed };
            if 0.0 < slope {
                let next = t - miss.dot(first) / slope;
                let next = next.max(parameters[i - 1]).min(parameters[i + 1]);
                if curve.point_at(next).distance(point) < miss.length() {
                    parameters[i] = next;
                }
            }
        }
        parameters
    }

    /// Adds knots where points are missed until none is; `None` where `most` control points would
    /// not do.
    fn grown(
        &mut self,
        coarsest: KnotVector,
        parameters: &[f64],
        most: usize,
    ) -> Option<FittedCurve> {
        let mut knots = coarsest;
        let mut start = parameters.to_vec();
        for _ in 0..MAX_ROUNDS {
            let trial = match self.trial(&knots, &start) {
                Some(trial) => trial,
                None => self.trial(&knots, parameters)?,
            };
            if self.keeps(&trial) {
                return Some(trial);
            }
            let more = spread::splits(&knots, &trial.parameters, &trial.misses, self.tolerance);
            if more.is_empty() || most < knots.n_points() + more.len() {
                return None;
            }
            knots = knots.with(&more);
            start = trial.parameters;
        }
        None
    }

    /// The curve through all points, which no tolerance above rounding can refuse.
    fn interpolated(&self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        // Neighbours at one place are passed together.
        let same = PARAMETER_RELATIVE * (parameters[parameters.len() - 1] - parameters[0]);
        let mut apart: (Vec<f64>, Vec<DVec3>) = (Vec::new(), Vec::new());
        for (&t, &point) in parameters.iter().zip(self.points) {
            if apart.0.last().is_none_or(|&before| same < t - before) {
                apart.0.push(t);
                apart.1.push(point);
            }
        }
        let all = Interpolator::new(&apart.0, self.degree, Ends::Averaged)?;
        let curve = all.curve(&apart.1)?;
        let found = curve.evaluator();
        let pairs = self.points.iter().zip(parameters);
        let misses = pairs.map(|(point, &t)| found.point_at(t).distance(*point)).collect();
        let trial = FittedCurve::new(curve, parameters.to_vec(), misses);
        if self.keeps(&trial) {
            return Ok(trial);
        }
        Err(GeomError::Fit(FitError::ToleranceNotKept {
            tolerance: self.tolerance,
            found: trial.worst,
        }))
    }

    /// Fewer control points, with the knots where the curve needs them.
    fn respread(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        let (mut low, mut high) = (self.degree + 1, best.n_control());
        while low + high / SHARE < high && 0 < self.left {
            let n = if high <= FEW { low } else { low.midpoint(high) };
            match self.spread(&best, n) {
                Some(trial) => (best, high) = (trial, n),
                None => low = n + 1,
            }
        }
        best
    }

    /// A curve of so many control points within the tolerance, if spreading the knots by what each
    /// one found needs comes to it.
    fn spread(&mut self, best: &FittedCurve, n: usize) -> Option<FittedCurve> {
        let (mut curve, start) = (best.curve.clone(), best.parameters.clone());
        for _ in 0..MAX_SPREADS {
            let trial = self.trial(&spread::by_need(&curve, n), &start)?;
            if self.keeps(&trial) {
                return Some(trial);
            }
            curve = trial.curve;
        }
        None
    }

    /// Takes many knots away together: of those whose removal alone would be within the tolerance
    /// as many as may go, no two of them neighbours.
    fn thinned_at_once(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while FEW < best.n_control() {
            let spare = self.spare_knots(&best.curve);
            let mut n = spare.len();
            let found = loop {
                if n == 0 || self.left == 0 {
                    return best;
                }
                let without = |knots: KnotVector, &t: &f64| knots.without(t);
                let knots = spare[..n].iter().fold(best.curve.knots().clone(), without);
                let start = best.parameters.clone();
                match self.trial(&knots, &start).filter(|trial| self.keeps(trial)) {
                    Some(trial) => break trial,
                    None => n /= 4,
                }
            };
            best = found;
        }
        best
    }

    /// Inner knots that the curve needs least, no two of them neighbours, the least needed first.
    fn spare_knots(&self, curve: &NurbsCurve) -> Vec<f64> {
        let (knots, points) = (curve.knots().as_slice(), curve.control_points());
        let inner = self.degree + 1..points.len();
        let mut costs: Vec<(f64, usize)> = inner
            .map(|i| (removal(self.degree, knots, points, i).displacement, i))
            .filter(|&(cost, _)| cost <= self.tolerance)
            .collect();
        costs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut is_taken = vec![false; knots.len() + 1];
        let mut spare = Vec::new();
        for (_, i) in costs {
            if !(is_taken[i - 1] || is_taken[i + 1]) {
                is_taken[i] = true;
                spare.push(knots[i]);
            }
        }
        spare
    }

    /// Takes knots away one by one, the least needed first.
    fn thinned(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while best.n_control() <= FEW {
            let breaks = best.curve.knots().breaks();
            let mut without: Option<FittedCurve> = None;
            for &t in &breaks[1..breaks.len() - 1] {
                if self.left == 0 {
                    return best;
                }
                let knots = best.curve.knots().without(t);
                let start = best.parameters.clone();
                let found = self.trial(&knots, &start).filter(|trial| self.keeps(trial));
                let is_better =
                    |found: &FittedCurve| without.as_ref().is_none_or(|w| found.worst < w.worst);
                if let Some(found) = found.filter(is_better) {
                    without = Some(found);
                }
            }
            match without {
                Some(trial) => best = trial,
                None => return best,
            }
        }
        best
    }
}
