//! Curves of any degree as splines of one degree, all on one knot vector of few knots.

use glam::DVec4;

use crate::{
    Approximator, FitError, GeomError, Interval, KnotVector, NurbsCurve, Side,
    ceiling::PIECES,
    ceiling::REFIT_BOUNDS,
    ceiling::REFIT_ROUNDS,
    ceiling::REFIT_TRIALS,
    fit::FitCondition,
    sorting::sort_by,
    tolerance::{KNOT_CLUSTER_RELATIVE, LEAST_KNOT_DENSITY},
};

/// Places of a span at which the distance is measured, beyond the degree.
const MORE_PLACES: usize = 4;

/// How much ends, derivatives there, and places that are to be met count more than others.
const HEAVY: f64 = 1e3;

/// What a fit may miss, as a share of before, after its bound was too large.
const FINER: f64 = 0.7;

/// Part of the tolerance that may be used up at the places that are looked at.
const SAFETY: f64 = 0.85;

/// The search for fewer knots ends at this share of their number.
const SHARE: usize = 32;

/// What splines in place of curves are to be like.
#[derive(Clone, Debug)]
pub(crate) struct RefitRequest {
    /// Their degree.
    pub(crate) degree: usize,
    /// Parameters where they have the curves' points.
    pub(crate) at: Vec<f64>,
    /// Inner knots that they have anyway, with their multiplicities.
    pub(crate) held: Vec<(f64, usize)>,
    /// Whether second derivatives at both ends count.
    pub(crate) is_ring: bool,
}

/// Splines of the curves, all on one domain, on common knots; with a bound of the distance at equal
/// parameters for each.
///
/// Least squares, with the ends, the derivatives there and `at` counted so heavily that they are
/// met. Spans that miss are divided; then fewer knots are tried, spread by need.
///
/// # Errors
/// [`FitError::ToleranceNotKept`] where [`PIECES`] control points do not suffice.
pub(crate) fn refitted(
    curves: &[NurbsCurve],
    wanted: &RefitRequest,
    tolerance: f64,
) -> Result<(Vec<NurbsCurve>, Vec<f64>), GeomError> {
    let search = KnotSearch::new(curves, wanted);
    let mut allowed = SAFETY * tolerance;
    let mut best = search.economical(allowed, tolerance)?;
    let mut found = best.worst();
    for _ in 0..REFIT_BOUNDS {
        let fits = best.curves()?;
        let bound = |(curve, fit): (&NurbsCurve, &NurbsCurve)| {
            GeomError::go_on(fit.n_segments())?;
            Ok(curve.deviation_from(fit))
        };
        let bounds: Vec<f64> =
            curves.iter().zip(&fits).map(bound).collect::<Result<_, GeomError>>()?;
        found = bounds.iter().copied().fold(0.0, f64::max);
        if found <= tolerance {
            return Ok((fits, bounds));
        }
        allowed *= FINER;
        best = search.grown(best, allowed, tolerance)?;
    }
    Err(GeomError::Fit(FitError::ToleranceNotKept { tolerance, found }))
}

struct KnotSearch<'a> {
    curves: &'a [NurbsCurve],
    degree: usize,
    domain: Interval,
    held: Vec<(f64, usize)>,
    at: Vec<f64>,
    is_ring: bool,
}

/// Splines over some knots.
struct TrialSplines {
    knots: KnotVector,
    /// Knots beyond those that are held.
    free: Vec<f64>,
    points: Vec<Vec<DVec4>>,
    /// The largest distance in each span.
    misses: Vec<f64>,
}

impl TrialSplines {
    fn worst(&self) -> f64 {
        self.misses.iter().copied().fold(0.0, f64::max)
    }

    fn curves(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        let curve = |points: &Vec<DVec4>| {
            let points: Vec<_> = points.iter().map(|point| point.truncate()).collect();
            NurbsCurve::polynomial(self.knots.clone(), &points)
        };
        self.points.iter().map(curve).collect()
    }
}

impl<'a> KnotSearch<'a> {
    fn new(curves: &'a [NurbsCurve], wanted: &RefitRequest) -> Self {
        let domain = curves[0].domain();
        let same = KNOT_CLUSTER_RELATIVE * domain.length();
        let inside = |t: f64| domain.start() + same < t && t < domain.end() - same;
        let mut sorted: Vec<(f64, usize)> =
            wanted.held.iter().copied().filter(|&(t, _)| inside(t)).collect();
        sort_by(&mut sorted, |a, b| a.0.total_cmp(&b.0));
        let mut held: Vec<(f64, usize)> = Vec::new();
        for (t, times) in sorted {
            let times = times.min(wanted.degree);
            match held.last_mut() {
                Some(last) if t - last.0 <= same => last.1 = last.1.max(times),
                _ => held.push((t, times)),
            }
        }
        let corners = held.iter().filter(|&&(_, times)| wanted.degree <= times).map(|&(t, _)| t);
        let mut at: Vec<f64> =
            wanted.at.iter().copied().filter(|&t| inside(t)).chain(corners).collect();
        at.sort_by(f64::total_cmp);
        Self { curves, degree: wanted.degree, domain, held, at, is_ring: wanted.is_ring }
    }

    fn knots(&self, free: &[f64]) -> Result<KnotVector, GeomError> {
        let ends = [self.domain.start(), self.domain.end()].map(|t| vec![t; self.degree + 1]);
        let held = self.held.iter().flat_map(|&(t, times)| vec![t; times]);
        let mut inner: Vec<f64> = held.chain(free.iter().copied()).collect();
        inner.sort_by(f64::total_cmp);
        KnotVector::new(self.degree, [&ends[0][..], &inner, &ends[1]].concat())
    }

    /// Places of each span, those to be met, and derivatives at the ends; in order.
    fn conditions(&self, breaks: &[f64]) -> (Vec<FitCondition>, Vec<Option<usize>>) {
        let n = self.degree + MORE_PLACES;
        let place = |i: usize| {
            let angle = std::f64::consts::PI * (i as f64 + 0.5) / n as f64;
            0.5 - 0.5 * libm::cos(angle)
        };
        let places: Vec<f64> = (0..n).map(place).collect();
        let mut all: Vec<(FitCondition, Option<usize>)> = Vec::new();
        let at_end = |t: f64, width: f64| {
            (1..=1 + usize::from(self.is_ring)).map(move |order| {
                let weight = HEAVY * if order == 1 { width } else { width * width };
                (FitCondition { t, order, weight }, None)
            })
        };
        let last = breaks.len() - 1;
        all.extend(at_end(breaks[0], breaks[1] - breaks[0]));
        for (span, ends) in breaks.windows(2).enumerate() {
            let at = |x: &f64| ends[0] + (ends[1] - ends[0]) * x;
            all.extend(
                places
                    .iter()
                    .map(|x| (FitCondition { t: at(x), order: 0, weight: 1.0 }, Some(span))),
            );
        }
        all.extend(at_end(breaks[last], breaks[last] - breaks[last - 1]));
        all.extend(self.at.iter().map(|&t| (FitCondition { t, order: 0, weight: HEAVY }, None)));
        sort_by(&mut all, |a, b| a.0.t.total_cmp(&b.0.t));
        all.into_iter().unzip()
    }

    fn trial(&self, free: Vec<f64>) -> Result<TrialSplines, GeomError> {
        let knots = self.knots(&free)?;
        let breaks = knots.breaks();
        let (conditions, spans) = self.conditions(&breaks);
        let fit = Approximator::weighted(&conditions, knots.clone())?;
        let parameters: Vec<f64> = conditions.iter().map(|condition| condition.t).collect();
        let mut misses = vec![0.0_f64; breaks.len() - 1];
        let mut points = Vec::with_capacity(self.curves.len());
        for curve in self.curves {
            GeomError::go_on(parameters.len())?;
            let mut wanted = Vec::with_capacity(parameters.len());
            curve.evaluator().each_point(&parameters, |point| wanted.push(point.extend(1.0)));
            for (value, condition) in wanted.iter_mut().zip(&conditions) {
                let &FitCondition { t, order, weight } = condition;
                if 0 < order {
                    let is_start = t <= self.domain.start();
                    let side = if is_start { Side::Right } else { Side::Left };
                    *value = curve.derivatives_beside(t, side, order)[order].extend(0.0);
                }
                *value *= weight;
            }
            let ends = [curve.start(), curve.end()].map(|point| point.extend(1.0));
            let mut own = fit.between(ends, &wanted);
            self.meet_ends(curve, &knots, &mut own);
            for ((value, wanted), span) in fit.values(&own).zip(&wanted).zip(&spans) {
                if let Some(miss) = span.and_then(|span| misses.get_mut(span)) {
                    *miss = miss.max((value - *wanted).truncate().length());
                }
            }
            points.push(own);
        }
        Ok(TrialSplines { knots, free, points, misses })
    }

    /// Gives the points next to the ends the derivatives of the curve there to the last digit, which
    /// heavy weights come near to: a ring then goes on over its seam as the curve does.
    fn meet_ends(&self, curve: &NurbsCurve, knots: &KnotVector, points: &mut [DVec4]) {
        let p = self.degree;
        let n_orders = 1 + usize::from(self.is_ring);
        if p <= n_orders || points.len() < 2 * (n_orders + 1) {
            return;
        }
        let (all, last) = (knots.as_slice(), points.len() - 1);
        let m = all.len() - 1;
        let ends = [
            (self.domain.start(), Side::Right, 1.0, [0, 1, 2], [p, p + 1, p + 2]),
            (
                self.domain.end(),
                Side::Left,
                -1.0,
                [0, 1, 2].map(|k| last - k),
                [p, p + 1, p + 2].map(|k| m - k),
            ),
        ];
        for (t, side, sign, [at, next, second], [end, first, behind]) in ends {
            let derivatives = curve.derivatives_beside(t, side, n_orders);
            let [near, far] = [first, behind].map(|k| (all[k] - all[end]).abs());
            let slope = derivatives[1].extend(0.0) * sign;
            points[next] = points[at] + slope * (near / p as f64);
            if self.is_ring {
                let bend = derivatives[2].extend(0.0) * (near / (p - 1) as f64);
                points[second] = points[next] + (slope + bend) * (far / p as f64);
            }
        }
    }

    /// The trial with spans divided until none misses by more than is allowed.
    fn grown(
        &self,
        first: TrialSplines,
        allowed: f64,
        tolerance: f64,
    ) -> Result<TrialSplines, GeomError> {
        let mut trial = first;
        for _ in 0..REFIT_ROUNDS {
            let more = self.splits(&trial, allowed);
            if more.is_empty() {
                return Ok(trial);
            }
            if PIECES < trial.knots.n_points() + more.len() {
                break;
            }
            let mut free = [&trial.free[..], &more].concat();
            free.sort_by(f64::total_cmp);
            trial = self.trial(free)?;
        }
        Err(GeomError::Fit(FitError::ToleranceNotKept { tolerance, found: trial.worst() }))
    }

    /// Knots that divide what misses, by how far it does.
    fn splits(&self, trial: &TrialSplines, allowed: f64) -> Vec<f64> {
        let breaks = trial.knots.breaks();
        let order = (self.degree + 1) as f64;
        let split = |(ends, &miss): (&[f64], &f64)| {
            let wanted = libm::pow(miss / allowed, 1.0 / order);
            let n_parts = if miss <= allowed { 1 } else { (wanted as usize + 1).clamp(2, 8) };
            let at = |i: usize| ends[0] + (ends[1] - ends[0]) * (i as f64 / n_parts as f64);
            (1..n_parts).map(at).collect::<Vec<f64>>()
        };
        breaks.windows(2).zip(&trial.misses).flat_map(split).collect()
    }

    /// The trial with the fewest knots that is found.
    fn economical(&self, allowed: f64, tolerance: f64) -> Result<TrialSplines, GeomError> {
        let mut best = self.grown(self.trial(Vec::new())?, allowed, tolerance)?;
        let (mut low, mut high) = (0, best.free.len());
        for _ in 0..REFIT_TRIALS {
            if high <= low + high / SHARE {
                break;
            }
            let n = low.midpoint(high);
            let mut trial = self.trial(self.spread(&best, n)?)?;
            // A few spans more may do.
            for _ in 0..2 {
                let more = self.splits(&trial, allowed);
                if more.is_empty() || high <= trial.free.len() + more.len() {
                    break;
                }
                let mut free = [&trial.free[..], &more].concat();
                free.sort_by(f64::total_cmp);
                trial = self.trial(free)?;
            }
            if trial.worst() <= allowed && trial.free.len() < high {
                high = trial.free.len();
                best = trial;
            } else {
                low = n + 1;
            }
        }
        Ok(best)
    }

    /// Some `n` knots, denser where the next derivative would be large.
    ///
    /// De Boor, *A Practical Guide to Splines*, §XII (`NEWNOT`), between those that are held.
    fn spread(&self, trial: &TrialSplines, n: usize) -> Result<Vec<f64>, GeomError> {
        let breaks = trial.knots.breaks();
        let needs = self.needs(trial, &breaks)?;
        let shares: Vec<f64> =
            needs.iter().zip(breaks.windows(2)).map(|(need, b)| need * (b[1] - b[0])).collect();
        let total: f64 = shares.iter().sum();
        let mut free = Vec::with_capacity(n);
        let is_held = |t: f64| self.held.iter().any(|&(knot, _)| knot.to_bits() == t.to_bits());
        let mut first = 0;
        for span in 0..shares.len() {
            if span + 1 < shares.len() && !is_held(breaks[span + 1]) {
                continue;
            }
            let sum: f64 = shares[first..=span].iter().sum();
            let own = (n as f64 * sum / total).round();
            let (mut at, mut before) = (first, 0.0);
            for i in 1..=own as usize {
                let target = sum * i as f64 / (own + 1.0);
                while at < span && before + shares[at] < target {
                    before += shares[at];
                    at += 1;
                }
                free.push(breaks[at] + (target - before) / needs[at]);
            }
            first = span + 1;
        }
        Ok(free)
    }

    /// For each span the root of order p + 1 of the derivative of that order, from the jumps of
    /// the one below.
    fn needs(&self, trial: &TrialSplines, breaks: &[f64]) -> Result<Vec<f64>, GeomError> {
        let (p, n) = (self.degree, breaks.len() - 1);
        let mut slopes = vec![0.0_f64; n - 1];
        for curve in trial.curves()? {
            let highest = |ends: &[f64]| curve.derivatives_at(0.5 * (ends[0] + ends[1]), p)[p];
            let highest: Vec<_> = breaks.windows(2).map(highest).collect();
            for (i, slope) in slopes.iter_mut().enumerate() {
                let width = 0.5 * (breaks[i + 2] - breaks[i]);
                *slope = slope.max(highest[i].distance(highest[i + 1]) / width);
            }
        }
        // What is behind a corner says nothing of what is before it.
        let is_smooth = |i: usize| {
            let t = breaks[i + 1];
            self.held.iter().all(|&(knot, times)| knot.to_bits() != t.to_bits() || times == 1)
        };
        let around = |i: usize| {
            let near = [i.checked_sub(1), Some(i)].into_iter().flatten();
            let near: Vec<f64> =
                near.filter(|&i| i + 1 < n && is_smooth(i)).map(|i| slopes[i]).collect();
            let mean = near.iter().sum::<f64>() / near.len().max(1) as f64;
            libm::pow(mean, 1.0 / (p + 1) as f64)
        };
        let needs: Vec<f64> = (0..n).map(around).collect();
        let mean = needs.iter().sum::<f64>() / n as f64;
        let least = if 0.0 < mean { LEAST_KNOT_DENSITY * mean } else { 1.0 };
        Ok(needs.into_iter().map(|need| need.max(least)).collect())
    }
}
