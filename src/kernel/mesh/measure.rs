//! Area, volume and centres of meshes.
//!
//! Sums over the triangles, and over the tetrahedra that they span with a vertex of the mesh, so
//! that one far away keeps its digits.

use glam::DVec3;

use super::{Mesh, MeshError};
use crate::{GeomError, Tolerance};

impl Mesh {
    /// Sum of the areas of the triangles.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.corners().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
    }

    /// Enclosed volume, negative where the triangles face inward; only closed meshes enclose one.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.tetrahedra().map(|(volume, _)| volume).sum()
    }

    /// Centre of gravity of the triangles as thin plates.
    ///
    /// # Errors
    /// [`GeomError::NothingThere`] where they have no area.
    pub fn area_centroid(&self) -> Result<DVec3, GeomError> {
        let origin = self.origin();
        let plate = |[a, b, c]: [DVec3; 3]| {
            let (x, y, z) = (a - origin, b - origin, c - origin);
            (0.5 * (b - a).cross(c - a).length(), (x + y + z) / 3.0)
        };
        Ok(origin + centre(self.corners().map(plate), "area")?)
    }

    /// Centre of gravity of what a closed mesh encloses.
    ///
    /// # Errors
    /// [`GeomError::NothingThere`] where it encloses nothing.
    pub fn volume_centroid(&self) -> Result<DVec3, GeomError> {
        Ok(self.origin() + centre(self.tetrahedra(), "volume")?)
    }

    /// Whether it encloses a volume: closed, its triangles facing alike.
    ///
    /// # Errors
    /// [`MeshError::Open`], [`MeshError::Unoriented`]; each with a place.
    pub fn check_solid(&self, tolerance: Tolerance) -> Result<(), GeomError> {
        let topology = self.topology(tolerance);
        if let Some(&[from, _]) = topology.boundary().first() {
            let open = MeshError::Open {
                edges: topology.boundary().len(),
                loops: topology.boundary_lines().len(),
                at: self.vertices[from as usize],
            };
            return Err(open.into());
        }
        match topology.turned_edge() {
            Some([from, _]) => {
                Err(MeshError::Unoriented { at: self.vertices[from as usize] }.into())
            }
            None => Ok(()),
        }
    }

    fn origin(&self) -> DVec3 {
        self.vertices.first().copied().unwrap_or_default()
    }

    /// Volume and centre, from the first vertex, of the tetrahedra between it and the triangles.
    fn tetrahedra(&self) -> impl Iterator<Item = (f64, DVec3)> {
        let origin = self.origin();
        self.corners().map(move |corners| {
            let [a, b, c] = corners.map(|corner| corner - origin);
            (a.dot(b.cross(c)) / 6.0, 0.25 * (a + b + c))
        })
    }
}

/// The mean of places by weight.
fn centre(
    parts: impl Iterator<Item = (f64, DVec3)>,
    what: &'static str,
) -> Result<DVec3, GeomError> {
    let add = |(weight, moment): (f64, DVec3), (more, place): (f64, DVec3)| {
        (weight + more, moment + place * more)
    };
    let (weight, moment) = parts.fold((0.0, DVec3::ZERO), add);
    let place = moment / weight;
    if place.is_finite() { Ok(place) } else { Err(GeomError::NothingThere { what }) }
}
