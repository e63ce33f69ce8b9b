//! Newton's method towards the nearest places of two curves.

use glam::DVec3;

use super::MAX_STEPS;
use crate::kernel::{Interval, curve::NurbsCurve, tolerance::LAST_BIT};

/// Steps of both parameters to the nearest approach of two tangents.
pub(super) fn nearest_step(apart: DVec3, first: DVec3, second: DVec3) -> Option<(f64, f64)> {
    let (aa, ab, bb) = (first.dot(first), first.dot(second), second.dot(second));
    let determinant = aa * bb - ab * ab;
    let (x, y) = (-apart.dot(first), apart.dot(second));
    let steps = ((x * bb + y * ab) / determinant, (y * aa + x * ab) / determinant);
    (steps.0.is_finite() && steps.1.is_finite()).then_some(steps)
}

/// The distance of a point from a short part of a curve.
pub(super) fn nearest_on(curve: &NurbsCurve, interval: Interval, p: DVec3) -> f64 {
    let t = nearest_parameter(curve, interval, p, interval.at(0.5));
    [t, interval.start(), interval.end()]
        .into_iter()
        .map(|t| curve.point_at(t).distance(p))
        .fold(f64::INFINITY, f64::min)
}

/// The parameter of a short part of a curve that is nearest to a point: Newton's method on its
/// tangents.
pub(super) fn nearest_parameter(
    curve: &NurbsCurve,
    interval: Interval,
    p: DVec3,
    start: f64,
) -> f64 {
    let mut t = start;
    for _ in 0..MAX_STEPS {
        let derivatives = curve.derivatives_at(t, 1);
        let step = (p - derivatives[0]).dot(derivatives[1]) / derivatives[1].length_squared();
        if !step.is_finite() {
            return t;
        }
        let next = (t + step).clamp(interval.start(), interval.end());
        if (next - t).abs() <= LAST_BIT * t.abs() {
            return next;
        }
        t = next;
    }
    t
}

/// A parameter within one width of an interval, and of the domain.
pub(super) fn beside(curve: &NurbsCurve, interval: Interval, t: f64) -> f64 {
    let (width, domain) = (interval.length(), curve.domain());
    let low = (interval.start() - width).max(domain.start());
    t.clamp(low, (interval.end() + width).min(domain.end()))
}
