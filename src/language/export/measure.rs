//! What a file of meshes holds, by measure: the parts that are written, counted and measured, so
//! that two of them can be compared without their bytes.

use glam::DVec3;

use super::{
    ExportError, Job,
    shape::{MeshShape, ShapedItem, shapes},
};
use crate::kernel::{Bounds, Tolerance, distance_to_polyline};

/// A mesh, polyline or point as a file holds it.
pub struct MeasuredPart<'a> {
    shaped: ShapedItem<'a>,
    tolerance: Tolerance,
}

impl std::fmt::Debug for MeasuredPart<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Part").field(&self.shaped.item.name).finish()
    }
}

/// The parts that a file of meshes is made of.
///
/// # Errors
/// [`ExportError::Geometry`] where a curve or surface has no mesh.
pub fn parts(job: &Job) -> Result<Vec<MeasuredPart<'_>>, ExportError> {
    let tolerance = Tolerance::DEFAULT.with_distance(job.precision);
    Ok(shapes(job)?.into_iter().map(|shaped| MeasuredPart { shaped, tolerance }).collect())
}

impl MeasuredPart<'_> {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.shaped.item.name
    }

    /// What it is, how much of it there is, and how large it is, a line for each: the box around it;
    /// of a mesh its area, and the volume if it encloses one; of a polyline its length.
    #[must_use]
    pub fn measures(&self) -> Vec<String> {
        let triple = |place: DVec3| format!("({}, {}, {})", place.x, place.y, place.z);
        let mut lines = vec![match &self.shaped.shape {
            MeshShape::Mesh(_) => "mesh".to_owned(),
            MeshShape::Polyline(_) => "polyline".to_owned(),
            MeshShape::Point(place) => format!("point {}", triple(*place)),
        }];
        if let Some([red, green, blue]) = self.shaped.item.color {
            lines.push(format!("color {red} {green} {blue}"));
        }
        if let MeshShape::Point(_) = self.shaped.shape {
            return lines;
        }
        let (n_vertices, n_triangles) = (self.shaped.n_vertices(), self.shaped.n_triangles());
        lines.push(format!("{n_vertices} vertices"));
        if let MeshShape::Mesh(_) = self.shaped.shape {
            lines.push(format!("{n_triangles} triangles"));
        }
        if let Some(bounds) = self.bounds() {
            lines.push(format!("bounds {} to {}", triple(bounds.min), triple(bounds.max)));
        }
        match &self.shaped.shape {
            MeshShape::Mesh(mesh) => {
                lines.push(format!("area {}", mesh.area()));
                lines.push(match mesh.check_solid(self.tolerance) {
                    Ok(()) => format!("volume {}", mesh.volume()),
                    Err(_) => "encloses no volume".to_owned(),
                });
            }
            MeshShape::Polyline(points) => {
                let length: f64 = points.windows(2).map(|leg| leg[0].distance(leg[1])).sum();
                lines.push(format!("length {length}"));
            }
            MeshShape::Point(_) => {}
        }
        lines
    }

    /// Up to `most` of its vertices, evenly from the first to the last; of a point none, which is
    /// measured by its place.
    #[must_use]
    pub fn places(&self, most: usize) -> Vec<DVec3> {
        let points = self.shaped.points();
        let n_places = match self.shaped.shape {
            MeshShape::Point(_) => 0,
            _ => most.min(points.len()),
        };
        let last = points.len().saturating_sub(1);
        (0..n_places).map(|i| points[i * last / n_places.saturating_sub(1).max(1)]).collect()
    }

    /// How far a place is from it; none if there is nothing of it.
    #[must_use]
    pub fn distance_to(&self, place: DVec3) -> Option<f64> {
        match &self.shaped.shape {
            // A vertex that is there spares the search over all triangles.
            MeshShape::Mesh(mesh) if mesh.vertices().contains(&place) => Some(0.0),
            MeshShape::Mesh(mesh) => mesh.distance_to(place),
            MeshShape::Polyline(points) => distance_to_polyline(place, points),
            MeshShape::Point(point) => Some(point.distance(place)),
        }
    }

    /// The diagonal of the box around it.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.bounds().map_or(0.0, Bounds::diagonal)
    }

    fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.shaped.points().iter().copied())
    }
}
