//! What a search for a curve whose spans miss alike has found, and what it attempts next.

use super::{
    affine_length::by_affine_length, fitted::FittedCurve, search::FitSearch,
    span_errors::SpanErrors,
};
use crate::KnotVector;

/// A curve at parameters that stand still tells how the points bend when it misses them by so many times the
/// tolerance.
pub(super) const STILL: f64 = 4.0;

/// Control points are at most this share of the points: more follow them one by one.
const MOST_SHARE: f64 = 0.4;

/// The share of the spans of a curve at parameters that stand still that are tried first where points slide.
const SLIDING_SHARE: f64 = 0.7;

/// How much of where knots are first is where the still curve has them; the rest is even.
const STILL_KNOTS_SHARE: f64 = 0.3;

/// Curves within so many times the tolerance tell where knots are needed.
const CLOSE: f64 = 3.0;

/// What all spans are to miss, as a share of the tolerance.
const TARGET: f64 = 0.9;

/// Knots that were spread anew and miss by more than this share of what they missed before gain nothing.
const SPREAD_GAIN: f64 = 0.93;

/// How often the knots of one number of spans are spread anew.
const SPREADS: usize = 2;

/// What more knots do not bring nearer is rough where it misses by no more than this.
const ROUGH: f64 = 8.0;

/// Why no curve is found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Unbalanced {
    /// More points may tell what these do not.
    TooFewPoints,
    /// Its spans miss some that it does not know.
    OthersMissed,
    /// They scatter about the curve, and more knots make it no better.
    Rough,
    /// It would have more control points than are of use.
    NoUse,
}

/// Knots and parameters to begin with.
pub(super) struct Attempt {
    pub(super) n_spans: usize,
    pub(super) knots: KnotVector,
    pub(super) start: Vec<f64>,
    /// Whether they come from no curve that was near.
    pub(super) is_anew: bool,
}

/// What the search for the number of spans knows.
pub(super) struct Balance {
    degree: usize,
    pub(super) tolerance: f64,
    /// The error of a curve falls with the width of its spans to this power.
    order: f64,
    are_fixed: bool,
    /// More spans are of no use.
    most: usize,
    /// What more are.
    beyond: Unbalanced,
    /// A curve at the parameters as they are.
    pub(super) still: FittedCurve,
    /// Its errors.
    still_errors: SpanErrors,
    /// Where points that slide begin.
    paced: Vec<f64>,
    pub(super) best: Option<FittedCurve>,
    /// So many spans are too few.
    too_few: usize,
    /// How often their knots were spread anew.
    n_spreads: usize,
    /// Each number of spans that was tried, and what it missed by.
    passed: Vec<(usize, f64)>,
}

impl Balance {
    pub(super) fn new(search: &FitSearch<'_>, still: FittedCurve, parameters: &[f64]) -> Self {
        let order = (search.degree + 1) as f64;
        let followed = (MOST_SHARE * search.points.len() as f64) as usize;
        let paced = match search.are_fixed {
            true => parameters.to_vec(),
            false => by_affine_length(&still.curve, parameters),
        };
        Self {
            degree: search.degree,
            tolerance: search.tolerance,
            // Sliding parameters add two for cubics.
            order: if search.are_fixed { order } else { order + 2.0 },
            are_fixed: search.are_fixed,
            most: followed.min(search.most).saturating_sub(search.degree),
            beyond: if search.most < followed {
                Unbalanced::NoUse
            } else {
                Unbalanced::TooFewPoints
            },
            still_errors: still.span_errors(order),
            still,
            paced,
            best: None,
            too_few: 0,
            n_spreads: 0,
            passed: Vec::new(),
        }
    }

    /// The attempt to begin with.
    pub(super) fn first(&self) -> Result<Attempt, Unbalanced> {
        let n_still = self.still.n_control() - self.degree;
        let missed = (self.still.worst / (STILL * self.tolerance)).max(1.0);
        let wanted = n_still as f64 * libm::pow(missed, 1.0 / (self.degree + 1) as f64);
        self.anew(((SLIDING_SHARE * wanted) as usize).clamp(1, self.most.max(1)))
    }

    /// An attempt with so many spans, the knots and parameters by the still curve.
    fn anew(&self, n_spans: usize) -> Result<Attempt, Unbalanced> {
        let knots =
            if self.are_fixed { self.still_knots(n_spans) } else { self.paced_knots(n_spans) };
        let knots = knots.filter(|_| n_spans <= self.most).ok_or(self.beyond)?;
        Ok(Attempt { n_spans, knots, start: self.paced.clone(), is_anew: !self.are_fixed })
    }

    /// Knots as the still curve needs them.
    pub(super) fn still_knots(&self, n_spans: usize) -> Option<KnotVector> {
        self.still_errors.knots(self.degree, n_spans)
    }

    /// Knots between even ones and those that the still curve needs, where points slide.
    fn paced_knots(&self, n_spans: usize) -> Option<KnotVector> {
        let (from, to) = (&self.still.parameters, &self.paced);
        let last = to.len() - 1;
        let [start, end] = [to[0], to[last]];
        let carried = |t: f64| {
            let i = from.partition_point(|&place| place <= t).clamp(1, last);
            let fraction = (t - from[i - 1]) / (from[i] - from[i - 1]).max(f64::MIN_POSITIVE);
            to[i - 1] + fraction.clamp(0.0, 1.0) * (to[i] - to[i - 1])
        };
        let needed = self.still_errors.inner(n_spans).into_iter().enumerate();
        let inner = needed.map(|(i, t)| {
            let even = start + (end - start) * (i + 1) as f64 / n_spans as f64;
            STILL_KNOTS_SHARE * carried(t) + (1.0 - STILL_KNOTS_SHARE) * even
        });
        let ends = [start, end].map(|t| vec![t; self.degree + 1]);
        let knots = ends[0].iter().copied().chain(inner).chain(ends[1].iter().copied());
        KnotVector::new(self.degree, knots.collect()).ok()
    }

    /// An attempt with so many spans, the knots by what a curve misses.
    fn from(&self, curve: &FittedCurve, n_spans: usize) -> Option<Attempt> {
        let knots = curve.span_errors(self.order).knots(self.degree, n_spans)?;
        Some(Attempt { n_spans, knots, start: curve.parameters.clone(), is_anew: false })
    }

    /// What to attempt next, after one and its curve, if there is one, and whether this keeps the tolerance; `None`
    /// where the best is found.
    pub(super) fn after(
        &mut self,
        attempt: &Attempt,
        trial: Option<(FittedCurve, bool)>,
    ) -> Result<Option<Attempt>, Unbalanced> {
        let n = attempt.n_spans;
        match trial {
            Some((trial, true)) => Ok(self.with_fewer(n, trial)),
            Some((trial, false)) => {
                let is_gain = self.is_gain(n, trial.worst);
                let is_close = trial.worst <= CLOSE * self.tolerance;
                if is_close && is_gain && self.n_spreads < SPREADS {
                    self.n_spreads += 1;
                    return Ok(self.from(&trial, n));
                }
                self.with_more(n, Some(trial).filter(|_| is_close))
            }
            None => self.with_more(n, None),
        }
    }

    /// Whether a number of spans misses by less than before. Keeps in mind what it misses by.
    fn is_gain(&mut self, n_spans: usize, worst: f64) -> bool {
        match self.passed.last_mut().filter(|last| last.0 == n_spans) {
            Some((_, least)) => {
                let is_gain = worst < SPREAD_GAIN * *least;
                *least = least.min(worst);
                is_gain
            }
            None => {
                self.passed.push((n_spans, worst));
                true
            }
        }
    }

    /// After so many spans did.
    fn with_fewer(&mut self, n_spans: usize, found: FittedCurve) -> Option<Attempt> {
        let wanted = found.span_errors(self.order).n_wanted(TARGET * self.tolerance);
        let least = (n_spans / 2).max(self.too_few + 1);
        let next = (libm::round(wanted) as usize).max(least).min(n_spans - 1);
        let attempt = (self.too_few < next).then(|| self.from(&found, next));
        (self.best, self.n_spreads) = (Some(found), 0);
        attempt.flatten()
    }

    /// After so many spans did not do; the curve, if it is close.
    fn with_more(
        &mut self,
        n_spans: usize,
        close: Option<FittedCurve>,
    ) -> Result<Option<Attempt>, Unbalanced> {
        (self.too_few, self.n_spreads) = (n_spans, 0);
        if let Some(best) = &self.best {
            let enough = best.n_control() - self.degree;
            let next = (n_spans + 1).midpoint(enough);
            return Ok((next < enough).then(|| self.from(best, next)).flatten());
        }
        if self.is_rough() {
            return Err(Unbalanced::Rough);
        }
        match close {
            Some(close) => {
                let next = n_spans + 1 + n_spans / 16;
                let attempt = self.from(&close, next).filter(|_| next <= self.most);
                attempt.ok_or(self.beyond).map(Some)
            }
            None => self.anew(n_spans + 1 + n_spans * 2 / 5).map(Some),
        }
    }

    /// Whether more spans came nearer by less than the order two.
    fn is_rough(&self) -> bool {
        let [.., (few, before), _, (many, now)] = self.passed[..] else { return false };
        let ratio = few as f64 / many as f64;
        before * ratio * ratio < now && now <= ROUGH * self.tolerance
    }
}
