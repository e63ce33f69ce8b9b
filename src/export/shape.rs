//! Geometry as what mesh formats hold: triangles, polylines and points.

use std::sync::Arc;

use glam::DVec3;

use super::{ExportError, Item, Job, Subject};
use crate::kernel::{
    Bounds, GeomError, Mesh, tessellate_any, tessellate_curve_any,
    tolerance::DEFAULT_CHORD_RELATIVE,
};

/// A subject as a mesh format holds it.
pub(super) enum Shape {
    Mesh(Arc<Mesh>),
    Polyline(Vec<DVec3>),
    Point(DVec3),
}

/// How far meshes of a job may lie from their surfaces.
pub(super) fn tolerance(job: &Job) -> f64 {
    job.tolerance.unwrap_or_else(|| {
        let whole = job.items.iter().filter_map(bounds).reduce(Bounds::union);
        let size = whole.map_or(1.0, Bounds::diagonal);
        DEFAULT_CHORD_RELATIVE * if size == 0.0 { 1.0 } else { size }
    })
}

fn bounds(item: &Item) -> Option<Bounds> {
    match &item.subject {
        Subject::Point(point) => Some(Bounds { min: *point, max: *point }),
        Subject::Curve(curve) => curve.bounds().ok(),
        Subject::Surface(surface) => surface.bounds().ok(),
        Subject::Mesh(mesh) => mesh.bounds(),
        Subject::Table(_) | Subject::Data(_) => None,
    }
}

/// The shape of an item within `tolerance`; `None` for what has no place in space.
pub(super) fn shape(item: &Item, tolerance: f64, job: &Job) -> Result<Option<Shape>, ExportError> {
    let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
    let most = job.limits.mesh_vertices;
    Ok(Some(match &item.subject {
        Subject::Point(point) => Shape::Point(*point),
        Subject::Curve(curve) => {
            Shape::Polyline(tessellate_curve_any(curve, tolerance, most).map_err(blame)?)
        }
        Subject::Surface(surface) => {
            Shape::Mesh(Arc::new(tessellate_any(surface, tolerance, most).map_err(blame)?))
        }
        Subject::Mesh(mesh) => Shape::Mesh(Arc::clone(mesh)),
        Subject::Table(_) | Subject::Data(_) => return Ok(None),
    }))
}
