//! Pieces of degree 5 along the offset of a smooth curve, each with a proof of its accuracy.

use glam::{DVec3, DVec4};

use super::{CurveOffsetTarget, unweighted};
use crate::{
    ConstructionError, CountError, GeomError, Interval, KnotVector, NurbsCurve,
    bernstein::{binomials, derivative, product},
    bezier,
    ceiling::OFFSET_HALVINGS,
    homogeneous,
    tolerance::VANISHING_RELATIVE,
};

/// Point, first and second derivative.
type SecondOrderPoint = [DVec3; 3];

/// Bézier pieces that follow the offset of a curve without corners, in order.
pub(super) fn pieces(
    curve: &NurbsCurve,
    aim: CurveOffsetTarget,
) -> Result<Vec<NurbsCurve>, GeomError> {
    let mut pieces = Vec::new();
    for span in curve.knots().spans() {
        let whole = bezier::piece(curve.knots(), curve.control_points(), span);
        let mut todo = vec![(curve.knots().span_interval(span), whole, 0)];
        while let Some((interval, points, n_halvings)) = todo.pop() {
            GeomError::go_on(1)?;
            let fitted = fitted(&points, interval, aim)?;
            if deviation(&points, &fitted, aim) <= aim.accuracy {
                let knots = KnotVector::bezier(5)?.on(interval);
                pieces.push(NurbsCurve::new(knots, unweighted(&fitted))?);
            } else if n_halvings == OFFSET_HALVINGS {
                return Err(ConstructionError::NoOffset { parameter: interval.at(0.5) }.into());
            } else {
                let (left, right) = bezier::cut_at(&points, 0.5);
                let halves = interval.halves();
                todo.push((halves[1], right, n_halvings + 1));
                todo.push((halves[0], left, n_halvings + 1));
            }
            let most = crate::ceiling::CONTROL_POINTS;
            if most < 6 * (pieces.len() + todo.len()) {
                return Err(CountError::TooManyPoints { got: 6 * pieces.len(), most }.into());
            }
        }
    }
    // Both are near the true offset; if it leaps there, a cusp was not found.
    let leaps = |pair: &&[NurbsCurve]| 4.0 * aim.accuracy < pair[0].end().distance(pair[1].start());
    match pieces.windows(2).find(leaps) {
        Some(pair) => Err(GeomError::Construction(ConstructionError::NoOffset {
            parameter: pair[0].domain().end(),
        })),
        None => Ok(pieces),
    }
}

/// Control points of the quintic in contact with the offset at both ends of a Bézier piece.
fn fitted(
    points: &[DVec4],
    interval: Interval,
    aim: CurveOffsetTarget,
) -> Result<Vec<DVec3>, GeomError> {
    let backwards: Vec<DVec4> = points.iter().rev().copied().collect();
    let [a, da, dda] = contact(points, aim.distance, aim, interval.start())?;
    // Backwards the right side is the left one.
    let [b, db, ddb] = contact(&backwards, -aim.distance, aim, interval.end())?;
    let inner = |at: DVec3, slope: DVec3, bend: DVec3| {
        let next = at + slope / 5.0;
        [next, next * 2.0 - at + bend / 20.0]
    };
    let ([a1, a2], [b1, b2]) = (inner(a, da, dda), inner(b, db, ddb));
    Ok(vec![a, a1, a2, b2, b1, b])
}

/// Point and derivatives of the offset at the start of a Bézier piece, by its local parameter.
///
/// Where the curve stands still there, its direction is that of the first derivative that does not
/// vanish, and the power of the parameter before it cancels.
fn contact(
    points: &[DVec4],
    distance: f64,
    aim: CurveOffsetTarget,
    parameter: f64,
) -> Result<SecondOrderPoint, GeomError> {
    let degree = points.len() - 1;
    let start = homogeneous::place(points[0]);
    let far = |&point: &DVec4| homogeneous::place(point).distance(start);
    let size = points.iter().map(far).fold(0.0, f64::max);
    let vanishes = |term: &&DVec3| term.length() <= aim.rounding.max(VANISHING_RELATIVE * size);
    let mut series = taylor(points, 3);
    let mut n_vanishing = series.iter().skip(1).take_while(vanishes).count();
    if 0 < n_vanishing {
        // The numerator of a rational tangent has at most twice the degree.
        series = taylor(points, 2 * degree + 3);
        n_vanishing = series.iter().skip(1).take_while(vanishes).count();
    }
    if 2 * degree <= n_vanishing {
        return Err(ConstructionError::NoOffset { parameter }.into());
    }
    // The direction, up to a factor: C' without its zeros, made normal to the normal.
    let across = |k: usize| {
        let order = n_vanishing + k + 1;
        (series[order] * order as f64).cross(aim.normal)
    };
    let [a0, a1, a2] = [0, 1, 2].map(across);
    let l0 = a0.length();
    if l0 <= VANISHING_RELATIVE * series[n_vanishing + 1].length() {
        return Err(ConstructionError::AlongNormal { parameter }.into());
    }
    // The series of a/|a|.
    let u0 = a0 / l0;
    let l1 = u0.dot(a1);
    let u1 = (a1 - u0 * l1) / l0;
    let l2 = (a1.dot(a1) + 2.0 * a0.dot(a2) - l1 * l1) / (2.0 * l0);
    let u2 = (a2 - u1 * l1 - u0 * l2) / l0;
    Ok([series[0] + u0 * distance, series[1] + u1 * distance, (series[2] + u2 * distance) * 2.0])
}

/// Coefficients of the power series in space at the start of a Bézier piece.
fn taylor(points: &[DVec4], order: usize) -> Vec<DVec3> {
    let mut differences = points.to_vec();
    let mut derivatives = Vec::with_capacity(order + 1);
    for _ in 0..=order {
        derivatives.push(differences[0]);
        differences = derivative(&differences);
    }
    homogeneous::series(&derivatives)
}

/// How far the fitted piece is at most from the offset, by its coefficients.
///
/// With V from the curve to the fitted piece, the true offset is where V has no part along the
/// tangent, none along the normal, and length d: three polynomials, which bound how far it is.
fn deviation(points: &[DVec4], fitted: &[DVec3], aim: CurveOffsetTarget) -> f64 {
    let weights: Vec<f64> = points.iter().map(|point| point.w).collect();
    let slopes = derivative(points);
    let along = product(&slopes, points, |slope, point| {
        (slope.truncate() * point.w - point.truncate() * slope.w).cross(aim.normal)
    });
    let heaviest = weights.iter().copied().fold(0.0, f64::max);
    let side = without_end_zeros(&along, aim.rounding * heaviest * heaviest);
    let ones = [1.0; 6];
    let curve = product(points, &ones, |point, one| point.truncate() * one);
    let mut arm = product(fitted, &weights, |point, w| point * w);
    for (arm, point) in arm.iter_mut().zip(&curve) {
        *arm -= *point;
    }

    let least_weight = weights.iter().copied().fold(f64::INFINITY, f64::min);
    let middle = side[side.len() / 2].normalize_or_zero();
    let least_side = side.iter().map(|side| side.dot(middle)).fold(f64::INFINITY, f64::min);
    if !(0.0 < least_weight && 0.0 < least_side) {
        return f64::INFINITY;
    }
    let largest = |values: Vec<f64>| values.into_iter().map(f64::abs).fold(0.0, f64::max);
    let along = largest(product(&arm, &side, |arm, side| arm.dot(side.cross(aim.normal))))
        / (least_weight * least_side);
    let upward = arm.iter().map(|arm| arm.dot(aim.normal).abs()).fold(0.0, f64::max) / least_weight;
    let squares = product(&weights, &weights, |a, b| a * b * aim.distance * aim.distance);
    let excess: Vec<f64> = product(&arm, &arm, DVec3::dot)
        .into_iter()
        .zip(product(&squares, &[1.0; 11], |a, one| a * one))
        .map(|(square, wanted)| square - wanted)
        .collect();
    let in_square =
        largest(excess) / (least_weight * least_weight) + along * along + upward * upward;
    if aim.distance * aim.distance <= in_square {
        return f64::INFINITY;
    }
    let across = in_square / aim.distance.abs();
    (along * along + upward * upward + across * across).sqrt()
}

/// The polynomial divided by the powers of t and 1 − t that it contains.
fn without_end_zeros(coefficients: &[DVec3], rounding: f64) -> Vec<DVec3> {
    let size = coefficients.iter().map(|c| c.length()).fold(0.0, f64::max);
    let is_zero = |c: &&DVec3| c.length() <= rounding.max(VANISHING_RELATIVE * size);
    let n = coefficients.len() - 1;
    let n_start = coefficients.iter().take_while(is_zero).count().min(n);
    let n_end = coefficients.iter().rev().take_while(is_zero).count().min(n - n_start);
    let rest = n - n_start - n_end;
    let (of_all, of_rest) = (binomials(n), binomials(rest));
    (0..=rest).map(|i| coefficients[i + n_start] * (of_all[i + n_start] / of_rest[i])).collect()
}
