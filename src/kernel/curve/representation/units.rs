//! Curves in units in which products of their coordinates are numbers.
//!
//! The square of a coordinate of 1e200 is none, and that of 1e-200 is zero. Who multiplies lengths
//! does so in other units; changing them by a power of two changes no digit.

use crate::{ConstructionReport, curve::NurbsCurve};

/// Powers of two beyond this one have no inverse.
const MOST: i32 = 1000;

/// The power of two that brings a number near to one; `None` where its cube is a number anyway, and
/// for zero.
fn factor_of(size: f64) -> Option<f64> {
    let is_moderate = (size * size * size).is_normal();
    let is_number = size.is_finite() && 0.0 < size;
    (is_number && !is_moderate).then(|| libm::ldexp(1.0, (-libm::ilogb(size)).clamp(-MOST, MOST)))
}

impl NurbsCurve {
    /// By what coordinates should be multiplied, so that their products are numbers: those of this
    /// and of other curves. `None` if they are as they are.
    pub(in crate::curve) fn unit_factor(&self, others: &[&Self]) -> Option<f64> {
        let curves = || others.iter().copied().chain([self]);
        let heaviest = |curve: &Self| curve.weights().into_iter().fold(0.0, f64::max);
        let factor = factor_of(curves().map(Self::magnitude).fold(0.0, f64::max));
        let has_odd_weights = curves().any(|curve| factor_of(heaviest(curve)).is_some());
        if has_odd_weights { factor.or(Some(1.0)) } else { factor }
    }

    /// The same curve in other units, with weights near one.
    pub(in crate::curve) fn in_units(&self, factor: f64) -> Self {
        let heaviest = self.weights().into_iter().fold(0.0, f64::max);
        let share = factor_of(heaviest).unwrap_or(1.0);
        let scaled = |point: &glam::DVec4| {
            let weighed = *point * share;
            (weighed.truncate() * factor).extend(weighed.w)
        };
        let control_points = self.control_points.iter().map(scaled).collect();
        Self {
            report: ConstructionReport::NONE,
            ..Self::new_unchecked(self.knots.clone(), control_points)
        }
    }
}
