//! The search for a curve within a tolerance that has few control points.

use glam::{DVec3, DVec4};

use super::{
    Ends, Interpolator,
    fitted::{FittedCurve, SlideTrail},
    least::Approximator,
    slide::slid,
    spread,
};
use crate::{
    FitError, GeomError, KnotVector, NurbsCurve, Parametrization,
    ceiling::FIT_CORRECTIONS,
    ceiling::FIT_ROUNDS,
    ceiling::IDLE_STEPS,
    ceiling::KNOT_SPREADS,
    tolerance::{PARAMETER_RELATIVE, SLIDE_RELATIVE},
};

/// Points for each control point with which knots that are spread alike are where few are enough; with fewer it may be that
/// those that are left where others were taken away are fewer still.
const PLENTY_OF_POINTS: usize = 16;

/// Up to this degree it is known how fast errors fall where points slide; of higher ones either way may come to fewer.
const BALANCED_DEGREE: usize = 3;

/// So many points are many: what costs more than it saves is left out.
const MANY: usize = 2000;

/// Many points slide along a curve that misses by less than so many times the tolerance: on one that
/// is far from them they would only crowd.
const NEAR: f64 = 128.0;

/// A step that leaves more than this of the sum of the squares gains nothing.
const GAIN: f64 = 0.98;

/// A curve that is slower at a point than this share of its mean speed is about to turn back.
const LEAST_SPEED: f64 = 0.2;

/// The way between two points may be so many times as long as straight from one tolerance around the
/// first to that around the second: that of half a circle is, and a little more.
const MOST_DETOUR: f64 = 1.7;

/// Parts of the way between two points, and pairs of points that are looked at together.
const DETOUR_PARTS: usize = 4;
const PAIRS_AT_ONCE: usize = 16;

/// Halving stops at this share of the number of control points.
const SHARE: usize = 64;

/// Numbers of control points below this share of what the error of one lets expect are not tried.
const EXPECTED_SHARE: f64 = 0.5;

/// The search for a curve within the tolerance.
pub(super) struct FitSearch<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) degree: usize,
    pub(super) tolerance: f64,
    /// Whether the parameters stay as they are.
    pub(super) are_fixed: bool,
    /// Whether the parameters are asked for: then detours between points are as well.
    pub(super) are_listed: bool,
    /// More control points than this are of no use.
    pub(super) most: usize,
    /// Points that may still be looked at to save control points.
    pub(super) left: usize,
}

impl FitSearch<'_> {
    /// The curve with the fewest control points that is found.
    ///
    /// # Errors
    /// [`FitError::ToleranceNotKept`] below the rounding of the coordinates.
    pub(super) fn run(&mut self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        let Some(balanced) = self.run_on_balanced_samples(parameters) else {
            return self.run_by_thinning(parameters);
        };
        let has_plenty = PLENTY_OF_POINTS * balanced.n_control() <= self.points.len();
        if has_plenty && self.degree <= BALANCED_DEGREE {
            return Ok(balanced);
        }
        let thinned = self.run_by_thinning(parameters).ok();
        let fewer = thinned.filter(|thinned| thinned.n_control() < balanced.n_control());
        Ok(fewer.unwrap_or(balanced))
    }

    /// [`Self::run`], knots taken away one after the other.
    pub(super) fn run_by_thinning(&mut self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        match self.run_on_samples(parameters) {
            Some(found) => Ok(found),
            None => self.run_on_all(parameters),
        }
    }

    /// [`Self::run_by_thinning`], all points looked at from the beginning.
    pub(super) fn run_on_all(&mut self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        let domain = [parameters[0], parameters[parameters.len() - 1]];
        let ends = domain.map(|t| vec![t; self.degree + 1]);
        let coarsest = KnotVector::for_points(self.degree, self.degree + 1, ends.concat())?;
        // Points that slide along a curve that is still far from them can crowd, and then no number
        // of knots is enough; at parameters that stand still knots only ever help.
        let all = self.most.min(self.points.len());
        let still = FitSearch { are_fixed: true, ..*self }.grown(coarsest.clone(), parameters, all);
        let most = still.as_ref().map_or(all, FittedCurve::n_control);
        let slid = if self.are_fixed { None } else { self.grown(coarsest, parameters, most) };
        let Some(first) = slid.or(still) else {
            return self.interpolated(parameters);
        };
        let mut best = first;
        let mut is_at_rest = false;
        for _ in 0..FIT_ROUNDS {
            let n = best.n_control();
            let spread = self.respread(best, self.degree + 1);
            best = self.thinned_at_once(spread);
            // It is the curve of which no knot could go.
            if is_at_rest && n <= best.n_control() {
                break;
            }
            (best, is_at_rest) = self.thinned(best);
            // With fewer knots, and parameters that slid, they may be needed elsewhere.
            if n <= best.n_control() {
                break;
            }
        }
        Ok(best)
    }

    pub(super) fn keeps(&self, trial: &FittedCurve) -> bool {
        trial.worst <= self.tolerance && (self.are_listed || self.goes_straight(trial))
    }

    /// Whether the curve makes no detour between two points: where parameters slide apart, no point
    /// holds it.
    fn goes_straight(&self, trial: &FittedCurve) -> bool {
        *trial.is_straight.get_or_init(|| {
            let (curve, last) = (trial.curve.evaluator(), trial.parameters.len() - 1);
            let mut from = curve.point_at(trial.parameters[0]);
            (0..last).step_by(PAIRS_AT_ONCE).all(|first| {
                let pairs = first..last.min(first + PAIRS_AT_ONCE);
                let mut places = Vec::with_capacity(DETOUR_PARTS * pairs.len());
                for ends in trial.parameters[first..=pairs.end].windows(2) {
                    for k in 1..=DETOUR_PARTS {
                        let fraction = k as f64 / DETOUR_PARTS as f64;
                        places.push((1.0 - fraction) * ends[0] + fraction * ends[1]);
                    }
                }
                let found = curve.points_at(&places);
                let points = self.points[first..=pairs.end].windows(2);
                found.chunks_exact(DETOUR_PARTS).zip(points).all(|(legs, points)| {
                    let leg = |&to: &DVec3| std::mem::replace(&mut from, to).distance(to);
                    let straight = points[0].distance(points[1]) + 2.0 * self.tolerance;
                    legs.iter().map(leg).sum::<f64>() <= MOST_DETOUR * straight
                })
            })
        })
    }

    /// The nearest curve over the knots, to which the points slide while that helps.
    pub(super) fn trial(&mut self, knots: &KnotVector, parameters: &[f64]) -> Option<FittedCurve> {
        let first = self.fitted(knots, parameters.to_vec())?;
        let are_many = MANY < self.points.len();
        let is_far = are_many && NEAR * self.tolerance < first.worst;
        if self.are_fixed || is_far {
            return Some(first);
        }
        let (mut trail, mut along, mut n_idle) = (SlideTrail::new(first), SLIDE_RELATIVE, 0);
        for _ in 0..FIT_CORRECTIONS {
            if self.keeps(trail.best()) || n_idle == IDLE_STEPS || 1.0 < along {
                break;
            }
            let last = trail.last();
            match self.slid(last, along).filter(|next| next.squares < last.squares) {
                Some(next) => {
                    along = (along / 4.0).max(SLIDE_RELATIVE);
                    n_idle = if next.squares < GAIN * last.squares { 0 } else { n_idle + 1 };
                    trail.push(next);
                }
                None => along *= 8.0,
            }
        }
        Some(trail.into_best())
    }

    /// A step towards the nearest curve of the same knots, unless it comes to a stop on the way.
    pub(super) fn slid(&mut self, trial: &FittedCurve, along: f64) -> Option<FittedCurve> {
        self.left = self.left.saturating_sub(self.points.len());
        let parameters =
            self.corrected(&trial.curve, trial.parameters.clone(), Some(&trial.places));
        let places = slid(&trial.curve, &parameters, self.points, along)?;
        let curve = NurbsCurve::polynomial(trial.curve.knots().clone(), &places).ok()?;
        let parameters = self.corrected(&curve, parameters, None);
        let (mut least, mut sum) = (f64::MAX, 0.0);
        let mut misses = Vec::with_capacity(parameters.len());
        let mut places = Vec::with_capacity(parameters.len());
        curve.evaluator().each_second_order(&parameters, |place| {
            let [value, velocity, _] = place;
            let speed = velocity.length();
            (least, sum) = (speed.min(least), sum + speed);
            misses.push(value.distance(self.points[misses.len()]));
            places.push(place);
        });
        if least < LEAST_SPEED * sum / parameters.len() as f64 {
            return None;
        }
        Some(FittedCurve { places, ..FittedCurve::new(curve, parameters, misses) })
    }

    pub(super) fn fitted(
        &mut self,
        knots: &KnotVector,
        parameters: Vec<f64>,
    ) -> Option<FittedCurve> {
        self.left = self.left.saturating_sub(self.points.len());
        let fit = Approximator::new(&parameters, knots.clone()).ok()?;
        let found = fit.near_points(self.points).ok()?;
        let pairs = fit.values(&found).zip(self.points);
        let misses = pairs.map(|(value, point)| value.truncate().distance(*point)).collect();
        let places: Vec<DVec3> = found.into_iter().map(DVec4::truncate).collect();
        let curve = NurbsCurve::polynomial(knots.clone(), &places).ok()?;
        Some(FittedCurve::new(curve, parameters, misses))
    }

    /// One step of each inner parameter towards the nearest place of the curve, in order; `known` are the places at the
    /// parameters, if they are.
    fn corrected(
        &self,
        curve: &NurbsCurve,
        mut parameters: Vec<f64>,
        known: Option<&[[DVec3; 3]]>,
    ) -> Vec<f64> {
        let curve = curve.evaluator();
        let mut steps = Vec::with_capacity(parameters.len());
        let mut step_from = |[value, first, second]: [DVec3; 3]| {
            let i = steps.len();
            let miss = value - self.points[i];
            let speed = first.length_squared();
            let bent = speed + miss.dot(second);
            let slope = if 0.0 < bent { bent } else { speed };
            let step = if 0.0 < slope { miss.dot(first) / slope } else { 0.0 };
            steps.push((parameters[i] - step, miss.length_squared()));
        };
        match known.filter(|known| known.len() == parameters.len()) {
            Some(known) => known.iter().copied().for_each(step_from),
            None => curve.each_second_order(&parameters, &mut step_from),
        }
        // Few of them come upon a neighbour: the others are looked at together.
        let places: Vec<f64> = steps.iter().map(|step| step.0).collect();
        let mut found = Vec::with_capacity(places.len());
        curve.each_point(&places, |place| {
            found.push(place.distance_squared(self.points[found.len()]));
        });
        for i in 1..parameters.len() - 1 {
            let (wanted, miss) = steps[i];
            let next = wanted.max(parameters[i - 1]).min(parameters[i + 1]);
            let is_there = next.total_cmp(&wanted).is_eq();
            let off = match is_there {
                true => found[i],
                false => curve.point_at(next).distance_squared(self.points[i]),
            };
            if off < miss {
                parameters[i] = next;
            }
        }
        parameters
    }

    /// Adds knots where points are missed until none is; `None` where `most` control points would
    /// not do.
    pub(super) fn grown(
        &mut self,
        coarsest: KnotVector,
        parameters: &[f64],
        most: usize,
    ) -> Option<FittedCurve> {
        let mut knots = coarsest;
        let mut start = parameters.to_vec();
        for _ in 0..FIT_ROUNDS {
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
            // From crowded parameters knots do not lead back.
            start = match self.are_fixed || self.goes_straight(&trial) {
                true => trial.parameters,
                false => parameters.to_vec(),
            };
        }
        None
    }

    /// The curve through all points, which no tolerance above rounding can refuse. Where it makes detours at
    /// the parameters, and they are not asked for, they are centripetal: Lee, *Choosing nodes in
    /// parametric curve interpolation*, CAD 21 (1989).
    fn interpolated(&self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
        let found = self.interpolated_at(parameters)?;
        if self.keeps(&found) {
            return Ok(found);
        }
        let [start, end] = [parameters[0], parameters[parameters.len() - 1]];
        let rule = Parametrization::Centripetal.loose_parameters(self.points);
        let trial = match rule {
            Ok(rule) if !self.are_listed => {
                let spread: Vec<f64> = rule.iter().map(|t| (1.0 - t) * start + t * end).collect();
                self.interpolated_at(&spread)?
            }
            _ => found,
        };
        if trial.worst <= self.tolerance {
            return Ok(trial);
        }
        let tolerance = self.tolerance;
        Err(GeomError::Fit(FitError::ToleranceNotKept { tolerance, found: trial.worst }))
    }

    fn interpolated_at(&self, parameters: &[f64]) -> Result<FittedCurve, GeomError> {
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
        Ok(FittedCurve::new(curve, parameters.to_vec(), misses))
    }

    /// Fewer control points, from so many on, with the knots where the curve needs them.
    pub(super) fn respread(&mut self, first: FittedCurve, least: usize) -> FittedCurve {
        let mut best = first;
        let (mut low, mut high) = (least, best.n_control());
        while low + high / SHARE < high && 0 < self.left {
            let n = low.midpoint(high);
            match self.spread(&best, n) {
                Ok(trial) => (best, high) = (trial, n),
                Err(worst) => low = self.expected(n, worst).clamp(n + 1, (n + 1).midpoint(high)),
            }
        }
        best
    }

    /// With how many control points a curve may first be within the tolerance, where one of `n` misses
    /// by `worst`: the error falls with the number to the power of the order.
    fn expected(&self, n: usize, worst: f64) -> usize {
        let order = (self.degree + 1) as f64;
        let growth = libm::pow(worst / self.tolerance, 1.0 / order);
        (EXPECTED_SHARE * growth * n as f64) as usize
    }

    /// A curve of so many control points within the tolerance, if spreading the knots by what each
    /// one found needs comes to it; else how far the nearest one misses.
    fn spread(&mut self, best: &FittedCurve, n: usize) -> Result<FittedCurve, f64> {
        self.spread_while(best, n, &|_, _| true)
    }

    /// [`Self::spread`], as long as what one misses by and the least that others before it did are worth another.
    pub(super) fn spread_while(
        &mut self,
        best: &FittedCurve,
        n: usize,
        is_worth_another: &dyn Fn(f64, f64) -> bool,
    ) -> Result<FittedCurve, f64> {
        let (mut curve, start) = (best.curve.clone(), best.parameters.clone());
        let mut least = f64::INFINITY;
        for _ in 0..KNOT_SPREADS {
            let knots = spread::by_need(&curve, n);
            let Some(trial) = self.trial(&knots, &start) else { break };
            if self.keeps(&trial) {
                return Ok(trial);
            }
            let goes_on = is_worth_another(trial.worst, least);
            least = least.min(trial.worst);
            if !goes_on {
                break;
            }
            curve = trial.curve;
        }
        // Where there is none, nothing can be expected of more.
        Err(if least.is_finite() { least } else { self.tolerance })
    }
}
