//! Meshes of parts of a surface, within the tolerance by bounds.
//!
//! The lines of the whole surface's grid make its parameters a plane of even cells. There the border's
//! arcs become polygons whose legs keep to the limits of cells; between them and the corners of the grid
//! that are not too near runs a constrained Delaunay triangulation, and a triangle that breaks a limit
//! gets a vertex in its middle. A triangle within a box that the limits allow is near the surface at
//! equal parameters (`cell_bounds`), and the parameters beside a leg are near those on it.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::{
    Mesh, TessellationOptions,
    bend::DerivativeBounds,
    chord::chord_deviation,
    surface_patch::{Cells, SurfacePatch},
    tessellate::{ANGLE_MARGIN, LEAST_GAIN, MAX_GROWTH, MAX_ROUNDS, check_rounding, widest_turn},
    triangulation::{BorderPolygon, triangles_with},
};
use crate::{
    CountError, Direction, GeomError, NurbsCurve, NurbsSurface, Side, bezier,
    ceiling::PARAMETER_HALVINGS,
    tolerance::{LEG_SHARE, PARAMETER_RELATIVE, VANISHING_RELATIVE},
};

/// How many cells a corner of the grid keeps away from the border at least.
const CLEARANCE: f64 = 0.4;

/// By how much more than a leg's box must be allowed, for the triangles on it.
const LEG_ROOM: f64 = 1.3;

/// Rounds of vertices in the middle of triangles; each leaves a third of the way to a leg.
const MIDDLE_ROUNDS: usize = 24;

/// Loops of one part, the outer one first; each by its arcs in the plane z = 0 of u and v.
pub(crate) type PartLoops = Vec<Vec<NurbsCurve>>;

/// Where an arc runs along a line that parts share: which parameter is constant, and the line's number.
type SharedLine = (usize, u64);

/// What is meshed.
struct Trimmed<'a> {
    sheet: SurfacePatch<'a>,
    parts: &'a [PartLoops],
    is_closed: [bool; 2],
    /// Bounds of the lengths of Su and of Sv.
    first: [f64; 2],
}

/// The mesh of parts of a surface, none of which goes over a line along which its derivative jumps;
/// `is_closed` tells which pairs of its edges are one.
///
/// # Errors
/// [`crate::InputError::NotPositive`] for a limit that allows nothing; [`CountError::TooManyVertices`];
/// [`crate::MeshError::BelowRounding`]; [`crate::RegionError::Unclear`] where arcs come too near one another.
pub(crate) fn tessellate_parts(
    surface: &NurbsSurface,
    parts: &[PartLoops],
    is_closed: [bool; 2],
    options: &TessellationOptions,
    most: usize,
) -> Result<Mesh, GeomError> {
    options.check()?;
    check_rounding(options.tolerance, surface.bounds().magnitude())?;
    // What legs leave out, and what triangles do.
    let triangles = (1.0 - LEG_SHARE) * options.tolerance;
    let bounds = DerivativeBounds::of(surface, [1, 1], options.n_threads);
    let longest = |i: usize| bounds.pieces.iter().map(|piece| piece.first[i]).fold(0.0, f64::max);
    let sheet = SurfacePatch::of_spline(surface, triangles);
    let trimmed = Trimmed { sheet, parts, is_closed, first: [longest(0), longest(1)] };
    let limits = trimmed.sheet.limits(options);
    let (mut sharpness, mut last) = (1.0, f64::INFINITY);
    for round in 1.. {
        GeomError::go_on(1)?;
        let cells = trimmed.sheet.cells(limits.sharpened(sharpness), most)?;
        let mesh = trimmed.mesh(&cells, LEG_SHARE * options.tolerance, most)?;
        let excess = widest_turn(&mesh, options.tolerance) / options.angle;
        let is_done = !options.limits_angle() || excess <= 1.0 || LEAST_GAIN * last <= excess;
        if is_done || MAX_ROUNDS <= round {
            return Ok(mesh);
        }
        sharpness *= (ANGLE_MARGIN * excess).min(MAX_GROWTH);
        last = excess;
    }
    unreachable!("rounds end")
}

impl Trimmed<'_> {
    fn mesh(&self, cells: &Cells, leg_tolerance: f64, most: usize) -> Result<Mesh, GeomError> {
        let arcs = || self.parts.iter().flatten().flatten();
        let mut shared: BTreeMap<SharedLine, Vec<f64>> = BTreeMap::new();
        let mut stops = Vec::new();
        for arc in arcs() {
            let places = self.stops(arc, cells, leg_tolerance, most)?;
            if let Some(line) = self.shared_line(arc) {
                let along = 1 - line.0;
                shared.entry(line).or_default().extend(places.iter().map(|&t| at(arc, t)[along]));
            }
            stops.push(places);
        }
        // Arcs that meet there from both sides end within rounding of one another.
        let slack = self.sheet.domains().map(|domain| PARAMETER_RELATIVE * domain.length());
        for (line, places) in &mut shared {
            places.sort_by(f64::total_cmp);
            places.dedup_by(|a, b| *a - *b <= slack[1 - line.0]);
        }
        let mut polygons = arcs().zip(&stops).map(|(arc, stops)| match self.shared_line(arc) {
            Some(line) => between(arc, 1 - line.0, &shared[&line], slack[1 - line.0]),
            None => stops[..stops.len() - 1].iter().map(|&t| at(arc, t)).collect(),
        });
        let mut mesh = Mesh::default();
        for part in self.parts {
            let loops: Vec<Vec<DVec2>> = part
                .iter()
                .map(|arcs| polygons.by_ref().take(arcs.len()).flatten().collect())
                .collect();
            self.add(&loops, cells, most, &mut mesh)?;
        }
        Ok(mesh.without_strays())
    }

    /// The line of constant parameter along which an arc runs that both of its sides share.
    fn shared_line(&self, arc: &NurbsCurve) -> Option<SharedLine> {
        let points = arc.points();
        let is = |a: f64, b: f64| (a - b).abs() <= 0.0;
        (0..2).find_map(|across| {
            let value = points[0][across];
            let domain = self.sheet.domains()[across];
            let is_end = is(value, domain.start()) || is(value, domain.end());
            let is_seam = self.is_closed[across] && is_end;
            let is_crease = self.sheet.breaks[across].iter().any(|line| is(line.at, value));
            let is_line = points.iter().all(|point| is(point[across], value));
            let key = if is_seam { domain.start() } else { value };
            (is_line && (is_seam || is_crease)).then_some((across, key.to_bits()))
        })
    }

    /// Parameters of an arc between which legs may run, its ends among them.
    fn stops(
        &self,
        arc: &NurbsCurve,
        cells: &Cells,
        tolerance: f64,
        most: usize,
    ) -> Result<Vec<f64>, GeomError> {
        let stretch = DVec3::new(self.first[0], self.first[1], 0.0);
        let stretched = arc.transformed(&glam::DAffine3::from_scale(stretch));
        let mut stops = vec![arc.domain().start()];
        for span in arc.knots().spans() {
            let piece = bezier::piece(arc.knots(), stretched.control_points(), span);
            let mut todo = vec![(piece, arc.knots().span_interval(span), 0)];
            while let Some((piece, interval, n_halvings)) = todo.pop() {
                GeomError::go_on(1)?;
                let ends = [interval.start(), interval.end()].map(|t| at(arc, t));
                let is_near = chord_deviation(&piece, [piece[0], piece[piece.len() - 1]]);
                let fits = is_near <= tolerance && leg_fits(cells, ends);
                if fits || PARAMETER_HALVINGS <= n_halvings {
                    stops.push(interval.end());
                } else {
                    let (left, right) = bezier::cut_at(&piece, 0.5);
                    let [before, behind] = interval.halves();
                    todo.extend([(right, behind, n_halvings + 1), (left, before, n_halvings + 1)]);
                }
                let got = stops.len() + todo.len();
                if most < got {
                    return Err(CountError::TooManyVertices { got, most }.into());
                }
            }
        }
        Ok(stops)
    }

    /// Adds the triangles of one part, whose loops are polygons.
    fn add(
        &self,
        loops: &[Vec<DVec2>],
        cells: &Cells,
        most: usize,
        mesh: &mut Mesh,
    ) -> Result<(), GeomError> {
        let net = EvenPlane { lines: &cells.lines };
        let mut rings: Vec<BorderPolygon> = Vec::new();
        let mut first = 0;
        for polygon in loops {
            let places: Vec<DVec2> = polygon.iter().map(|&place| net.place(place)).collect();
            let n = places.len();
            rings.push(BorderPolygon { places, first });
            first += n;
        }
        let got = mesh.n_vertices() + first;
        let inside = net.corners_inside(&rings, most.saturating_sub(got))?;
        let is_fine = |corners: [DVec2; 3]| {
            let [a, b, c] = corners.map(|corner| net.parameters(corner));
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            cells.allow([[low.x, high.x], [low.y, high.y]])
        };
        let limits = [MIDDLE_ROUNDS, most.saturating_sub(got)];
        let (triangles, inside) =
            triangles_with(&rings, inside, is_fine, limits).map_err(|vertex| {
                let place = loops.iter().flatten().nth(vertex).copied().unwrap_or_default();
                crate::RegionError::Unclear { point: self.point(place) }
            })?;
        let own = loops.iter().flatten().copied();
        let own: Vec<DVec2> =
            own.chain(inside.iter().map(|&place| net.parameters(place))).collect();
        let got = mesh.n_vertices() + own.len();
        if most.min(u32::MAX as usize) < got {
            return Err(CountError::TooManyVertices { got, most }.into());
        }
        let (low, high) =
            (own.iter().copied().reduce(DVec2::min), own.iter().copied().reduce(DVec2::max));
        let middle = low.zip(high).map_or(DVec2::ZERO, |(low, high)| low.midpoint(high));
        let offset = mesh.n_vertices() as u32;
        for &place in &own {
            mesh.vertices.push(self.point(place));
            mesh.normals.push(self.normal(place, middle));
            mesh.uvs.push(place);
        }
        let rounding = VANISHING_RELATIVE * self.sheet.spline.bounds().magnitude();
        for corners in triangles {
            let corners = corners.map(|corner| corner + offset);
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
            if [(a, b), (b, c), (c, a)].iter().all(|(a, b)| rounding < a.distance(*b)) {
                mesh.triangles.push(corners);
            }
        }
        Ok(())
    }

    /// The point at parameters; of a seam the same at both of its ends.
    fn point(&self, place: DVec2) -> DVec3 {
        let domains = self.sheet.domains();
        let [u, v] = [0, 1].map(|i| {
            let (domain, t) = (domains[i], place[i]);
            if self.is_closed[i] && domain.end() <= t { domain.start() } else { t }
        });
        self.sheet.spline.point_at(u, v)
    }

    /// The normal at parameters, on the side where the part is.
    fn normal(&self, place: DVec2, middle: DVec2) -> DVec3 {
        let sides = [0, 1].map(|i| if place[i] <= middle[i] { Side::Right } else { Side::Left });
        self.sheet.spline.sample_beside(place.to_array(), sides).1
    }
}

/// The parameters of the surface at one of an arc.
fn at(arc: &NurbsCurve, t: f64) -> DVec2 {
    arc.point_at(t).truncate()
}

/// The places on a line along which an arc runs, from its start up to before its end.
fn between(arc: &NurbsCurve, along: usize, places: &[f64], slack: f64) -> Vec<DVec2> {
    let (start, end) = (arc.start().truncate(), arc.end().truncate());
    let (from, to) = (start[along], end[along]);
    let (low, high) = (from.min(to) + slack, from.max(to) - slack);
    let inner = places.iter().copied().filter(|&t| low < t && t < high);
    let mut inner: Vec<f64> = inner.collect();
    if to < from {
        inner.reverse();
    }
    let place = |t: f64| if along == 0 { DVec2::new(t, start.y) } else { DVec2::new(start.x, t) };
    std::iter::once(start).chain(inner.into_iter().map(place)).collect()
}

/// Whether limits allow a leg, and triangles on it.
fn leg_fits(cells: &Cells, [a, b]: [DVec2; 2]) -> bool {
    let (low, high) = (a.min(b), a.max(b));
    let wider = |low: f64, high: f64| {
        let room = 0.5 * (LEG_ROOM - 1.0) * (high - low);
        [low - room, high + room]
    };
    cells.allow([wider(low.x, high.x), wider(low.y, high.y)])
}

/// Parameters with the lines of a grid one unit apart.
struct EvenPlane<'a> {
    lines: &'a [Vec<f64>; 2],
}

impl EvenPlane<'_> {
    fn place(&self, parameters: DVec2) -> DVec2 {
        let along = |along: Direction, t: f64| {
            let lines = &self.lines[along];
            let cell = lines.partition_point(|&line| line <= t).clamp(1, lines.len() - 1) - 1;
            cell as f64 + (t - lines[cell]) / (lines[cell + 1] - lines[cell])
        };
        DVec2::new(along(Direction::U, parameters.x), along(Direction::V, parameters.y))
    }

    fn parameters(&self, place: DVec2) -> DVec2 {
        let along = |along: Direction, x: f64| {
            let lines = &self.lines[along];
            let cell = (x.max(0.0) as usize).min(lines.len() - 2);
            let fraction = x - cell as f64;
            // A line itself is met exactly.
            if fraction <= 0.0 {
                lines[cell]
            } else if 1.0 <= fraction {
                lines[cell + 1]
            } else {
                lines[cell] + fraction * (lines[cell + 1] - lines[cell])
            }
        };
        DVec2::new(along(Direction::U, place.x), along(Direction::V, place.y))
    }

    /// The crossings of lines within polygons and not near their sides.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`]; `GeomError::Ended`.
    fn corners_inside(
        &self,
        rings: &[BorderPolygon],
        most: usize,
    ) -> Result<Vec<DVec2>, GeomError> {
        let sides: Vec<[DVec2; 2]> = rings
            .iter()
            .flat_map(|ring| {
                let n = ring.places.len();
                (0..n).map(move |i| [ring.places[i], ring.places[(i + 1) % n]])
            })
            .collect();
        let [n_u, n_v] = [self.lines[0].len(), self.lines[1].len()];
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); n_u];
        let mut near: Vec<Vec<usize>> = vec![Vec::new(); n_u];
        let range = |low: f64, high: f64, n: usize| {
            (low.max(0.0).ceil() as usize)..((high.max(-1.0) + 1.0).floor() as usize).min(n)
        };
        for &[a, b] in &sides {
            GeomError::go_on(1)?;
            let (low, high) = (a.min(b), a.max(b));
            for i in range(low.x, high.x, n_u) {
                let x = i as f64;
                if (a.x <= x) != (b.x <= x) {
                    crossings[i].push(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)));
                }
            }
            for i in range(low.x - CLEARANCE, high.x + CLEARANCE, n_u) {
                for j in range(low.y - CLEARANCE, high.y + CLEARANCE, n_v) {
                    if distance(DVec2::new(i as f64, j as f64), [a, b]) < CLEARANCE {
                        near[i].push(j);
                    }
                }
            }
        }
        let mut inside = Vec::new();
        for (i, (mut crossings, mut near)) in crossings.into_iter().zip(near).enumerate() {
            GeomError::go_on(1)?;
            crossings.sort_by(f64::total_cmp);
            near.sort_unstable();
            let mut near = near.into_iter().peekable();
            for pair in crossings.chunks_exact(2) {
                for j in range(pair[0], pair[1], n_v) {
                    while near.next_if(|&at| at < j).is_some() {}
                    if near.peek() != Some(&j) {
                        inside.push(DVec2::new(i as f64, j as f64));
                    }
                }
            }
            if most < inside.len() {
                return Err(CountError::TooManyVertices { got: inside.len(), most }.into());
            }
        }
        Ok(inside)
    }
}

/// How far a place is from a side.
fn distance(place: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let leg = b - a;
    let along = (place - a).dot(leg) / leg.length_squared();
    let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
    place.distance(a + leg * along)
}
