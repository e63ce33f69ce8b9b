//! Newton's method towards the nearest places of two curves.

use glam::DVec3;

use crate::{
    Interval,
    ceiling::NEWTON_STEPS,
    curve::{NurbsCurve, representation::part::CurvePart},
    frame::norm,
    homogeneous,
    numeric::{
        golden_section::golden_section,
        linear::TwoEquations,
        newton::{NewtonStep, to_foot, within_limits},
    },
    tolerance::LAST_BIT,
};

/// Cells of a stretch that are looked at for the nearest point.
const FOOT_CELLS: usize = 16;

/// Steps of both parameters to the nearest approach of two tangents.
pub(in crate::curve) fn nearest_step(
    apart: DVec3,
    first: DVec3,
    second: DVec3,
) -> Option<[f64; 2]> {
    let (aa, ab, bb) = (first.dot(first), first.dot(second), second.dot(second));
    let [x, y] = [-apart.dot(first), apart.dot(second)];
    let steps = TwoEquations::symmetric(aa, -ab, bb).solved([x, y]);
    steps.iter().all(|step| step.is_finite()).then_some(steps)
}

/// The distance of a point from a short part of a curve.
pub(super) fn nearest_on(curve: &NurbsCurve, interval: Interval, p: DVec3) -> f64 {
    let t = nearest_parameter(curve, interval, p, interval.at(0.5));
    [t, interval.start(), interval.end()]
        .into_iter()
        .map(|t| curve.point_at(t).distance(p))
        .fold(f64::INFINITY, f64::min)
}

/// Whether a short piece of a curve, hardly longer than its chord, comes to a point within the tolerance. The first place
/// that does is enough.
pub(super) fn comes_near(curve: &NurbsCurve, piece: &CurvePart, p: DVec3, tolerance: f64) -> bool {
    let interval = piece.interval;
    let limits = [interval.start(), interval.end()];
    let [from, to] =
        [piece.points[0], piece.points[piece.points.len() - 1]].map(homogeneous::project);
    let chord = to - from;
    let fraction = (p - from).dot(chord) / chord.length_squared();
    let fraction = if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.5 };
    let is_still = |[t]: [f64; 1], [next]: [f64; 1]| (next - t).abs() <= LAST_BIT * t.abs();
    let mut is_near = false;
    let found = within_limits([limits], [interval.at(fraction)], NEWTON_STEPS, is_still, |[t]| {
        let derivatives = curve.velocity_at(t);
        is_near = derivatives[0].distance(p) <= tolerance;
        if is_near { NewtonStep::Stay } else { to_foot(p - derivatives[0], derivatives[1]) }
    });
    let ends = [found.place()[0], interval.start(), interval.end()];
    is_near || ends.into_iter().any(|t| curve.point_at(t).distance(p) <= tolerance)
}

/// The parameter of a short part of a curve that is nearest to a point: Newton's method on its
/// tangents.
pub(super) fn nearest_parameter(
    curve: &NurbsCurve,
    interval: Interval,
    p: DVec3,
    start: f64,
) -> f64 {
    let limits = [interval.start(), interval.end()];
    let is_still = |[t]: [f64; 1], [next]: [f64; 1]| (next - t).abs() <= LAST_BIT * t.abs();
    let found = within_limits([limits], [start], NEWTON_STEPS, is_still, |[t]| {
        let derivatives = curve.velocity_at(t);
        to_foot(p - derivatives[0], derivatives[1])
    });
    found.place()[0]
}

/// The limits of parameters within one width of an interval, and of the domain.
pub(super) fn beside(curve: &NurbsCurve, interval: Interval) -> [f64; 2] {
    let (width, domain) = (interval.length(), curve.domain());
    let low = (interval.start() - width).max(domain.start());
    [low, (interval.end() + width).min(domain.end())]
}

/// A parameter of the domain for one that goes on over the seam.
pub(super) fn inside(curve: &NurbsCurve, t: f64) -> f64 {
    let domain = curve.domain();
    let turned = match t {
        _ if t < domain.start() => t + domain.length(),
        _ if domain.end() < t => t - domain.length(),
        _ => t,
    };
    turned.clamp(domain.start(), domain.end())
}

/// The point at a parameter that may go on over the seam.
pub(super) fn place(curve: &NurbsCurve, t: f64) -> DVec3 {
    curve.point_at(inside(curve, t))
}

/// The parameter of a stretch that is nearest to a point: the best of some places, and the nearest
/// one beside it.
pub(super) fn foot(curve: &NurbsCurve, stretch: Interval, p: DVec3) -> f64 {
    let apart = |t: f64| norm(place(curve, t) - p);
    let places = stretch.steps(FOOT_CELLS);
    let heights: Vec<f64> = places.iter().map(|&t| apart(t)).collect();
    let lowest =
        (0..heights.len()).fold(0, |low, i| if heights[i] < heights[low] { i } else { low });
    let bracket = [places[lowest.saturating_sub(1)], places[(lowest + 1).min(FOOT_CELLS)]];
    let newton = newton_foot(curve, bracket, p, places[lowest]);
    let (t, height) = newton.map_or_else(|| golden_section(apart, bracket), |t| (t, apart(t)));
    if heights[lowest] < height { places[lowest] } else { t }
}

/// Newton's method on the tangents within a bracket; none where it does not come to rest.
fn newton_foot(curve: &NurbsCurve, bracket: [f64; 2], p: DVec3, start: f64) -> Option<f64> {
    let is_still = |[t]: [f64; 1], [next]: [f64; 1]| {
        (next - t).abs() <= LAST_BIT * t.abs().max(bracket[1] - bracket[0])
    };
    let found = within_limits([bracket], [start], NEWTON_STEPS, is_still, |[t]| {
        let derivatives = curve.velocity_at(inside(curve, t));
        to_foot(p - derivatives[0], derivatives[1])
    });
    found.settled().map(|[t]| t)
}
