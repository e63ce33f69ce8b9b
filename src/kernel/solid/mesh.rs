//! The triangles of solids: one closed mesh.

use super::{Solid, SolidError, box_around};
use crate::{
    Face, GeomError, Mesh, TessellationOptions, Tolerance, ceiling::CROSSING_VERTICES,
    tolerance::DEFAULT_CHORD_RELATIVE, trim::joined_meshes,
};

/// How many times nearer the second mesh is that is asked whether a solid goes through itself.
const NEARER: f64 = 16.0;

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

    /// The same, unless a shell goes through itself.
    ///
    /// Its mesh tells: an edge of that goes through a triangle of another place, with both ends deeper than the mesh
    /// is away from the faces, and so does one of a mesh that is much nearer. What is smaller is not seen, and neither
    /// is anything of a solid with too large a mesh.
    ///
    /// # Errors
    /// [`SolidError::CrossesItself`]; `GeomError::Ended`.
    pub(super) fn uncrossed(self, tolerance: Tolerance) -> Result<Self, GeomError> {
        let size = box_around(&self.faces).diagonal();
        let weld = tolerance.distance_for(size);
        for faces in self.shells() {
            let crossing = |chord: f64| {
                let options = TessellationOptions { weld, ..TessellationOptions::within(chord) };
                let made = joined_meshes(&[], &faces, &options, CROSSING_VERTICES)?;
                Mesh::merged(&made.faces, CROSSING_VERTICES)?.crossing(2.0 * chord)
            };
            let chord = DEFAULT_CHORD_RELATIVE * size;
            match crossing(chord) {
                Err(GeomError::Ended) => return Err(GeomError::Ended),
                // Whatever keeps the mesh from telling is no fault of the solid.
                Err(_) | Ok(None) => continue,
                // Sides that are nearer to one another than their chords seem to cross.
                Ok(Some(point)) => match crossing(chord / NEARER) {
                    Err(GeomError::Ended) => return Err(GeomError::Ended),
                    Ok(None) => continue,
                    Err(_) | Ok(Some(_)) => {
                        return Err(SolidError::CrossesItself { point }.into());
                    }
                },
            }
        }
        Ok(self)
    }
}
