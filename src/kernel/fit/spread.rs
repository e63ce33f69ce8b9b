//! Where a spline that is fitted has its knots.

use glam::DVec3;

use super::{interpolate::check_degree, parameters::check_ends};
use crate::{
    GeomError, KnotError, KnotVector, NurbsCurve,
    knots::check_points,
    tolerance::{LEAST_KNOT_DENSITY, PARAMETER_RELATIVE, SPREADING_SPARE},
};

impl KnotVector {
    /// Knots for `n_points` control points that leave about as many of the parameters in each
    /// span.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (9.68) and (9.69); where that leaves hardly more parameters than control
    /// points, means of `degree` of as many places among the parameters as there are control points, which with
    /// as many control points as parameters are the knots of interpolation, (9.8). Where so many parameters are one that
    /// knots would stand there too often, each counts once.
    ///
    /// # Errors
    /// `CountError::CountTooSmall` for degree 0, `CountError::TooFewPoints` below two parameters,
    /// `DegreeError::BadDegree` with no more points than the degree, `DegreeError::DegreeTooHigh`,
    /// `CountError::TooManyPoints`, and what [`Self::new`] says of parameters without an order.
    pub fn spreading(
        degree: usize,
        n_points: usize,
        parameters: &[f64],
    ) -> Result<Self, GeomError> {
        check_degree(degree)?;
        check_points(degree, n_points)?;
        check_ends(parameters)?;
        match Self::spreading_over(degree, n_points, parameters) {
            Err(GeomError::Knots(KnotError::KnotMultiplicity { .. })) => {
                Self::spreading_over(degree, n_points, &distinct(parameters))
            }
            found => found,
        }
    }

    /// [`Self::spreading`], of parameters many of which may be one.
    fn spreading_over(
        degree: usize,
        n_points: usize,
        parameters: &[f64],
    ) -> Result<Self, GeomError> {
        let share = parameters.len() as f64 / (n_points - degree) as f64;
        if share < 1.0 + SPREADING_SPARE * (degree * degree).max(2) as f64 {
            return Self::averaging(degree, n_points, parameters);
        }
        let knot = |j: usize| {
            let place = j as f64 * share;
            let i = (place as usize).clamp(1, parameters.len() - 1);
            let alpha = place - i as f64;
            (1.0 - alpha) * parameters[i - 1] + alpha * parameters[i]
        };
        let inner: Vec<f64> = (1..n_points - degree).map(knot).collect();
        let [start, end] =
            [parameters[0], parameters[parameters.len() - 1]].map(|t| vec![t; degree + 1]);
        Self::new(degree, [&start[..], &inner, &end].concat())
    }
}

impl KnotVector {
    /// Knots that are means of `degree` of `n_points` places spread over the parameters by their number.
    fn averaging(degree: usize, n_points: usize, parameters: &[f64]) -> Result<Self, GeomError> {
        let last = parameters.len() - 1;
        let step = last as f64 / (n_points - 1) as f64;
        let site = |j: usize| {
            let place = j as f64 * step;
            let i = (place as usize).min(last.saturating_sub(1));
            let alpha = place - i as f64;
            (1.0 - alpha) * parameters[i] + alpha * parameters[(i + 1).min(last)]
        };
        let sites: Vec<f64> = (0..n_points).map(site).collect();
        let mean = |sites: &[f64]| sites.iter().sum::<f64>() / degree as f64;
        let inner: Vec<f64> = (1..n_points - degree).map(|j| mean(&sites[j..j + degree])).collect();
        let [start, end] = [parameters[0], parameters[last]].map(|t| vec![t; degree + 1]);
        Self::new(degree, [&start[..], &inner, &end].concat())
    }
}

/// Parameters, each of those that are one counted once; both ends stay.
fn distinct(parameters: &[f64]) -> Vec<f64> {
    let [start, end] = [parameters[0], parameters[parameters.len() - 1]];
    let same = PARAMETER_RELATIVE * (end - start);
    let mut found = vec![start];
    let inner = parameters.iter().filter(|&&t| same < end - t);
    inner.for_each(|&t| {
        if same < t - found[found.len() - 1] {
            found.push(t);
        }
    });
    found.push(end);
    found
}

/// Points for each part into which a span is divided at once.
const POINTS_A_PART: usize = 256;

/// Knots for each span with a point that is missed, where the squares of the misses divide into
/// equal parts: halves, and more where a span with hundreds of points misses by far; none where a side
/// would be left without a point. The nearest spans on both sides of one that misses and has no
/// room for a knot are halved instead: they are what keeps it from its points.
pub(super) fn splits(
    knots: &KnotVector,
    parameters: &[f64],
    misses: &[f64],
    tolerance: f64,
) -> Vec<f64> {
    let same = PARAMETER_RELATIVE * knots.domain().length();
    let breaks = knots.breaks();
    let spans: Vec<SpanData<'_>> =
        breaks.windows(2).map(|ends| SpanData::new(ends, parameters, misses, same)).collect();
    let split = |inside: &SpanData<'_>| {
        let worst = inside.misses.iter().fold(0.0_f64, |worst, &miss| worst.max(miss));
        if worst <= tolerance {
            return None;
        }
        // The error falls with the width to the power of the order.
        let order = (knots.degree() + 1) as f64;
        let wanted = libm::pow(worst / tolerance, 1.0 / order) as usize;
        let n_parts = wanted.min(inside.misses.len() / POINTS_A_PART).max(2);
        Some(inside.divided(n_parts, |miss| miss * miss))
    };
    let own: Vec<Option<Vec<f64>>> = spans.iter().map(split).collect();
    let mut added: Vec<Vec<f64>> = own.iter().cloned().map(Option::unwrap_or_default).collect();
    let is_full = |i: &usize| own[*i].as_ref().is_some_and(Vec::is_empty);
    for i in (0..spans.len()).filter(is_full) {
        let halved = |j: usize| Some((j, spans[j].divided(2, |_| 1.0))).filter(|h| !h.1.is_empty());
        let beside = [(0..i).rev().find_map(halved), (i + 1..spans.len()).find_map(halved)];
        for (j, halves) in beside.into_iter().flatten() {
            if added[j].is_empty() {
                added[j] = halves;
            }
        }
    }
    added.concat()
}

/// The data inside a span.
struct SpanData<'a> {
    ends: &'a [f64],
    parameters: &'a [f64],
    misses: &'a [f64],
    /// Parameters nearer to one another are one.
    same: f64,
}

impl<'a> SpanData<'a> {
    fn new(ends: &'a [f64], parameters: &'a [f64], misses: &'a [f64], same: f64) -> Self {
        let first = parameters.partition_point(|&t| t <= ends[0]);
        let last = parameters.partition_point(|&t| t < ends[1]).max(first);
        Self { ends, parameters: &parameters[first..last], misses: &misses[first..last], same }
    }

    /// Knots between the points that divide the sum of what the misses weigh into equal parts.
    fn divided(&self, n_parts: usize, weight: impl Fn(f64) -> f64) -> Vec<f64> {
        let weights: Vec<f64> = self.misses.iter().map(|&miss| weight(miss)).collect();
        let share = weights.iter().sum::<f64>() / n_parts as f64;
        let (mut sum, mut before) = (0.0, 0);
        let mut added: Vec<f64> = Vec::new();
        for part in 1..n_parts {
            while before < weights.len() && sum + weights[before] < share * part as f64 {
                sum += weights[before];
                before += 1;
            }
            // From there outwards, the first gap between two points.
            let lowest = added.last().copied().unwrap_or(self.ends[0]);
            let gaps = (before..weights.len().saturating_sub(1)).chain((0..before).rev());
            let knot = gaps
                .filter_map(|i| Some([*self.parameters.get(i)?, *self.parameters.get(i + 1)?]))
                .map(|[a, b]| (0.5 * (a + b), b - a))
                .find(|&(t, gap)| {
                    self.same < gap && self.same < t - lowest && self.same < self.ends[1] - t
                })
                .map(|(t, _)| t);
            added.extend(knot);
        }
        added
    }
}

/// Knots for `n_points` control points, denser where the curve's next derivative would be large.
///
/// De Boor, *A Practical Guide to Splines*, §XII (`NEWNOT`).
pub(super) fn by_need(curve: &NurbsCurve, n_points: usize) -> KnotVector {
    let degree = curve.degree();
    let breaks = curve.knots().breaks();
    let needs = needs(curve, &breaks);

    // Walk along the curve, a knot after each equal share of the whole.
    let shares: Vec<f64> =
        needs.iter().zip(breaks.windows(2)).map(|(n, b)| n * (b[1] - b[0])).collect();
    let n_spans = n_points - degree;
    let step = shares.iter().sum::<f64>() / n_spans as f64;
    let mut inner = Vec::with_capacity(n_spans);
    let (mut span, mut before) = (0, 0.0);
    for i in 1..n_spans {
        let target = step * i as f64;
        while span + 1 < shares.len() && before + shares[span] < target {
            before += shares[span];
            span += 1;
        }
        inner.push(breaks[span] + (target - before) / needs[span]);
    }
    let [start, end] = [breaks[0], breaks[breaks.len() - 1]].map(|t| vec![t; degree + 1]);
    KnotVector::new(degree, [&start[..], &inner, &end].concat())
        .unwrap_or_else(|_| curve.knots().clone())
}

/// The root of order p + 1 of the derivative of that order, from the jumps of the one below.
fn needs(curve: &NurbsCurve, breaks: &[f64]) -> Vec<f64> {
    let degree = curve.degree();
    let highest: Vec<DVec3> = breaks
        .windows(2)
        .map(|ends| curve.derivatives_at(0.5 * (ends[0] + ends[1]), degree)[degree])
        .collect();
    let slope = |i: usize| {
        let width = 0.5 * (breaks[i + 2] - breaks[i]);
        highest[i].distance(highest[i + 1]) / width
    };
    let slopes: Vec<f64> = (0..highest.len() - 1).map(slope).collect();
    let around = |i: usize| {
        let [before, after] = [i.checked_sub(1), Some(i)].map(|i| slopes.get(i?).copied());
        let near: Vec<f64> = [before, after].into_iter().flatten().collect();
        let mean = near.iter().sum::<f64>() / near.len().max(1) as f64;
        libm::pow(mean, 1.0 / (degree + 1) as f64)
    };
    let needs: Vec<f64> = (0..highest.len()).map(around).collect();
    let mean = needs.iter().sum::<f64>() / needs.len() as f64;
    let least = if mean > 0.0 { LEAST_KNOT_DENSITY * mean } else { 1.0 };
    needs.into_iter().map(|need| need.max(least)).collect()
}
