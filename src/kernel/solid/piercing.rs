//! Where curves go through the skin of a solid.

use std::sync::Arc;

use super::{Solid, box_around};
use crate::{Curve, CurveSurfaceIntersection, GeomError, Surface, Tolerance, sorting::sort_by};

/// A place that a curve has in common with the skin of a solid.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsCurve, NurbsSurface, Solid, Tolerance, glam::DVec3};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?), Tolerance::DEFAULT)?;
/// let ball = Solid::new(&[sphere], Tolerance::DEFAULT)?;
/// let line = NurbsCurve::line(DVec3::new(0.5, 0.0, 0.0), DVec3::new(8.5, 0.0, 0.0))?;
/// let places = ball.piercings(&line.into(), Tolerance::DEFAULT)?;
/// assert_eq!((places.len(), places[0].face), (1, 0));
/// assert!((places[0].place.t - 1.5 / 8.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveSolidIntersection {
    /// The number of the face.
    pub face: usize,
    /// On the curve, and on the face.
    pub place: CurveSurfaceIntersection,
}

impl Solid {
    /// Every place that a curve has in common with the faces, within the tolerance's distance, by the parameter on
    /// the curve; on an edge or at a corner that of the first face.
    ///
    /// # Errors
    /// Those of [`Surface::piercings`], such as of a curve that runs along a face or beside it on its surface.
    pub fn piercings(
        &self,
        curve: &Curve,
        tolerance: Tolerance,
    ) -> Result<Vec<CurveSolidIntersection>, GeomError> {
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let mut found: Vec<CurveSolidIntersection> = Vec::new();
        for (face, own) in self.faces.iter().enumerate() {
            let places = Surface::Nurbs(Arc::clone(own.surface())).piercings(curve, tolerance)?;
            let on_face = places.into_iter().filter(|place| own.has(place.uv, tolerance));
            found.extend(on_face.map(|place| CurveSolidIntersection { face, place }));
        }
        sort_by(&mut found, |a, b| a.place.t.total_cmp(&b.place.t).then(a.face.cmp(&b.face)));
        let mut places: Vec<CurveSolidIntersection> = Vec::with_capacity(found.len());
        for next in found {
            if let Some(last) = places.last_mut() {
                // A curve may come through one point twice.
                let between = curve.point_at(0.5 * (last.place.t + next.place.t))?;
                let is_near = |point| next.place.point.distance(point) <= 2.0 * distance;
                if is_near(last.place.point) && is_near(between) {
                    if next.face < last.face {
                        *last = next;
                    }
                    continue;
                }
            }
            places.push(next);
        }
        Ok(places)
    }
}
