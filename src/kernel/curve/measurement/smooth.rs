//! Whether the pieces of a curve go over into one another at a parameter.

use crate::{
    Side,
    curve::Curve,
    tolerance::{KNOT_DERIVATIVE_ROUNDINGS, LAST_BIT},
};

impl Curve {
    /// Whether the derivatives up to an order are the same on both sides of a parameter, beyond rounding. Of a function
    /// and at the ends of the domain they are taken to be.
    ///
    /// ```
    /// use virote_kernel::{Curve, NurbsCurve, glam::DVec3};
    ///
    /// let corner = Curve::from(NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::ONE])?);
    /// assert!(!corner.is_smooth_at(1.0, 1) && corner.is_smooth_at(1.0, 0) && corner.is_smooth_at(0.5, 3));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    #[must_use]
    pub fn is_smooth_at(&self, t: f64, order: usize) -> bool {
        let Self::Nurbs(curve) = self else { return true };
        let (knots, domain) = (curve.knots(), curve.knots().domain());
        let sides = [Side::Left, Side::Right];
        let spans = sides.map(|side| knots.span_beside(t, side));
        let is_knot = domain.start() < t && t < domain.end() && spans[0] != spans[1];
        if !is_knot || knots.exact_multiplicity(t) + order <= knots.degree() {
            return true;
        }
        let [before, behind] = sides.map(|side| curve.derivatives_beside(t, side, order));
        let width = spans.map(|span| knots.span_interval(span).length());
        let width = width[0].min(width[1]);
        // What a derivative may be, by those of lower orders; and what rounding leaves of it.
        let mut size = 0.0_f64;
        let mut rounding = KNOT_DERIVATIVE_ROUNDINGS * LAST_BIT * curve.magnitude();
        for (k, (before, behind)) in before.iter().zip(&behind).enumerate() {
            if 0 < k {
                size = (size / width).max(before.length()).max(behind.length());
                rounding /= width;
            }
            if LAST_BIT.sqrt() * size + rounding < before.distance(*behind) {
                return false;
            }
        }
        true
    }
}
