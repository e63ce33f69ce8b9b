//! The search for a curve all spans of which miss the points alike.
//!
//! Where that is so, knots are where they are needed, and what is missed tells how many would do: a dozen trials
//! come to as few control points as hundreds that take away one knot after the other. They begin at parameters by
//! affine length, from which points need not slide far.

use super::{
    balance::{Attempt, Balance, STILL, Unbalanced},
    fitted::{FittedCurve, SlideTrail},
    search::FitSearch,
    span_errors::SpanErrors,
};
use crate::{
    KnotVector,
    ceiling::{BALANCE_ROUNDS, BALANCED_KNOTS_TRIED, BALANCED_SLIDES, SINGLE_REMOVALS},
    tolerance::BALANCED_SLIDE_RELATIVE,
};

/// What misses by more than this with as many spans as the points may have tells nothing.
const UNSEEN: f64 = 64.0;

/// Points of such a curve for each span.
const POINTS_A_STILL_SPAN: usize = 4;

/// Spans that are tried after one.
const FIRST_SPANS: usize = 6;

/// A slide that leaves more than this of the worst miss is the last.
const SLIDE_GAIN: f64 = 0.97;

/// Points that slid count only where what they are missed by is no more than this share of what others are.
const BETTER: f64 = 0.7;

impl FitSearch<'_> {
    /// A curve within the tolerance that has few control points.
    pub(super) fn balanced(&mut self, parameters: &[f64]) -> Result<FittedCurve, Unbalanced> {
        let domain = [parameters[0], parameters[parameters.len() - 1]];
        let coarsest =
            KnotVector::new(self.degree, domain.map(|t| vec![t; self.degree + 1]).concat());
        let coarsest = coarsest.map_err(|_| Unbalanced::TooFewPoints)?;
        let flat = self.fitted(&coarsest, parameters.to_vec()).ok_or(Unbalanced::TooFewPoints)?;
        if self.keeps(&flat) {
            return Ok(flat);
        }
        if flat.worst < UNSEEN * self.tolerance {
            let slid = self.trial(&coarsest, parameters);
            if let Some(slid) = slid.filter(|slid| self.keeps(slid)) {
                return Ok(slid);
            }
        }
        let still = self.still(flat, parameters)?;
        let mut balance = Balance::new(self, still, parameters);
        let mut attempt = balance.first()?;
        for _ in 0..BALANCE_ROUNDS {
            if self.left == 0 {
                break;
            }
            let trial = self.attempted(&balance, &attempt);
            match balance.after(&attempt, trial)? {
                Some(next) => attempt = next,
                None => break,
            }
        }
        let best = balance.best.ok_or(Unbalanced::Rough)?;
        Ok(self.with_one_fewer(best))
    }

    /// Ever one control point fewer: one knot taken away, or all of them where the curve needs them.
    fn with_one_fewer(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = self.thinned_soon(first);
        while (self.degree + 2..=SINGLE_REMOVALS).contains(&best.n_control()) && 0 < self.left {
            // One that comes no nearer is the last.
            let is_gain = |worst: f64, least: f64| worst < least;
            match self.spread_while(&best, best.n_control() - 1, &is_gain) {
                Ok(spread) => best = self.thinned_soon(spread),
                Err(_) => break,
            }
        }
        best
    }

    /// A curve at the parameters as they are that is near enough to the points to tell how they bend.
    fn still(&mut self, flat: FittedCurve, parameters: &[f64]) -> Result<FittedCurve, Unbalanced> {
        let order = (self.degree + 1) as f64;
        let most = self.points.len() / POINTS_A_STILL_SPAN;
        let mut found = flat;
        let mut passed: Vec<(usize, f64)> = Vec::new();
        let mut n = 1;
        while STILL * self.tolerance < found.worst && n < most {
            let errors = found.span_errors(order);
            let wanted = errors.n_wanted(0.5 * STILL * self.tolerance) as usize;
            passed.push((n, found.worst));
            n = wanted.saturating_add(1).clamp(n + n / 2 + 1, 3 * n).max(FIRST_SPANS).min(most);
            let Some(next) = self.still_of(&errors, n, parameters) else { break };
            found = next;
        }
        // Of points that are seen the error of four times as many spans is a small part.
        let is_idle = |&(m, worst): &(usize, f64)| {
            (FIRST_SPANS..=n / 4 + 1).contains(&m) && worst < 2.0 * found.worst
        };
        if UNSEEN * self.tolerance < found.worst {
            return Err(Unbalanced::TooFewPoints);
        }
        let is_rough = n == most && passed.iter().any(is_idle);
        if is_rough { Err(Unbalanced::Rough) } else { Ok(found) }
    }

    /// A curve of so many spans, or, where these leave control points open, one of which the points have a part in where
    /// knots are.
    fn still_of(
        &mut self,
        errors: &SpanErrors,
        n_spans: usize,
        parameters: &[f64],
    ) -> Option<FittedCurve> {
        let knots = errors.knots(self.degree, n_spans)?;
        if let Some(found) = self.fitted(&knots, parameters.to_vec()) {
            return Some(found);
        }
        let even = KnotVector::spreading(self.degree, knots.n_points(), parameters).ok()?;
        let both = knots.as_slice().iter().zip(even.as_slice()).map(|(a, b)| 0.5 * (a + b));
        let between = KnotVector::new(self.degree, both.collect()).ok()?;
        self.fitted(&between, parameters.to_vec())
    }

    /// The nearest curve over the knots, to which the points slide a few times.
    pub(super) fn slid_soon(
        &mut self,
        knots: &KnotVector,
        parameters: &[f64],
    ) -> Option<FittedCurve> {
        self.slid_while(knots, parameters, &|_, _| true)
    }

    /// A curve over the knots within the tolerance, to which the points slide while as many more slides as are left
    /// would come there if each gained as much.
    fn slid_within(&mut self, knots: &KnotVector, parameters: &[f64]) -> Option<FittedCurve> {
        let tolerance = self.tolerance;
        let leads_there = |[last, next]: [f64; 2], n_left: usize| {
            (0..n_left).fold(next, |worst, _| next / last * worst) <= tolerance
        };
        let found = self.slid_while(knots, parameters, &leads_there)?;
        self.keeps(&found).then_some(found)
    }

    /// [`Self::slid_soon`], as long as what two slides in turn miss by, and how many are left, are worth another.
    fn slid_while(
        &mut self,
        knots: &KnotVector,
        parameters: &[f64],
        is_worth_another: &dyn Fn([f64; 2], usize) -> bool,
    ) -> Option<FittedCurve> {
        let first = self.fitted(knots, parameters.to_vec())?;
        if self.are_fixed {
            return Some(first);
        }
        let (mut trail, mut along) = (SlideTrail::new(first), BALANCED_SLIDE_RELATIVE);
        let mut is_first = true;
        for n_left in (0..BALANCED_SLIDES).rev() {
            if self.keeps(trail.best()) || 1.0 < along {
                break;
            }
            let last = trail.last();
            let Some(next) = self.slid(last, along).filter(|next| next.squares < last.squares)
            else {
                along *= 8.0;
                continue;
            };
            along = (along / 4.0).max(BALANCED_SLIDE_RELATIVE);
            let is_idle = SLIDE_GAIN * last.worst <= next.worst;
            // The first may come from afar.
            let is_last =
                is_idle || !(is_first || is_worth_another([last.worst, next.worst], n_left));
            trail.push(next);
            if is_last {
                break;
            }
            is_first = false;
        }
        Some(trail.into_best())
    }

    /// The curve of an attempt; where it does not come from one that was near, also from parameters as they are, if
    /// that is better.
    fn attempted(&mut self, balance: &Balance, attempt: &Attempt) -> Option<(FittedCurve, bool)> {
        let mut trial = self.slid_soon(&attempt.knots, &attempt.start);
        let is_near = |trial: &FittedCurve| trial.worst <= balance.tolerance;
        if attempt.is_anew && !trial.as_ref().is_some_and(is_near) {
            let plain = balance
                .still_knots(attempt.n_spans)
                .and_then(|knots| self.slid_soon(&knots, &balance.still.parameters));
            let limit = trial.as_ref().map_or(f64::INFINITY, |trial| BETTER * trial.worst);
            trial = plain.filter(|plain| plain.worst < limit).or(trial);
        }
        trial.map(|trial| {
            let keeps = self.keeps(&trial);
            (trial, keeps)
        })
    }

    /// Takes knots away one by one, of the few that cost least the first that can go.
    fn thinned_soon(&mut self, first: FittedCurve) -> FittedCurve {
        let mut best = first;
        while (self.degree + 2..=SINGLE_REMOVALS).contains(&best.n_control()) && 0 < self.left {
            let costs = self.costs(&best.curve);
            let knots = best.curve.knots().clone();
            let without = |&(_, i): &(f64, usize)| {
                self.slid_within(&knots.without(knots.as_slice()[i]), &best.parameters)
            };
            match costs.iter().take(BALANCED_KNOTS_TRIED).find_map(without) {
                Some(trial) => best = trial,
                None => break,
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::FitSearch;

    #[test]
    fn of_high_degrees_neither_way_comes_to_fewer_control_points() {
        let n = 900_u32;
        let parameters: Vec<f64> = (0..n).map(|i| f64::from(i) / f64::from(n - 1)).collect();
        let sine = |&t: &f64| DVec3::new(10.0 * t, libm::sin(13.0 * t), 0.0);
        let points: Vec<DVec3> = parameters.iter().map(sine).collect();
        for degree in [4, 7] {
            let search = || FitSearch {
                points: &points,
                degree,
                tolerance: 1e-5,
                are_fixed: false,
                are_listed: false,
                most: points.len(),
                left: crate::ceiling::FIT_STEPS,
            };
            let found = search().run(&parameters).expect("a curve").n_control();
            let thinned = search().run_by_thinning(&parameters).expect("a curve").n_control();
            let balanced = search().run_on_balanced_samples(&parameters).map(|f| f.n_control());
            assert_eq!(found, balanced.map_or(thinned, |n| n.min(thinned)), "degree {degree}");
        }
    }
}
