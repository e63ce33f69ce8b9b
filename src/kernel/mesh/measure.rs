//! Area, volume and centres of meshes.
//!
//! Sums over the triangles, and over the tetrahedra that they span with a vertex of the mesh, so
//! that one far away keeps its digits.

use glam::DVec3;

use super::{Mesh, MeshError};
use crate::{
    Bounds, GeomError, MeasureError, Tolerance,
    scale::{scale_of, scaled_back},
};

impl Mesh {
    /// Sum of the areas of the triangles; zero and infinity stand for numbers too small and too large.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.measured_area().unwrap_or(0.0)
    }

    /// Sum of the areas of the triangles.
    ///
    /// # Errors
    /// [`MeasureError::TooSmallToMeasure`].
    pub fn measured_area(&self) -> Result<f64, GeomError> {
        let scale = self.scale();
        let corners = self.corners().map(|corners| corners.map(|corner| corner / scale));
        let area = corners.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum();
        scaled_back(area, scale, 2, "area")
    }

    /// Enclosed volume, negative where the triangles face inward; only closed meshes enclose one. Zero
    /// and infinity stand for numbers too small and too large.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.measured_volume().unwrap_or(0.0)
    }

    /// Enclosed volume, as [`Self::volume`].
    ///
    /// # Errors
    /// [`MeasureError::TooSmallToMeasure`].
    pub fn measured_volume(&self) -> Result<f64, GeomError> {
        let volume = self.tetrahedra().map(|(volume, _)| volume).sum::<f64>() / 6.0;
        scaled_back(volume, self.scale(), 3, "volume")
    }

    /// Centre of gravity of the triangles as thin plates.
    ///
    /// # Errors
    /// [`MeasureError::NothingThere`] where they have no area.
    pub fn area_centroid(&self) -> Result<DVec3, GeomError> {
        let (origin, scale) = (self.origin(), self.scale());
        let plate = |corners: [DVec3; 3]| {
            let [x, y, z] = corners.map(|corner| (corner - origin) / scale);
            (0.5 * (y - x).cross(z - x).length(), (x + y + z) / 3.0)
        };
        Ok(origin + scale * centre(self.corners().map(plate), "area")?)
    }

    /// Centre of gravity of what a closed mesh encloses.
    ///
    /// # Errors
    /// [`MeasureError::NothingThere`] where it encloses nothing.
    pub fn volume_centroid(&self) -> Result<DVec3, GeomError> {
        Ok(self.origin() + self.scale() * centre(self.tetrahedra(), "volume")?)
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

    /// By what the coordinates are divided to be measured.
    fn scale(&self) -> f64 {
        scale_of(self.bounds().map_or(1.0, Bounds::magnitude))
    }

    fn origin(&self) -> DVec3 {
        self.vertices.first().copied().unwrap_or_default()
    }

    /// Six times the volume, and the centre, over the scale, from the first vertex, of the tetrahedra between it and the triangles.
    fn tetrahedra(&self) -> impl Iterator<Item = (f64, DVec3)> {
        let (origin, scale) = (self.origin(), self.scale());
        self.corners().map(move |corners| {
            let [a, b, c] = corners.map(|corner| (corner - origin) / scale);
            (a.dot(b.cross(c)), 0.25 * (a + b + c))
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
    if place.is_finite() {
        Ok(place)
    } else {
        Err(GeomError::Measure(MeasureError::NothingThere { what }))
    }
}
