//! The triangles of faces.

use super::{Face, division::Division};
use crate::{
    Direction, GeomError, Mesh, NurbsCurve, Region, TessellationOptions,
    mesh::{PartLoops, PartsTessellation, tessellate_parts},
    tessellate_finely,
};

impl Face {
    /// Its mesh, as fine as is asked for; triangles face to the side of Su × Sv.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{CircleForm, Face, Frame, NurbsCurve, NurbsSurface, TessellationOptions, Tolerance, glam::DVec3};
    ///
    /// let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?);
    /// let window = NurbsCurve::ellipse(Frame::XY.at(DVec3::new(0.5, 0.5, 0.0)), [0.2; 2], CircleForm::NinePoint)?;
    /// let face = Face::within(sphere, &[window], Tolerance::DEFAULT)?;
    /// let mesh = face.mesh(&TessellationOptions::within(1e-4), 100_000)?;
    /// assert!((mesh.area() / face.mass()?.amount - 1.0).abs() < 1e-3);
    /// assert!(mesh.vertices().iter().all(|vertex| (vertex.length() - 1.0).abs() < 1e-14));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`tessellate_finely`]; [`crate::RegionError::Unclear`] where borders come too near one
    /// another.
    pub fn mesh(&self, options: &TessellationOptions, most: usize) -> Result<Mesh, GeomError> {
        let surface = &*self.plane.surface;
        if self.is_whole() {
            return tessellate_finely(surface, options, most);
        }
        let loops = self.part_loops(options.weld)?;
        tessellate_parts(surface, &loops, self.plane.is_closed, options, most)
    }

    /// The loops of parameters of its parts, none of which goes over a line where the derivative of the surface
    /// jumps.
    ///
    /// # Errors
    /// [`crate::RegionError::Unclear`].
    pub(crate) fn part_loops(&self, tolerance: f64) -> Result<Vec<PartLoops>, GeomError> {
        let parts = self.between_breaks(tolerance)?;
        let loops = parts.iter().map(|part| {
            let arcs = |arcs: &[NurbsCurve]| {
                arcs.iter().map(|arc| self.plane.to_parameters(arc)).collect()
            };
            part.arcs().map(arcs).collect()
        });
        Ok(loops.collect())
    }

    /// Its parts as they become triangles, none beyond the limits.
    ///
    /// # Errors
    /// Those of [`PartsTessellation::settled`].
    pub(crate) fn tessellation<'a>(
        &'a self,
        loops: &'a [PartLoops],
        options: &TessellationOptions,
        most: usize,
    ) -> Result<PartsTessellation<'a>, GeomError> {
        let surface = &*self.plane.surface;
        let settled =
            PartsTessellation::settled(surface, loops, self.plane.is_closed, options, most);
        Ok(settled?.0)
    }

    /// Its parts, divided along the lines where the derivative of the surface jumps.
    fn between_breaks(&self, tolerance: f64) -> Result<Vec<Region>, GeomError> {
        let mut lines = Vec::new();
        let [u, v] = self.plane.domains();
        for along in Direction::BOTH {
            for line in self.plane.surface.breaks_of_derivative(along) {
                let ends = match along {
                    Direction::U => [[line.at, v.start()], [line.at, v.end()]],
                    Direction::V => [[u.start(), line.at], [u.end(), line.at]],
                };
                let [a, b] = ends.map(|end| self.plane.place(end));
                lines.push(NurbsCurve::line(a, b)?);
            }
        }
        if lines.is_empty() {
            return Ok(self.parts.clone());
        }
        let division = Division::of(self, &lines, tolerance, 1).map_err(self.in_space())?;
        Ok(division.all().into_iter().flatten().collect())
    }
}
