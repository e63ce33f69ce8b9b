//! Meshes and polygons within a tolerance, by bounds.
//!
//! `bend` bounds the derivatives of a surface, `cell_bounds` makes of them the cells that a mesh may
//! have, `steps` lays lines through the parameters that keep to these, `seam` divides the edges, and
//! `ball_mesh` makes the triangles of each `surface_patch`, of all but balls as `stitch` does.

use glam::DVec3;

use super::{
    Mesh, MeshError, TessellationOptions,
    ball_mesh::meshed,
    cell_bounds::CellBounds,
    chord::chord_deviation,
    passing::cells_and_vertices,
    seam::{SharedEdges, Vertices},
    surface_patch::{Cells, SurfacePatch},
    unfolding::is_folded,
};
use crate::{
    CountError, GeomError, NurbsCurve, NurbsSurface, Surface, bezier,
    ceiling::{PARAMETER_HALVINGS, TESSELLATION_ROUNDS, UNFOLDING_ROUNDS},
    side_by_side,
    tolerance::PATH_ROUNDING,
    work,
};

/// How much smaller one round may make the cells, and how much more than the measured excess.
pub(super) const MAX_GROWTH: f64 = 1.5;

pub(super) const ANGLE_MARGIN: f64 = 1.02;

/// A round that leaves more than this part of the excess is the last one.
pub(super) const LEAST_GAIN: f64 = 0.97;

/// How much smaller cells become where they fold over one another in a plane.
const UNFOLDING: f64 = 2.0;

/// Surfaces for each thread with which all have about as much to do.
const FEW_SHEETS: usize = 4;

/// The meshes of sheets, and the vertices on the edges of each.
struct SheetMeshes {
    meshes: Vec<Mesh>,
    edges: Vec<[Vertices; 4]>,
}

/// A mesh of the surface, whose triangles are nowhere further than `tolerance` from it.
///
/// A plane needs two triangles; a sphere as many as keep them within the tolerance:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, glam::DVec3, tessellate};
///
/// let square = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y)?;
/// assert_eq!(tessellate(&square, 1e-3, 1000)?.n_triangles(), 2);
/// let ball = tessellate(&NurbsSurface::sphere(Frame::XY, 1.0)?, 1e-2, 100_000)?;
/// assert!(ball.corners().all(|[a, b, c]| 0.99 <= ((a + b + c) / 3.0).length()));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// `InputError::NotPositive` for the tolerance; [`CountError::TooManyVertices`] where it would
/// need more than the ceiling.
pub fn tessellate(
    surface: &NurbsSurface,
    tolerance: f64,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    tessellate_finely(surface, &TessellationOptions::within(tolerance), max_vertices)
}

/// A mesh of the surface as fine as is asked for.
///
/// # Errors
/// `InputError::NotPositive` for a limit that allows nothing; [`CountError::TooManyVertices`] where
/// it would need more than the ceiling.
pub fn tessellate_finely(
    surface: &NurbsSurface,
    limits: &TessellationOptions,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    limits.check()?;
    let sheet = SurfacePatch::of_spline(surface, limits.tolerance);
    let meshes = meshes_of(vec![sheet], &[], limits, max_vertices)?;
    Mesh::merged(&meshes.meshes, max_vertices)
}

/// Meshes of surfaces, which share the vertices on edges that they share.
///
/// # Errors
/// Those of [`tessellate_finely`], and as [`crate::ParametricSurface::to_nurbs`].
pub fn tessellate_all(
    surfaces: &[Surface],
    limits: &TessellationOptions,
    max_vertices: usize,
) -> Result<Vec<Mesh>, GeomError> {
    Ok(tessellate_through(surfaces, &[], limits, max_vertices)?.0)
}

/// Meshes of surfaces as [`tessellate_all`], whose edges have vertices at the places that lie on them, to the last
/// bit; and the points of all vertices on edges.
///
/// # Errors
/// Those of [`tessellate_all`].
pub(crate) fn tessellate_through(
    surfaces: &[Surface],
    places: &[DVec3],
    limits: &TessellationOptions,
    max_vertices: usize,
) -> Result<(Vec<Mesh>, Vec<DVec3>), GeomError> {
    limits.check()?;
    let sheet = |surface| SurfacePatch::new(surface, limits.tolerance);
    let sheets: Result<Vec<SurfacePatch<'_>>, GeomError> = surfaces.iter().map(sheet).collect();
    let SheetMeshes { meshes, edges } = meshes_of(sheets?, places, limits, max_vertices)?;
    Ok((meshes, edges.iter().flatten().flatten().map(|&(_, point)| point).collect()))
}

fn meshes_of(
    mut sheets: Vec<SurfacePatch<'_>>,
    places: &[DVec3],
    limits: &TessellationOptions,
    max_vertices: usize,
) -> Result<SheetMeshes, GeomError> {
    for sheet in &sheets {
        sheet.spline.check_connected()?;
        let [u, v] = sheet.domains();
        let ends = [sheet.point_at(u.start(), v.start())?, sheet.point_at(u.end(), v.end())?];
        check_rounding(limits.tolerance, far(ends))?;
    }
    // Functions of a script need a stack that only their own thread has.
    let is_function = sheets.iter().any(SurfacePatch::is_function);
    let n_threads = if is_function { 1 } else { limits.n_threads };
    let seams = SharedEdges::of(&mut sheets, places, limits)?;
    // Where there are surfaces enough, each is the work of one thread: one of a few may be most of the work.
    let of_one = if sheets.len() < FEW_SHEETS * n_threads { n_threads } else { 1 };
    let alone = TessellationOptions { n_threads: of_one, ..*limits };
    let known = seams.places();
    let counts = [max_vertices, n_threads];
    let (mut cells, mut edges) = cells_and_vertices(&seams, (&sheets, &known), &alone, counts)?;
    // None of what is not made sharper.
    let kept = |cells: &Cells| {
        cells.limits().filter(|_| limits.limits_angle() || cells.can_unfold()).cloned()
    };
    let all: Vec<Option<CellBounds>> = cells.iter().map(kept).collect();
    let mut sharpness = vec![1.0; sheets.len()];
    let mut excesses = vec![f64::INFINITY; sheets.len()];
    let numbers: Vec<usize> = (0..sheets.len()).collect();
    let mut round = 0;
    loop {
        GeomError::go_on(1)?;
        let meshes = side_by_side::map(&numbers, n_threads, |&i| {
            meshed(&sheets[i], &cells[i], &edges[i], max_vertices)
        });
        let meshes = meshes.into_iter().collect::<Result<Vec<Mesh>, GeomError>>()?;
        round += 1;
        let mut too_wide = Vec::new();
        for (i, mesh) in meshes.iter().enumerate() {
            let Some(bounds) = &all[i] else { continue };
            if bounds.can_unfold() {
                if round < UNFOLDING_ROUNDS && is_folded(mesh) {
                    sharpness[i] *= UNFOLDING;
                    too_wide.push((i, bounds));
                }
                continue;
            }
            let excess = widest_turn(mesh, limits.tolerance) / limits.angle;
            // Where the normal jumps inside a piece, no size would do.
            if round < TESSELLATION_ROUNDS && 1.0 < excess && excess < LEAST_GAIN * excesses[i] {
                sharpness[i] *= (ANGLE_MARGIN * excess).min(MAX_GROWTH);
                too_wide.push((i, bounds));
            }
            excesses[i] = excess;
        }
        if too_wide.is_empty() {
            return Ok(SheetMeshes { meshes, edges });
        }
        let narrower = side_by_side::map(&too_wide, n_threads, |&(i, bounds)| {
            sheets[i].cells(bounds.sharpened(sharpness[i]), max_vertices)
        });
        for ((i, _), narrower) in too_wide.into_iter().zip(narrower) {
            cells[i] = narrower?;
        }
        edges = seams.vertices(&sheets, &cells, &known, max_vertices, n_threads)?;
    }
}

/// The largest coordinate of both.
fn far(ends: [DVec3; 2]) -> f64 {
    ends[0].abs().max(ends[1].abs()).max_element()
}

/// Checks that places of geometry whose largest coordinate is `far` can be told apart within the
/// tolerance.
///
/// # Errors
/// [`MeshError::BelowRounding`].
pub(crate) fn check_rounding(tolerance: f64, far: f64) -> Result<(), GeomError> {
    let rounding = PATH_ROUNDING * far;
    if rounding <= tolerance {
        Ok(())
    } else {
        Err(MeshError::BelowRounding { tolerance, rounding }.into())
    }
}

/// The largest angle between normals at the corners of a triangle, of those with a side longer than
/// the tolerance: where a surface has no normal, no size would do.
pub(super) fn widest_turn(mesh: &Mesh, tolerance: f64) -> f64 {
    let mut most = 0.0_f64;
    for &corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| mesh.normals[corner as usize]);
        let chord = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
        if most < chord {
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
            let size = a.distance(b).max(b.distance(c)).max(c.distance(a));
            if tolerance < size {
                most = chord;
            }
        }
    }
    2.0 * libm::asin((0.5 * most.sqrt()).min(1.0))
}

/// Points on the curve whose polygon is nowhere further than `tolerance` from it; the ends of the
/// domain and all knots in it are among them.
///
/// A piece is halved until the control points of its quarters are that near to its chord.
///
/// # Errors
/// `InputError::NotPositive` for the tolerance; [`MeshError::BelowRounding`];
/// [`GeomError::Jump`];
/// [`CountError::TooManyVertices`] where it would need more than the ceiling.
pub fn tessellate_curve(
    curve: &NurbsCurve,
    tolerance: f64,
    max_points: usize,
) -> Result<Vec<DVec3>, GeomError> {
    let parameters = tessellation_parameters(curve, tolerance, max_points)?;
    let inner = parameters.iter().skip(1).map(|&t| curve.point_at(t));
    Ok(std::iter::once(curve.start()).chain(inner).collect())
}

/// The parameters of the points of [`tessellate_curve`].
///
/// # Errors
/// As that.
pub fn tessellation_parameters(
    curve: &NurbsCurve,
    tolerance: f64,
    max_points: usize,
) -> Result<Vec<f64>, GeomError> {
    TessellationOptions::within(tolerance).check()?;
    curve.check_connected()?;
    check_rounding(tolerance, far([curve.start(), curve.end()]))?;
    let mut parameters = vec![curve.domain().start()];
    for span in curve.knots().spans() {
        let piece = bezier::piece(curve.knots(), curve.control_points(), span);
        let mut todo = vec![(piece, curve.knots().span_interval(span), 0)];
        while work::goes_on(1)
            && let Some((piece, interval, n_halvings)) = todo.pop()
        {
            let deviation = chord_deviation(&piece, [piece[0], piece[piece.len() - 1]]);
            if n_halvings < PARAMETER_HALVINGS && tolerance < deviation {
                let (left, right) = bezier::cut_at(&piece, 0.5);
                let [before, behind] = interval.halves();
                todo.extend([(right, behind, n_halvings + 1), (left, before, n_halvings + 1)]);
            } else {
                parameters.push(interval.end());
            }
            let got = parameters.len() + todo.len();
            if max_points < got {
                return Err(CountError::TooManyVertices { got, most: max_points }.into());
            }
        }
    }
    Ok(parameters)
}
