//! The triangles of solids: one closed mesh.

use super::Solid;
use crate::{Face, GeomError, Mesh, TessellationOptions, trim::joined_meshes};

impl Solid {
    /// Its mesh, as fine as is asked for: closed, with its triangles to the outside.
    ///
    /// ```
    /// use std::f64::consts::PI;
    /// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, Solid, TessellationOptions, Tolerance, glam::DVec3};
    ///
    /// let disc = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint)?;
    /// let rod = Solid::extruded(&Region::new(&disc, &[], Tolerance::DEFAULT)?, DVec3::Z * 3.0, Tolerance::DEFAULT)?;
    /// let mesh = rod.mesh(&TessellationOptions::within(1e-3), 100_000)?;
    /// assert!(mesh.check(Tolerance::DEFAULT).is_closed);
    /// assert!(mesh.volume() < 3.0 * PI && 3.0 * PI * (1.0 - 4e-3) < mesh.volume());
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`crate::Face::mesh`].
    pub fn mesh(&self, options: &TessellationOptions, most: usize) -> Result<Mesh, GeomError> {
        let faces: Vec<&Face> = self.faces.iter().collect();
        Mesh::merged(&joined_meshes(&[], &faces, options, most)?.faces, most)
    }
}
