//! Surfaces between curves.

use glam::DVec4;

use super::NurbsSurface;
use crate::kernel::{GeomError, Grid, KnotVector, NurbsCurve, make_compatible};

impl NurbsSurface {
    /// The straight lines between points of equal parameter: `c0` at v = 0, `c1` at v = 1, u along
    /// the curves on the domain of `c0`.
    ///
    /// Linear in homogeneous space, so that both curves are met exactly also where their weights
    /// differ. Piegl & Tiller, *The NURBS Book*, §8.4.
    ///
    /// # Errors
    /// Those of [`make_compatible`].
    pub fn ruled(c0: &NurbsCurve, c1: &NurbsCurve) -> Result<Self, GeomError> {
        let curves = make_compatible(&[c0.clone(), c1.clone()])?;
        let rows: Vec<Vec<DVec4>> =
            curves.iter().map(|curve| curve.control_points().to_vec()).collect();
        let net = Grid::from_rows(rows)?.transposed();
        Ok(Self::trusted(curves[0].knots().clone(), KnotVector::bezier(1)?, net))
    }
}
