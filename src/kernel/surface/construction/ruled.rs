//! Surfaces between curves.

use glam::DVec4;

use crate::{
    GeomError, Grid, KnotVector, NurbsCurve, curve::on_one_denominator, surface::NurbsSurface,
};

impl NurbsSurface {
    /// The straight lines between points of equal parameter: `c0` at v = 0, `c1` at v = 1, u along
    /// the curves on the domain of `c0`.
    ///
    /// S(u, v) = (1 − v)·c0(u) + v·c1(u) as points, exact for rational curves too: where weights
    /// differ by more than a common factor, both curves are brought over the product of their
    /// denominators first, whose degree is the sum of theirs. Linear in homogeneous space, as
    /// Piegl & Tiller have it (*The NURBS Book*, §8.4), v would depend on the weights. The definition by
    /// points: Farin, *Curves and Surfaces for CAGD*, §15.1.
    ///
    /// Straight lines between two skew ones make z = xy:
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, NurbsSurface, glam::DVec3};
    ///
    /// let level = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
    /// let rising = NurbsCurve::line(DVec3::Y, DVec3::ONE)?;
    /// let saddle = NurbsSurface::ruled(&level, &rising)?;
    /// assert_eq!(saddle.point_at(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`, where different denominators multiply; those of
    /// [`crate::make_compatible`].
    pub fn ruled(c0: &NurbsCurve, c1: &NurbsCurve) -> Result<Self, GeomError> {
        let curves = on_one_denominator(&[c0.clone(), c1.clone()])?;
        let rows: Vec<Vec<DVec4>> =
            curves.iter().map(|curve| curve.control_points().to_vec()).collect();
        let net = Grid::from_rows(rows)?.transposed();
        Ok(Self::new_unchecked(curves[0].knots().clone(), KnotVector::bezier(1)?, net))
    }
}
