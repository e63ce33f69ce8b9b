//! Meshes over a grid of parameters.

use bytemuck::zeroed_vec;
use glam::{DVec2, DVec3};

use super::Mesh;
use crate::{
    Bounds, CountError, GeomError, Grid, GridSamples, NurbsSurface, side_by_side,
    tolerance::VANISHING_RELATIVE,
};

/// The mesh of `n_u` × `n_v` cells, evenly spaced in the parameters, two triangles a cell, made by up
/// to `n_threads` threads.
///
/// Vertex `i * (n_v + 1) + j` is the surface point at the i-th u and the j-th v; the triangles are
/// counter-clockwise seen from Su × Sv. Where an edge of the surface is collapsed to a point,
/// triangles without area are left out, and vertices that then belong to none.
///
/// # Errors
/// [`CountError::CountTooSmall`] without cells, [`CountError::TooManyVertices`].
pub fn grid_mesh(
    surface: &NurbsSurface,
    n_u: usize,
    n_v: usize,
    max_vertices: usize,
    n_threads: usize,
) -> Result<Mesh, GeomError> {
    check_counts(n_u, n_v, max_vertices)?;
    let (us, vs) = (surface.domain_u().steps(n_u), surface.domain_v().steps(n_v));
    Ok(mesh_of(surface.samples_on_grid(&us, &vs, n_threads), [&us, &vs], n_threads))
}

/// # Errors
/// [`CountError::CountTooSmall`] without cells, [`CountError::TooManyVertices`].
pub(super) fn check_counts(n_u: usize, n_v: usize, most: usize) -> Result<(), GeomError> {
    for (what, got) in [("the number of cells along u", n_u), ("the number of cells along v", n_v)]
    {
        if got == 0 {
            return Err(CountError::CountTooSmall { what, got, needed: 1 }.into());
        }
    }
    check_vertices(n_u, n_v, most)
}

/// # Errors
/// [`CountError::TooManyVertices`] for more than the ceiling, or than a triangle can name.
pub(super) fn check_vertices(n_u: usize, n_v: usize, most: usize) -> Result<(), GeomError> {
    let most = most.min(u32::MAX as usize);
    let got = n_u.saturating_add(1).saturating_mul(n_v.saturating_add(1));
    if got <= most {
        Ok(())
    } else {
        Err(GeomError::Count(CountError::TooManyVertices { got, most }))
    }
}

/// The mesh of the points at all pairs of the parameters.
pub(super) fn mesh_of(samples: GridSamples, [us, vs]: [&[f64]; 2], n_threads: usize) -> Mesh {
    let GridSamples { points, normals } = samples;
    let triangles = triangles_over(&points, n_threads);
    let mut uvs: Vec<DVec2> = zeroed_vec(us.len() * vs.len());
    side_by_side::each(side_by_side::parts(&mut uvs, vs.len(), n_threads), |rows| {
        for (row, &u) in rows.values.chunks_mut(vs.len()).zip(&us[rows.first..]) {
            row.iter_mut().zip(vs).for_each(|(uv, &v)| *uv = DVec2::new(u, v));
        }
    });
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
fn triangles_over(points: &Grid<DVec3>, n_threads: usize) -> Vec<[u32; 3]> {
    let n_columns = points.n_columns();
    let (n_u, n_v) = (points.n_rows() - 1, n_columns - 1);
    let cell = |i: usize, j: usize| {
        let a = (i * n_columns + j) as u32;
        let (b, d) = (a + n_columns as u32, a + 1);
        [[a, b, b + 1], [a, b + 1, d]]
    };
    let mut triangles: Vec<[u32; 3]> = zeroed_vec(2 * n_u * n_v);
    side_by_side::each(side_by_side::parts(&mut triangles, 2 * n_v, n_threads), |rows| {
        for (i, row) in (rows.first..).zip(rows.values.chunks_mut(2 * n_v)) {
            for (j, both) in row.chunks_exact_mut(2).enumerate() {
                both.copy_from_slice(&cell(i, j));
            }
        }
    });
    let has_area = area_test(points);
    let is_on_boundary = |i: usize, j: usize| i == 0 || i == n_u - 1 || j == 0 || j == n_v - 1;
    let across = (0..n_u).flat_map(|i| [(i, 0), (i, n_v - 1)]);
    let mut boundary = across.chain((0..n_v).flat_map(|j| [(0, j), (n_u - 1, j)]));
    if !boundary.all(|(i, j)| cell(i, j).iter().all(&has_area)) {
        let mut at = 0..;
        triangles.retain(|triangle| {
            let at = at.next().unwrap_or(0) / 2;
            !is_on_boundary(at / n_v, at % n_v) || has_area(triangle)
        });
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
