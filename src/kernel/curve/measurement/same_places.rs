//! Parameters that are one within rounding.
//!
//! Parameters alone do not tell: spans may be as narrow as what rounding leaves elsewhere, and the
//! curve goes on in them. So the points have to agree too.

use crate::{
    Bounds,
    curve::NurbsCurve,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
};

/// Last bits of the largest coordinate that a place that was computed of it may be wrong by.
const PLACE_ROUNDINGS: f64 = 16.0;

/// Steps of the largest parameter by which two that are one differ.
const PARAMETER_STEPS: f64 = 4.0;

/// A curve is nowhere faster than so many times its size over its domain, unless it has narrow spans.
const HASTE: f64 = 64.0;

/// What tells whether two parameters of a curve are one.
pub(in crate::curve) struct SamePlaces<'c> {
    curve: &'c NurbsCurve,
    /// How far apart they may be.
    near: f64,
    /// How far apart their points may be.
    reach: f64,
}

impl<'c> SamePlaces<'c> {
    pub(in crate::curve) fn of(curve: &'c NurbsCurve) -> Self {
        let domain = curve.domain();
        let size = Bounds::of(curve.points()).map_or(0.0, Bounds::diagonal);
        let rounding = PLACE_ROUNDINGS * LAST_BIT * curve.magnitude();
        let of_size = if rounding < size { rounding / size } else { 1.0 };
        let share = LAST_BIT.sqrt().max(of_size.min(KNOT_RELATIVE.sqrt()));
        let largest = domain.start().abs().max(domain.end().abs());
        let near = (share * domain.length()).max(PARAMETER_STEPS * LAST_BIT * largest);
        let reach = HASTE * size * (near / domain.length()) + rounding;
        Self { curve, near, reach }
    }

    /// Whether two parameters are one.
    pub(in crate::curve) fn are_one(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.near && self.agree(a, b)
    }

    /// Whether a parameter is the start or the end.
    pub(in crate::curve) fn is_end(&self, t: f64) -> bool {
        let domain = self.curve.domain();
        self.are_one(t, domain.start()) || self.are_one(t, domain.end())
    }

    fn agree(&self, a: f64, b: f64) -> bool {
        self.curve.point_at(a).distance(self.curve.point_at(b)) <= self.reach
    }

    /// Sorted parameters, each once.
    pub(in crate::curve) fn once(&self, mut sorted: Vec<f64>) -> Vec<f64> {
        sorted.dedup_by(|later, earlier| self.are_one(*earlier, *later));
        sorted
    }
}
