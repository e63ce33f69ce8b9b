//! Surfaces of one patch in the power basis.

use glam::{DVec3, DVec4};

use crate::{
    FormError, GeomError, Grid,
    curve::powers,
    homogeneous,
    surface::{Direction, NurbsSurface},
};

impl NurbsSurface {
    /// Coefficients cᵢⱼ of Σ cᵢⱼ uⁱ vʲ, lowest powers first, rows along u.
    ///
    /// The basis is changed along v in each row, then along u in each column. Piegl & Tiller, *The
    /// NURBS Book*, §1.5.
    ///
    /// # Errors
    /// [`FormError::OtherForm`] with weights, and of more than one patch.
    pub fn power_coefficients(&self) -> Result<Grid<DVec3>, GeomError> {
        if self.is_rational() {
            let wanted = "a polynomial in u and v has no weights";
            let found = "those of the surface differ".to_owned();
            return Err(FormError::OtherForm { wanted, found }.into());
        }
        let [n_u, n_v] = self.n_patches();
        if n_u * n_v != 1 {
            let wanted = "a polynomial in u and v has one patch";
            let found = format!("the surface has {n_u} along u and {n_v} along v");
            return Err(FormError::OtherForm { wanted, found }.into());
        }
        let patch = self.clamped(Direction::U).clamped(Direction::V);
        let net = patch.control_points();
        let row = |i: usize| {
            let points = (0..net.n_columns()).map(|j| net.get(i, j).truncate()).collect();
            powers(points, self.domain_v())
        };
        let rows: Vec<Vec<DVec3>> = (0..net.n_rows()).map(row).collect();
        let column = |j: usize| powers(rows.iter().map(|row| row[j]).collect(), self.domain_u());
        let columns: Vec<Vec<DVec3>> = (0..net.n_columns()).map(column).collect();
        let places = || columns.iter().flatten().map(|c| c.extend(1.0));
        homogeneous::check_finite(&places().collect::<Vec<DVec4>>())?;
        let row = |i: usize| columns.iter().map(|column| column[i]).collect();
        Grid::from_rows((0..net.n_rows()).map(row).collect())
    }
}
