//! Whether a curve makes detours between points.

use glam::DVec3;

use crate::NurbsCurve;

/// The way between two points may be so many times as long as straight from one tolerance around the
/// first to that around the second: that of half a circle is, and a little more.
const MOST_DETOUR: f64 = 1.7;

/// Parts of the way between two points.
const DETOUR_PARTS: usize = 4;

/// Whether a polynomial curve makes no detour between two points: where parameters slide apart, no point holds it.
pub(super) fn goes_straight(
    curve: &NurbsCurve,
    points: &[DVec3],
    parameters: &[f64],
    tolerance: f64,
) -> bool {
    let (found, knots) = (curve.evaluator(), curve.knots());
    let speeds = speeds(curve);
    let mut span = knots.degree();
    parameters.windows(2).zip(points.windows(2)).all(|(ends, points)| {
        let straight = points[0].distance(points[1]) + 2.0 * tolerance;
        let first = knots.span_from(span, ends[0]);
        span = knots.span_from(first, ends[1]);
        let most = speeds[first..=span].iter().copied().fold(0.0, f64::max);
        // Mostly the time that it takes tells.
        if most * (ends[1] - ends[0]) <= MOST_DETOUR * straight {
            return true;
        }
        let place = |k: usize| {
            let fraction = k as f64 / DETOUR_PARTS as f64;
            found.point_at((1.0 - fraction) * ends[0] + fraction * ends[1])
        };
        let legs = (0..DETOUR_PARTS).map(|k| place(k).distance(place(k + 1)));
        legs.sum::<f64>() <= MOST_DETOUR * straight
    })
}

/// For each span, by its number among the knots, what the speed of a polynomial curve there is at most: its derivative is
/// in the hull of its control points, Piegl & Tiller, *The NURBS Book*, (3.8).
fn speeds(curve: &NurbsCurve) -> Vec<f64> {
    let (degree, knots) = (curve.degree(), curve.knots().as_slice());
    let legs: Vec<f64> = curve
        .control_points()
        .windows(2)
        .enumerate()
        .map(|(i, pair)| {
            let width = knots[i + degree + 1] - knots[i + 1];
            let leg = (pair[1] - pair[0]).truncate().length();
            if 0.0 < width { degree as f64 * leg / width } else { f64::INFINITY }
        })
        .collect();
    let of_span = |span: usize| legs[span - degree..span].iter().copied().fold(0.0, f64::max);
    let n = curve.control_points().len();
    (0..n).map(|span| if span < degree { f64::INFINITY } else { of_span(span) }).collect()
}
