//! Where a spline that is fitted has its knots.

use glam::DVec3;

use crate::kernel::{GeomError, KnotVector, NurbsCurve, tolerance::PARAMETER_RELATIVE};

/// The least density of knots, as a share of the mean: no part of a curve is left without.
const LEAST_DENSITY: f64 = 0.05;

impl KnotVector {
    /// Knots for `n_points` control points that leave about as many of the parameters in each
    /// span.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (9.68) and (9.69).
    ///
    /// # Errors
    /// [`GeomError::BadDegree`] with no more points than the degree, [`GeomError::DegreeTooHigh`].
    pub fn spreading(
        degree: usize,
        n_points: usize,
        parameters: &[f64],
    ) -> Result<Self, GeomError> {
        let needed = degree + 1;
        if n_points < needed {
            return Err(GeomError::BadDegree { degree, points: n_points, needed });
        }
        let share = parameters.len() as f64 / (n_points - degree) as f64;
        let knot = |j: usize| {
            let place = j as f64 * share;
            let i = (place as usize).clamp(1, parameters.len() - 1);
            let alpha = place - i as f64;
            (1.0 - alpha) * parameters[i - 1] + alpha * parameters[i]
        };
        let inner: Vec<f64> = (1..n_points - degree).map(knot).collect();
        let [start, end] =
            [parameters[0], parameters[parameters.len() - 1]].map(|t| vec![t; needed]);
        Self::new(degree, [&start[..], &inner, &end].concat())
    }
}

/// Points for each part into which a span is divided at once.
const POINTS_A_PART: usize = 256;

/// Knots for each span with a point that is missed, where the squares of the misses divide into
/// equal parts: halves, and more where a span with hundreds of points misses by far; none where a side
/// would be left without a point.
pub(super) fn splits(
    knots: &KnotVector,
    parameters: &[f64],
    misses: &[f64],
    tolerance: f64,
) -> Vec<f64> {
    let same = PARAMETER_RELATIVE * knots.domain().length();
    let split = |ends: &[f64]| {
        let first = parameters.partition_point(|&t| t <= ends[0]);
        let last = parameters.partition_point(|&t| t < ends[1]);
        let inside = misses.get(first..last).unwrap_or_default();
        let worst = inside.iter().fold(0.0_f64, |worst, &miss| worst.max(miss));
        let n_parts = if worst <= tolerance {
            1
        } else {
            // The error falls with the width to the power of the order.
            let order = (knots.degree() + 1) as f64;
            let wanted = libm::pow(worst / tolerance, 1.0 / order) as usize;
            wanted.min(inside.len() / POINTS_A_PART).max(2)
        };
        let share = inside.iter().map(|miss| miss * miss).sum::<f64>() / n_parts as f64;
        let (mut sum, mut before) = (0.0, first);
        let mut added: Vec<f64> = Vec::new();
        for part in 1..n_parts {
            while before < last && sum + misses[before] * misses[before] < share * part as f64 {
                sum += misses[before] * misses[before];
                before += 1;
            }
            // From there outwards, the first gap between two points.
            let lowest = added.last().copied().unwrap_or(ends[0]);
            let gaps = (before..last.saturating_sub(1)).chain((first..before).rev());
            let knot = gaps
                .filter_map(|i| Some([*parameters.get(i)?, *parameters.get(i + 1)?]))
                .map(|[a, b]| (0.5 * (a + b), b - a))
                .find(|&(t, gap)| same < gap && same < t - lowest && same < ends[1] - t)
                .map(|(t, _)| t);
            added.extend(knot);
        }
        added
    };
    knots.breaks().windows(2).flat_map(split).collect()
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
    let least = if mean > 0.0 { LEAST_DENSITY * mean } else { 1.0 };
    needs.into_iter().map(|need| need.max(least)).collect()
}
