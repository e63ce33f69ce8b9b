//! Faces at a distance beside others.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::{Face, FaceError, border::KnownBorder, plane::ParameterPlane};
use crate::{Bounds, Direction, GeomError, Interval, NurbsSurface, Surface, Tolerance};

impl Face {
    /// The face of the surface at a distance beside its own, on the side of the normal for a positive one, within the
    /// same curves of parameters.
    ///
    /// Where the whole surface has no such offset, that of the part of it around the face is taken.
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{Cutter, Face, Frame, NurbsSurface, Tolerance, glam::DVec3};
    ///
    /// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
    /// let upper = sphere.part_at(&[Cutter::Plane(Frame::XY)], DVec3::Z, Tolerance::DEFAULT)?;
    /// let larger = upper.offset(0.5, Tolerance::DEFAULT)?;
    /// assert!((larger.mass()?.amount - 2.0 * PI * 1.5 * 1.5).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`FaceError::BeyondCentre`] where the distance passes a centre of curvature; those of [`Surface::offset`].
    pub fn offset(&self, distance: f64, tolerance: Tolerance) -> Result<Self, GeomError> {
        let whole = Surface::Nurbs(Arc::clone(&self.plane.surface));
        let moved = match beside(&whole, distance, tolerance) {
            Ok(moved) => moved,
            Err(error) => match self.surface_around()? {
                Some(part) => beside(&part.into(), distance, tolerance)?,
                None => return Err(error),
            },
        };
        let surface = Arc::new(moved);
        let plane =
            ParameterPlane { is_closed: self.plane.is_closed, ..ParameterPlane::of(surface, 0.0) };
        let stretch = [0, 1].map(|i| plane.scales[i] / self.plane.scales[i]);
        let stretch = DAffine3::from_scale(DVec3::new(stretch[0], stretch[1], 1.0));
        let parts = self.parts.iter().map(|part| part.transformed(&stretch));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        Ok(Self { plane, parts, border: KnownBorder::default() })
    }

    /// The part of its surface over the box of its parameters, closed directions as they are; none where that is all.
    fn surface_around(&self) -> Result<Option<NurbsSurface>, GeomError> {
        let arcs = self.parts.iter().flat_map(crate::Region::arcs).flatten();
        let Some(around) = arcs.map(crate::NurbsCurve::bounds).reduce(Bounds::union) else {
            return Ok(None);
        };
        let [low, high] = [around.min, around.max].map(|corner| self.plane.parameters(corner));
        let (mut part, mut is_less) = ((*self.plane.surface).clone(), false);
        for (i, along) in Direction::BOTH.into_iter().enumerate() {
            let own = Interval::new(low[i], high[i])?;
            if !self.plane.is_closed[i] && own != self.plane.domains()[i] {
                part = part.trimmed(along, own)?;
                is_less = true;
            }
        }
        Ok(is_less.then_some(part))
    }
}

/// The offset of a surface that turns back nowhere.
fn beside(
    surface: &Surface,
    distance: f64,
    tolerance: Tolerance,
) -> Result<NurbsSurface, GeomError> {
    let found = surface.offset(distance, tolerance.distance)?;
    match found.turn {
        Some(turn) => {
            let point = surface.point_at(turn.at[0], turn.at[1])?;
            Err(FaceError::BeyondCentre { point, radius: turn.radius, distance }.into())
        }
        None => Ok(found.surface),
    }
}
