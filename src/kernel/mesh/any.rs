//! Meshes and polygons of surfaces and curves of either kind.
//!
//! A function is brought to a spline within half of the tolerance, and that is divided within the
//! other half; the vertices are points of the function itself.

use glam::DVec3;

use super::{Mesh, grid::check_counts, grid::mesh_of, tessellate, tessellate_curve};
use crate::kernel::{Curve, GeomError, ParametricSurface, Surface};

/// Part of a tolerance that goes to the spline near a function.
const SHARE: f64 = 0.5;

/// A mesh of the surface, whose triangles are nowhere further than `tolerance` from it.
///
/// # Errors
/// As [`tessellate`], and as [`ParametricSurface::to_nurbs`].
pub fn tessellate_any(
    surface: &Surface,
    tolerance: f64,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    match surface {
        Surface::Nurbs(surface) => tessellate(surface, tolerance, max_vertices),
        Surface::Parametric(function) if 0.0 < tolerance => {
            let spline = function.to_nurbs(SHARE * tolerance)?;
            let mesh = tessellate(&spline, (1.0 - SHARE) * tolerance, max_vertices)?;
            moved_to(function, mesh)
        }
        Surface::Parametric(_) => {
            Err(GeomError::NotPositive { what: "the tolerance", got: tolerance })
        }
    }
}

/// The mesh with its vertices on the function.
fn moved_to(function: &ParametricSurface, mut mesh: Mesh) -> Result<Mesh, GeomError> {
    for (vertex, uv) in mesh.vertices.iter_mut().zip(&mesh.uvs) {
        *vertex = function.point_at(uv.x, uv.y)?;
    }
    Ok(mesh)
}

/// The mesh of `n_u` × `n_v` cells, evenly spaced in the parameters, as [`super::grid_mesh`].
///
/// # Errors
/// As [`super::grid_mesh`], and as [`Surface::point_at`].
pub fn grid_mesh_any(
    surface: &Surface,
    n_u: usize,
    n_v: usize,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    check_counts(n_u, n_v, max_vertices)?;
    let (us, vs) = (surface.domain_u().steps(n_u), surface.domain_v().steps(n_v));
    Ok(mesh_of(surface.samples_on_grid(&us, &vs)?, &us, &vs))
}

/// Points on the curve whose polygon is nowhere further than `tolerance` from it; of a function
/// to the 1e-13 of its size that its stand-in is away.
///
/// # Errors
/// As [`tessellate_curve`], and as [`Curve::spline`].
pub fn tessellate_curve_any(
    curve: &Curve,
    tolerance: f64,
    max_points: usize,
) -> Result<Vec<DVec3>, GeomError> {
    tessellate_curve(&*curve.spline()?, tolerance, max_points)
}
