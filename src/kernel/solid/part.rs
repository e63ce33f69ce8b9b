//! Parts of faces inside and outside of a solid.

use super::{Solid, SolidError};
use crate::{Cutter, Face, FaceError, GeomError, RegionSide, Tolerance};

impl Solid {
    /// The parts of a face that are inside of the solid, or on its border, or those outside.
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
    ///
    /// let whole = |surface| Face::whole(Arc::new(surface), Tolerance::DEFAULT);
    /// let ball = Solid::new(&[whole(NurbsSurface::sphere(Frame::XY, 1.0)?)?], Tolerance::DEFAULT)?;
    /// let [x, y] = [DVec3::X * 2.0, DVec3::Y * 2.0];
    /// let sheet = whole(NurbsSurface::bilinear(-x - y, y - x, x - y, x + y)?)?;
    /// let inside = ball.parts_of(&sheet, true, Tolerance::DEFAULT)?;
    /// let outside = ball.parts_of(&sheet, false, Tolerance::DEFAULT)?;
    /// let area = |parts: &[Face]| Face::mass_of(parts).map(|mass| mass.amount);
    /// assert!((area(&inside)? - PI).abs() < 1e-9 && (area(&outside)? - (16.0 - PI)).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Face::split`] but for a solid that does not meet the face or only touches it;
    /// [`SolidError::UnclearSide`] of a part that is on neither side, or on both.
    pub fn parts_of(
        &self,
        face: &Face,
        is_inside: bool,
        tolerance: Tolerance,
    ) -> Result<Vec<Face>, GeomError> {
        let cutter = Cutter::Faces(self.faces().into());
        let parts = match face.split(&[cutter], tolerance) {
            Err(GeomError::Face(
                FaceError::Misses { .. }
                | FaceError::TouchesAt { .. }
                | FaceError::TouchesAlong { .. }
                | FaceError::Covered { .. },
            )) => vec![face.clone()],
            found => found?,
        };
        let n_parts = parts.len();
        let mut kept = Vec::new();
        for part in parts {
            if self.has_within(&part, tolerance)? == is_inside {
                kept.push(part);
            }
        }
        // What only touches it divides nothing.
        Ok(if kept.len() == n_parts { vec![face.clone()] } else { kept })
    }

    /// Whether a face that its border does not cross is inside, or lies on that.
    fn has_within(&self, face: &Face, tolerance: Tolerance) -> Result<bool, GeomError> {
        let places = face.some_places(tolerance);
        let mut found = [false; 2];
        for &place in &places {
            match self.side_of(place, tolerance)? {
                RegionSide::Outside => found[0] = true,
                RegionSide::Inside => found[1] = true,
                RegionSide::Border => {}
            }
        }
        match found {
            [false, false] if face.has_inner_place(&places, tolerance) => Ok(true),
            [is_outside, is_inside] if is_outside != is_inside => Ok(is_inside),
            _ => {
                let point = places.first().copied().unwrap_or_default();
                Err(SolidError::UnclearSide { point, distance: 0.0 }.into())
            }
        }
    }
}
