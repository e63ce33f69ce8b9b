//! What distances are measured from, and what comes of many of them.

use glam::DVec3;

use super::{GeomError, NurbsSurface, Surface, mesh::MeshDistance, surface::ParametricPlaces};

/// Distances of places from a surface or from a mesh.
///
/// ```
/// use virote_kernel::{DeviationReference, NurbsSurface, Surface, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let square = Surface::from(NurbsSurface::bilinear(o, y, x, x + y)?);
/// let above = [DVec3::new(0.5, 0.5, 1.0), DVec3::new(0.5, 0.5, 3.0)];
/// let found = DeviationReference::of_surface(&square)?.deviation_of(&above)?;
/// let told = found.map(|found| (found.max, found.mean, found.at));
/// assert_eq!(told, Some((3.0, 2.0, above[1])));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The largest.
    pub max: f64,
    /// Their mean.
    pub mean: f64,
    /// The place that is farthest away.
    pub at: DVec3,
}

/// A surface or a mesh, prepared to be asked for its distance from places.
///
/// Distances from a sphere are those from its centre less its radius:
///
/// ```
/// use virote_kernel::{DeviationReference, Frame, NurbsSurface, Surface, glam::DVec3};
///
/// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 2.0)?);
/// let distance = DeviationReference::of_surface(&sphere)?.distance(DVec3::new(3.0, 0.0, 4.0))?;
/// assert!((distance - 3.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Debug)]
pub enum DeviationReference<'a> {
    /// All of a NURBS surface.
    Surface(&'a NurbsSurface),
    /// All of the surface of a function.
    Function(ParametricPlaces<'a>),
    /// All triangles of a mesh.
    Mesh(MeshDistance<'a>),
}

impl<'a> DeviationReference<'a> {
    /// All of a surface.
    ///
    /// # Errors
    /// As [`Surface::point_at`].
    pub fn of_surface(surface: &'a Surface) -> Result<Self, GeomError> {
        Ok(match surface {
            Surface::Nurbs(surface) => Self::Surface(surface),
            Surface::Parametric(surface) => Self::Function(surface.places()?),
        })
    }

    /// How far a place is from its nearest one.
    ///
    /// # Errors
    /// As [`Surface::point_at`].
    pub fn distance(&self, place: DVec3) -> Result<f64, GeomError> {
        match self {
            Self::Surface(surface) => Ok(surface.closest(place).distance),
            Self::Function(places) => Ok(places.closest(place)?.distance),
            Self::Mesh(mesh) => Ok(mesh.distance(place)),
        }
    }

    /// How far points are from it; `None` of no points.
    ///
    /// # Errors
    /// As [`Self::distance`].
    pub fn deviation_of(&self, points: &[DVec3]) -> Result<Option<Deviation>, GeomError> {
        let mut found: Option<Deviation> = None;
        let mut sum = 0.0;
        for &point in points {
            let distance = self.distance(point)?;
            sum += distance;
            if found.is_none_or(|found| found.max < distance) {
                found = Some(Deviation { max: distance, mean: 0.0, at: point });
            }
        }
        Ok(found.map(|found| Deviation { mean: sum / points.len() as f64, ..found }))
    }
}
