//! Meshes and polygons of surfaces and curves of either kind.
//!
//! A function is brought to a spline within a small part of the tolerance, and that is divided within
//! the rest; the vertices are points of the function itself.

use glam::DVec3;

use super::{
    Mesh, TessellationOptions, grid::check_counts, grid::mesh_of, tessellate_all, tessellate_curve,
};
use crate::{Curve, GeomError, Surface};

/// A mesh of the surface within the limits.
///
/// # Errors
/// As [`tessellate_all`].
pub fn tessellate_any(
    surface: &Surface,
    limits: &TessellationOptions,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    let meshes = tessellate_all(std::slice::from_ref(surface), limits, max_vertices)?;
    Mesh::merged(&meshes, max_vertices)
}

/// The mesh of `n_u` × `n_v` cells, evenly spaced in the parameters, as [`super::grid_mesh`], by up to
/// `n_threads` threads.
///
/// # Errors
/// As [`super::grid_mesh`], and as [`Surface::point_at`].
pub fn grid_mesh_any(
    surface: &Surface,
    n_u: usize,
    n_v: usize,
    max_vertices: usize,
    n_threads: usize,
) -> Result<Mesh, GeomError> {
    check_counts(n_u, n_v, max_vertices)?;
    let (us, vs) = (surface.domain_u().steps(n_u), surface.domain_v().steps(n_v));
    Ok(mesh_of(surface.samples_on_grid(&us, &vs, n_threads)?, [&us, &vs], n_threads))
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
