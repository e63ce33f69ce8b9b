//! Meshes and polygons within a tolerance.
//!
//! Each span of the knots is divided evenly into more and more cells, until the distance between
//! surface and triangles is small enough where it is measured: in the middle of every edge and of
//! every cell, and at more places as long as the cells are so large that a bend could hide between
//! these. All cells lie on one grid of parameters, so there are no cracks, and every knot is a
//! grid line.

use glam::DVec3;

use super::{
    Mesh,
    grid::{check_vertices, mesh_over},
};
use crate::kernel::{
    GeomError, Grid, Interval, KnotVector, NurbsCurve, NurbsSurface, tolerance::CHORD_SAFETY,
};

/// Rounds of refinement. Each multiplies by up to [`MAX_GROWTH`]; the ceiling on vertices stops
/// earlier, so this only guards surfaces that no refinement brings nearer.
const MAX_ROUNDS: usize = 24;

/// How many times finer one round may make a span: the estimate it rests on may be far off.
const MAX_GROWTH: f64 = 4.0;

/// How many times narrower than a polynomial's the bends are that weights make and that are still
/// looked for.
const MAX_NARROWNESS: f64 = 8.0;

/// Halvings of a piece of a curve, past the last bit of its parameter.
const MAX_HALVINGS: usize = 52;

/// Rows of cells measured at a time, which bounds the memory that measuring takes.
const STRIP: usize = 32;

/// Even cells in each span of the knots along one direction.
struct Division {
    spans: Vec<Interval>,
    counts: Vec<usize>,
    /// Parts of a span that are told apart at least.
    n_places: usize,
}

/// One cell along one direction.
#[derive(Clone, Copy)]
struct Cell {
    span: usize,
    /// Index of the parameter that it begins at.
    first: usize,
    n_parts: usize,
}

/// Distances from the surface measured on one cell.
#[derive(Clone, Copy)]
struct Deviation {
    along_u: f64,
    along_v: f64,
    inside: f64,
}

/// A mesh of the surface, whose triangles are nowhere further than `tolerance` from it.
///
/// # Errors
/// [`GeomError::NotPositive`] for the tolerance; [`GeomError::TooManyVertices`] where it would
/// need more than the ceiling.
pub fn tessellate(
    surface: &NurbsSurface,
    tolerance: f64,
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    check_tolerance(tolerance)?;
    let mut along_u = Division::new(surface.knots_u(), surface);
    let mut along_v = Division::new(surface.knots_v(), surface);
    for _ in 0..MAX_ROUNDS {
        check_vertices(along_u.n_cells(), along_v.n_cells(), max_vertices)?;
        let factors = growth(surface, &along_u, &along_v, CHORD_SAFETY * tolerance);
        let grew_u = along_u.grow(&factors[0]);
        let grew_v = along_v.grow(&factors[1]);
        if !grew_u && !grew_v {
            break;
        }
    }
    check_vertices(along_u.n_cells(), along_v.n_cells(), max_vertices)?;
    Ok(mesh_over(surface, &along_u.parameters(), &along_v.parameters()))
}

/// Points on the curve whose polygon is nowhere further than `tolerance` from it; the ends of the
/// domain and all knots in it are among them.
///
/// # Errors
/// [`GeomError::NotPositive`] for the tolerance; [`GeomError::TooManyVertices`] where it would
/// need more than the ceiling.
pub fn tessellate_curve(
    curve: &NurbsCurve,
    tolerance: f64,
    max_points: usize,
) -> Result<Vec<DVec3>, GeomError> {
    check_tolerance(tolerance)?;
    let target = CHORD_SAFETY * tolerance;
    let mut points = vec![curve.start()];
    let n_places =
        places_a_span(curve.degree(), curve.control_points().iter().map(|point| point.w));
    for span in curve.knots().spans() {
        let mut todo = vec![(curve.knots().span_interval(span), 0)];
        while let Some((piece, n_halvings)) = todo.pop() {
            let n_parts = (n_places >> n_halvings).max(4);
            if n_halvings < MAX_HALVINGS && target < chord_deviation(curve, piece, n_parts) {
                let [left, right] = piece.halves();
                todo.extend([(right, n_halvings + 1), (left, n_halvings + 1)]);
            } else {
                points.push(curve.point_at(piece.end()));
            }
            let got = points.len() + todo.len();
            if max_points < got {
                return Err(GeomError::TooManyVertices { got, most: max_points });
            }
        }
    }
    Ok(points)
}

/// The largest distance of a piece of a curve from its chord, between any two of its parts.
fn chord_deviation(curve: &NurbsCurve, piece: Interval, n_parts: usize) -> f64 {
    let (a, b) = (curve.point_at(piece.start()), curve.point_at(piece.end()));
    let parts = piece.steps(n_parts);
    let mut most = 0.0_f64;
    curve.evaluator().each_point(&parts[1..n_parts], |point| {
        most = most.max(distance_to_segment(point, a, b));
    });
    most
}

/// How many parts of a span are told apart however few cells it has. A polynomial bends back
/// once a degree at most; weights that differ much make a bend narrow.
fn places_a_span(degree: usize, weights: impl Iterator<Item = f64> + Clone) -> usize {
    let low = weights.clone().fold(f64::INFINITY, f64::min);
    let high = weights.fold(0.0, f64::max);
    let narrowness = (high / low).sqrt().clamp(1.0, MAX_NARROWNESS);
    if degree <= 1 && narrowness <= 1.0 { 1 } else { (8.0 * degree as f64 * narrowness) as usize }
}

fn check_tolerance(tolerance: f64) -> Result<(), GeomError> {
    if 0.0 < tolerance && tolerance.is_finite() {
        Ok(())
    } else {
        Err(GeomError::NotPositive { what: "the tolerance", got: tolerance })
    }
}

impl Division {
    /// One cell in each span.
    fn new(knots: &KnotVector, surface: &NurbsSurface) -> Self {
        let spans: Vec<Interval> = knots.spans().map(|span| knots.span_interval(span)).collect();
        let weights = surface.control_points().iter().map(|point| point.w);
        let n_places = places_a_span(knots.degree(), weights);
        Self { counts: vec![1; spans.len()], spans, n_places }
    }

    fn n_cells(&self) -> usize {
        self.counts.iter().fold(0, |sum, &count| sum.saturating_add(count))
    }

    /// The grid lines.
    fn parameters(&self) -> Vec<f64> {
        self.parameters_in_parts(|_| 1)
    }

    /// The cells, and the parameters that divide them into parts.
    fn parts(&self) -> (Vec<Cell>, Vec<f64>) {
        let n_parts = |count: usize| (self.n_places / (2 * count)).max(1) * 2;
        let mut cells = Vec::with_capacity(self.n_cells());
        let mut first = 0;
        for (span, &count) in self.counts.iter().enumerate() {
            for _ in 0..count {
                cells.push(Cell { span, first, n_parts: n_parts(count) });
                first += n_parts(count);
            }
        }
        (cells, self.parameters_in_parts(n_parts))
    }

    fn parameters_in_parts(&self, n_parts: impl Fn(usize) -> usize) -> Vec<f64> {
        let mut parameters: Vec<f64> = Vec::with_capacity(self.n_cells() + 1);
        for (span, &count) in self.spans.iter().zip(&self.counts) {
            parameters.pop();
            parameters.extend(span.steps(n_parts(count) * count));
        }
        parameters
    }

    /// Multiplies the counts; whether any changed.
    fn grow(&mut self, factors: &[f64]) -> bool {
        let mut grew = false;
        for (count, &factor) in self.counts.iter_mut().zip(factors) {
            if 1.0 < factor {
                *count = (*count as f64 * factor.min(MAX_GROWTH)).ceil() as usize;
                grew = true;
            }
        }
        grew
    }
}

/// How many times finer each span along u and along v has to become, by the measured deviation.
fn growth(
    surface: &NurbsSurface,
    along_u: &Division,
    along_v: &Division,
    target: f64,
) -> [Vec<f64>; 2] {
    let ((cells_u, us), (cells_v, vs)) = (along_u.parts(), along_v.parts());
    let mut factors = [vec![1.0_f64; along_u.spans.len()], vec![1.0_f64; along_v.spans.len()]];
    // The largest deviation that makes a difference.
    let most = target * MAX_GROWTH * MAX_GROWTH;
    for strip in cells_u.chunks(STRIP) {
        let (Some(first), Some(last)) = (strip.first(), strip.last()) else { continue };
        let rows = &us[first.first..=last.first + last.n_parts];
        let points = surface.points_on_grid(rows, &vs);
        for cell_u in strip {
            let in_strip = Cell { first: cell_u.first - first.first, ..*cell_u };
            for cell_v in &cells_v {
                let (u, v) = (cell_u.span, cell_v.span);
                if MAX_GROWTH <= factors[0][u].min(factors[1][v]) {
                    continue;
                }
                let factor = Deviation::of_cell(&points, in_strip, *cell_v, most).factors(target);
                factors[0][u] = factors[0][u].max(factor[0]);
                factors[1][v] = factors[1][v].max(factor[1]);
            }
        }
    }
    factors
}

impl Deviation {
    /// Of the surface from the two triangles of a cell, given points over all of its parts;
    /// stops looking inside where it exceeds `most`.
    fn of_cell(points: &Grid<DVec3>, cell_u: Cell, cell_v: Cell, most: f64) -> Self {
        let point = |i: usize, j: usize| points.get(cell_u.first + i, cell_v.first + j);
        let (n, m) = (cell_u.n_parts, cell_v.n_parts);
        let (a, b, c, d) = (point(0, 0), point(n, 0), point(n, m), point(0, m));
        let mut deviation = Self { along_u: 0.0, along_v: 0.0, inside: 0.0 };
        for i in 1..n {
            let distance =
                distance_to_segment(point(i, 0), a, b).max(distance_to_segment(point(i, m), d, c));
            deviation.along_u = deviation.along_u.max(distance);
        }
        for j in 1..m {
            let distance =
                distance_to_segment(point(0, j), a, d).max(distance_to_segment(point(n, j), b, c));
            deviation.along_v = deviation.along_v.max(distance);
        }
        for i in 1..n {
            for j in 1..m {
                if most < deviation.inside.max(deviation.along_u.min(deviation.along_v)) {
                    return deviation;
                }
                let distance = distance_to_triangle(point(i, j), [a, b, c])
                    .min(distance_to_triangle(point(i, j), [a, c, d]));
                deviation.inside = deviation.inside.max(distance);
            }
        }
        deviation
    }

    /// The deviation falls with the square of the cell.
    fn factors(self, target: f64) -> [f64; 2] {
        let factor = |deviation: f64| (deviation / target).sqrt();
        let (along_u, along_v) = (factor(self.along_u), factor(self.along_v));
        let inside = factor(self.inside);
        if inside <= 1.0 || 1.0 < along_u.max(along_v) {
            return [along_u, along_v];
        }
        [inside, inside]
    }
}

fn distance_to_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let leg = b - a;
    let length_squared = leg.length_squared();
    if length_squared <= 0.0 {
        return point.distance(a);
    }
    let fraction = ((point - a).dot(leg) / length_squared).clamp(0.0, 1.0);
    point.distance(a + leg * fraction)
}

fn distance_to_triangle(point: DVec3, corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    let normal = (b - a).cross(c - a);
    let sides = [(a, b), (b, c), (c, a)];
    let beyond = |(from, to): (DVec3, DVec3)| (to - from).cross(point - from).dot(normal) < 0.0;
    if 0.0 < normal.length_squared() && !sides.into_iter().any(beyond) {
        return (point - a).dot(normal).abs() / normal.length();
    }
    sides
        .into_iter()
        .map(|(from, to)| distance_to_segment(point, from, to))
        .fold(f64::INFINITY, f64::min)
}
