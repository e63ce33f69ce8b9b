//! The mesh of a sphere, or of a part of one: strips between rows, and between these and the edges.

use glam::DVec3;

use super::{
    Mesh,
    ball::Ball,
    ball_rows::{BallRow, RowEnd, RowLayout},
    seam::Vertices,
    stitch::{Stitcher, StripVertex, rounding_of, stitched},
    surface_patch::{Cells, SurfacePatch},
};
use crate::{Direction, GeomError, frame::unit};

/// Layouts that are tried, each a little narrower: steps are laid by arcs, and triangles are looked at one by one.
const LAYOUTS: usize = 6;
const NARROWER: f64 = 0.98;

/// Where rows begin behind an edge, in steps, in turns.
const OFFSETS: [f64; 2] = [0.25, 0.75];

/// The mesh of a sheet whose edges have these vertices: of a ball in rows, if such keep to the tolerance, else a grid.
///
/// # Errors
/// Those of [`stitched`].
pub(super) fn meshed(
    sheet: &SurfacePatch<'_>,
    cells: &Cells,
    edges: &[Vertices; 4],
    most: usize,
) -> Result<Mesh, GeomError> {
    let n_cells = cells.lines.iter().map(|lines| lines.len() - 1).fold(1, usize::saturating_mul);
    // Of too many the grid tells.
    if let Some(ball) = cells.ball().filter(|_| n_cells <= most) {
        let found = ball_mesh(sheet, ball, (edges, rounding_of(edges)), 2 * n_cells)?;
        if let Some(mesh) = found {
            return Ok(mesh);
        }
    }
    stitched(sheet, cells, edges, most)
}

/// The mesh of a ball whose edges have these vertices, with fewer than `fewer` triangles; none where no layout is within
/// the tolerance.
///
/// # Errors
/// That the work was ended.
fn ball_mesh(
    sheet: &SurfacePatch<'_>,
    ball: &Ball,
    (edges, rounding): (&[Vertices; 4], f64),
    fewer: usize,
) -> Result<Option<Mesh>, GeomError> {
    let end = |number: usize| {
        let legs = edges[number].windows(2).map(|pair| pair[0].1.distance(pair[1].1));
        let longest = legs.fold(0.0, f64::max);
        if longest <= rounding { RowEnd::Pole } else { RowEnd::Legs(longest) }
    };
    let first = [2, 0][ball.around];
    let ends = [first, first + 1].map(end);
    let mut reach = ball.reach;
    for _ in 0..LAYOUTS {
        let rows = RowLayout { ball, reach, ends }.rows();
        let n: usize = rows.iter().map(|row| row.n).sum();
        if rows.is_empty() || fewer <= 2 * n {
            return Ok(None);
        }
        GeomError::go_on(n)?;
        let mut stitcher = Stitcher::new(sheet, rounding);
        stitcher.ball(ball, &rows, edges);
        let mesh = stitcher.mesh.without_strays();
        let off = |point: &DVec3| (point.distance(ball.center) - ball.radius).abs();
        let off = mesh.vertices.iter().map(off).fold(0.0, f64::max);
        let is_within = mesh.corners().all(|corners| ball.allows(corners, sheet.tolerance(), off));
        if is_within && mesh.n_triangles() < fewer {
            return Ok(Some(mesh));
        }
        reach *= NARROWER;
    }
    Ok(None)
}

impl Stitcher<'_, '_> {
    fn ball(&mut self, ball: &Ball, rows: &[BallRow], edges: &[Vertices; 4]) {
        let around = ball.around;
        let whole = ball.angles[around].whole();
        let spline = self.sheet.spline.evaluator();
        let mut strips: Vec<Vec<StripVertex>> = Vec::with_capacity(rows.len());
        let mut places: Vec<f64> = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            let across = ball.angles[around.other()].parameter(row.along);
            let step = whole / row.n as f64;
            let vertex = |k: usize| {
                let at = ball.angles[around].parameter((k as f64 + OFFSETS[i % 2]) * step);
                let [u, v] = around.pair(at, across);
                let point = spline.point_at(u, v);
                let out = unit(point - ball.center).unwrap_or(DVec3::Z);
                let normal = if ball.is_outward { out } else { -out };
                StripVertex::new(at, self.add([u, v], point, normal))
            };
            strips.push((0..row.n).map(vertex).collect());
            places.push(across);
        }
        for pair in strips.windows(2) {
            self.zip_by_length(&pair[0], &pair[1], around == Direction::V);
        }
        let inner = |number: usize| {
            let is_last = number % 2 == 1;
            if is_along(number, around) {
                let row = if is_last { strips.len() - 1 } else { 0 };
                return strips[row].clone();
            }
            let end = |row: &Vec<StripVertex>| if is_last { row[row.len() - 1] } else { row[0] };
            strips.iter().zip(&places).map(|(row, &at)| end(row).moved(at)).collect()
        };
        self.strips_to(edges, inner);
    }

    /// Triangles between two rows, each time with the shorter of both sides that may come next.
    fn zip_by_length(&mut self, first: &[StripVertex], second: &[StripVertex], turns: bool) {
        let place = |vertex: StripVertex, mesh: &Mesh| mesh.vertices[vertex.number() as usize];
        let (mut i, mut j) = (0, 0);
        loop {
            let (a, b) = (first[i], second[j]);
            let side = |from: StripVertex, to: Option<&StripVertex>, mesh: &Mesh| {
                to.map_or(f64::INFINITY, |&to| place(from, mesh).distance_squared(place(to, mesh)))
            };
            let (next, other) = (first.get(i + 1), second.get(j + 1));
            let is_first = side(b, next, &self.mesh) <= side(a, other, &self.mesh);
            match (next, other) {
                (Some(&next), _) if is_first => {
                    self.triangle([a, next, b].map(StripVertex::number), turns);
                    i += 1;
                }
                (_, Some(&other)) => {
                    self.triangle([a, other, b].map(StripVertex::number), turns);
                    j += 1;
                }
                _ => break,
            }
        }
    }
}

/// Whether the edge of this number runs along a direction.
fn is_along(number: usize, direction: Direction) -> bool {
    (number < 2) == (direction == Direction::V)
}
