//! Meshes over a grid of parameters.

use glam::{DVec2, DVec3};

use super::Mesh;
use crate::kernel::{
    Bounds, GeomError, Grid, GridSamples, NurbsSurface, tolerance::VANISHING_RELATIVE,
};

/// The mesh of `n_u` × `n_v` cells, evenly spaced in the parameters, two triangles a cell.
///
/// Vertex `i * (n_v + 1) + j` is the surface point at the i-th u and the j-th v; the triangles are
/// counter-clockwise seen from Su × Sv. Where an edge of the surface is collapsed to a point,
/// triangles without area are left out, and vertices that then belong to none.
///
/// # Errors
/// [`GeomError::CountTooSmall`] without cells, [`GeomError::TooManyVertices`].
pub fn grid_mesh(
    surface: &NurbsSurface,
    n_u: usize,
    n_v: usize,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    check_counts(n_u, n_v, max_vertices)?;
    Ok(mesh_over(surface, &surface.domain_u().steps(n_u), &surface.domain_v().steps(n_v)))
}

/// # Errors
/// [`GeomError::CountTooSmall`] without cells, [`GeomError::TooManyVertices`].
pub(super) fn check_counts(n_u: usize, n_v: usize, most: usize) -> Result<(), GeomError> {
    for (what, got) in [("the number of cells along u", n_u), ("the number of cells along v", n_v)]
    {
        if got == 0 {
            return Err(GeomError::CountTooSmall { what, got, needed: 1 });
        }
    }
    check_vertices(n_u, n_v, most)
}

/// # Errors
/// [`GeomError::TooManyVertices`] for more than the ceiling, or than a triangle can name.
pub(super) fn check_vertices(n_u: usize, n_v: usize, most: usize) -> Result<(), GeomError> {
    let most = most.min(u32::MAX as usize);
    let got = n_u.saturating_add(1).saturating_mul(n_v.saturating_add(1));
    if got <= most { Ok(()) } else { Err(GeomError::TooManyVertices { got, most }) }
}

/// The mesh whose vertices are the points at all pairs of the parameters.
pub(super) fn mesh_over(surface: &NurbsSurface, us: &[f64], vs: &[f64]) -> Mesh {
    mesh_of(surface.samples_on_grid(us, vs), us, vs)
}

/// The mesh of the points at all pairs of the parameters.
pub(super) fn mesh_of(samples: GridSamples, us: &[f64], vs: &[f64]) -> Mesh {
    let GridSamples { points, normals } = samples;
    let triangles = triangles_over(&points);
    // Row by row, because a flat_map does not know its length and would move what it collects.
    let mut uvs = Vec::with_capacity(us.len() * vs.len());
    for &u in us {
        uvs.extend(vs.iter().map(|&v| DVec2::new(u, v)));
    }
    let mesh = Mesh {
        vertices: points.into_values(),
        normals: normals.into_values(),
        uvs,
        triangles,
        ..Mesh::default()
    };
    let is_whole = mesh.triangles.len() == 2 * (us.len() - 1) * (vs.len() - 1);
    if is_whole { mesh } else { mesh.without_strays() }
}

/// Two triangles for each cell of a grid of points, less those on the boundary without area.
fn triangles_over(points: &Grid<DVec3>) -> Vec<[u32; 3]> {
    let (n_rows, n_columns) = (points.n_rows() as u32, points.n_columns() as u32);
    let (last_i, last_j) = (n_rows.saturating_sub(2), n_columns.saturating_sub(2));
    let mut triangles = Vec::with_capacity(2 * (last_i as usize + 1) * (last_j as usize + 1));
    let has_area = area_test(points);
    for i in 0..=last_i {
        for j in 0..=last_j {
            let a = i * n_columns + j;
            let (b, d) = (a + n_columns, a + 1);
            let cell = [[a, b, b + 1], [a, b + 1, d]];
            if i == 0 || i == last_i || j == 0 || j == last_j {
                triangles.extend(cell.into_iter().filter(&has_area));
            } else {
                triangles.extend(cell);
            }
        }
    }
    triangles
}

/// Whether the corners of a triangle are three places, up to rounding.
fn area_test(points: &Grid<DVec3>) -> impl Fn(&[u32; 3]) -> bool {
    let magnitude = Bounds::of(points.iter().copied()).map_or(0.0, Bounds::magnitude);
    let rounding = VANISHING_RELATIVE * magnitude;
    move |triangle| {
        let [a, b, c] = triangle.map(|i| points.as_slice()[i as usize]);
        [a.distance(b), b.distance(c), c.distance(a)].into_iter().all(|side| rounding < side)
    }
}
