//! The edges of surfaces as polygons that surfaces side by side share.
//!
//! An edge is divided by its arc length, so that its polygon does not depend on how a surface runs
//! along it: it is halved, or cut into equal parts where that takes fewer, until it is near enough to its chord and until the
//! surfaces on it can follow with triangles. Edges that are one curve, in either
//! direction, are divided together, and their vertices are the same numbers.

use glam::{DVec3, DVec4};

use super::{
    limits::MeshLimits,
    sheet::{Cells, SHARE, Sheet},
    tessellate::chord_deviation,
    weld::welded,
};
use crate::kernel::{
    Bounds, GeomError, Interval, NurbsCurve, bezier,
    curve::ArcLengths,
    tolerance::{BORDER_SHARE, PLACE_RELATIVE, WELD_SHARE},
};

/// Halvings of an edge, past the last bit of a parameter.
const MAX_HALVINGS: usize = 52;

/// Parts of an edge between which it is compared with another.
const COMPARED: usize = 8;

/// An edge of a sheet: u0, u1, v0 or v1 by its number.
#[derive(Debug)]
struct Edge {
    sheet: usize,
    number: usize,
    curve: NurbsCurve,
    lengths: ArcLengths,
    /// What its ends are welded to.
    corners: [u32; 2],
    /// Whether it is one point.
    is_point: bool,
}

/// Edges that are one curve; the first gives the points.
#[derive(Debug)]
struct Seam {
    /// Indices of edges, and whether they run against the first.
    edges: Vec<(usize, bool)>,
    /// How far apart they are.
    gap: f64,
}

/// Vertices on an edge: parameters along it, growing, and places.
pub(super) type Vertices = Vec<(f64, DVec3)>;

/// All edges of some sheets.
#[derive(Debug)]
pub(super) struct Seams {
    edges: Vec<Edge>,
    seams: Vec<Seam>,
    /// Where the corners are that others are welded to.
    corners: Vec<DVec3>,
}

impl Seams {
    /// Finds what the sheets share, and takes what that costs from their tolerances.
    ///
    /// # Errors
    /// Those of [`Sheet::point_at`].
    pub(super) fn of(sheets: &mut [Sheet<'_>], wanted: &MeshLimits) -> Result<Self, GeomError> {
        let weld = wanted.weld.min(WELD_SHARE * wanted.tolerance);
        let mut corners = Vec::with_capacity(4 * sheets.len());
        for sheet in &*sheets {
            let [u, v] = sheet.domains();
            for u in [u.start(), u.end()] {
                for v in [v.start(), v.end()] {
                    corners.push(sheet.point_at(u, v)?);
                }
            }
        }
        let names = welded(&corners, weld);
        let mut edges = Vec::with_capacity(4 * sheets.len());
        for (i, sheet) in sheets.iter().enumerate() {
            // The corners are u0v0, u0v1, u1v0, u1v1.
            let ends = [[0, 1], [2, 3], [0, 2], [1, 3]];
            for (number, curve) in sheet.spline.edges().into_iter().enumerate() {
                let size = Bounds::of(curve.points()).map_or(0.0, Bounds::diagonal);
                let corners = ends[number].map(|corner| names[4 * i + corner]);
                let lengths = curve.arc_lengths();
                let is_point = size <= weld;
                edges.push(Edge { sheet: i, number, curve, lengths, corners, is_point });
            }
        }
        let mut seams = Self { edges, seams: Vec::new(), corners };
        seams.match_edges(sheets, weld, wanted.tolerance)?;
        for seam in &seams.seams {
            for &(edge, _) in &seam.edges {
                sheets[seams.edges[edge].sheet].reserve(seam.gap);
            }
        }
        Ok(seams)
    }

    fn match_edges(
        &mut self,
        sheets: &[Sheet<'_>],
        weld: f64,
        tolerance: f64,
    ) -> Result<(), GeomError> {
        let mut order: Vec<usize> = (0..self.edges.len()).collect();
        let ends = |edge: &Edge| {
            let [a, b] = edge.corners;
            [a.min(b), a.max(b)]
        };
        order.retain(|&edge| !self.edges[edge].is_point);
        order.sort_by_key(|&edge| (ends(&self.edges[edge]), edge));
        let mut seams = Vec::new();
        for alike in order.chunk_by(|&a, &b| ends(&self.edges[a]) == ends(&self.edges[b])) {
            let mut here: Vec<(Vec<DVec3>, Seam)> = Vec::new();
            for &edge in alike {
                let places = self.compared(edge, sheets)?;
                let slack = |other: &Seam| {
                    let of = [edge, other.edges[0].0];
                    let moved = of.iter().any(|&edge| sheets[self.edges[edge].sheet].is_function());
                    if moved { SHARE * tolerance } else { 0.0 }
                };
                let found = here.iter().enumerate().find_map(|(i, (others, seam))| {
                    let (along, against) =
                        (apart(&places, others, false), apart(&places, others, true));
                    let (gap, turns) =
                        if against < along { (against, true) } else { (along, false) };
                    (gap <= weld + slack(seam)).then(|| (i, gap + slack(seam), turns))
                });
                match found {
                    Some((i, gap, turns)) => {
                        here[i].1.edges.push((edge, turns));
                        here[i].1.gap = here[i].1.gap.max(gap);
                    }
                    None => here.push((places, Seam { edges: vec![(edge, false)], gap: 0.0 })),
                }
            }
            seams.extend(here.into_iter().map(|(_, seam)| seam));
        }
        self.seams = seams;
        Ok(())
    }

    /// Places of an edge between equal parts of its length.
    fn compared(&self, edge: usize, sheets: &[Sheet<'_>]) -> Result<Vec<DVec3>, GeomError> {
        let edge = &self.edges[edge];
        let at = |i: usize| edge.point(&sheets[edge.sheet], i as f64 / COMPARED as f64);
        (1..COMPARED).map(at).collect()
    }

    /// The vertices on the four edges of each sheet, those of a point only at its ends.
    ///
    /// # Errors
    /// Those of [`Sheet::point_at`]; [`GeomError::TooManyVertices`].
    pub(super) fn vertices(
        &self,
        sheets: &[Sheet<'_>],
        cells: &[Cells],
        most: usize,
    ) -> Result<Vec<[Vertices; 4]>, GeomError> {
        let mut all: Vec<[Vertices; 4]> = sheets.iter().map(|_| Default::default()).collect();
        for edge in self.edges.iter().filter(|edge| edge.is_point) {
            let point = self.corners[edge.corners[0] as usize];
            all[edge.sheet][edge.number] =
                [edge.domain().start(), edge.domain().end()].map(|t| (t, point)).to_vec();
        }
        for seam in &self.seams {
            let stops = Division::new(self, seam, sheets, cells).stops(most)?;
            let first = &self.edges[seam.edges[0].0];
            let mut points = Vec::with_capacity(stops.len());
            for stop in &stops {
                points.push(first.point(&sheets[first.sheet], stop.fraction)?);
            }
            for (place, corner) in [(0, 0), (points.len() - 1, 1)] {
                points[place] = self.corners[first.corners[corner] as usize];
            }
            for (i, &(edge, turns)) in seam.edges.iter().enumerate() {
                let edge = &self.edges[edge];
                let places = stops.iter().zip(&points);
                let mut vertices: Vertices =
                    places.map(|(stop, &point)| (stop.parameters[i], point)).collect();
                if turns {
                    vertices.reverse();
                }
                all[edge.sheet][edge.number] = vertices;
            }
        }
        Ok(all)
    }
}

impl Edge {
    fn domain(&self) -> Interval {
        self.curve.domain()
    }

    /// The parameter at a fraction of the length, of that from the end where it `turns`.
    fn parameter(&self, fraction: f64, turns: bool) -> f64 {
        let fraction = if turns { 1.0 - fraction } else { fraction };
        if fraction <= 0.0 {
            self.domain().start()
        } else if 1.0 <= fraction {
            self.domain().end()
        } else {
            self.curve.at_fraction(&self.lengths, fraction)
        }
    }

    fn point(&self, sheet: &Sheet<'_>, fraction: f64) -> Result<DVec3, GeomError> {
        let t = self.parameter(fraction, false);
        let [u, v] = sheet.domains();
        match self.number {
            0 => sheet.point_at(u.start(), t),
            1 => sheet.point_at(u.end(), t),
            2 => sheet.point_at(t, v.start()),
            _ => sheet.point_at(t, v.end()),
        }
    }
}

/// How far apart places are, in order or against it.
fn apart(a: &[DVec3], b: &[DVec3], turns: bool) -> f64 {
    let n = a.len();
    let other = |i: usize| if turns { b[n - 1 - i] } else { b[i] };
    (0..n).map(|i| a[i].distance(other(i))).fold(0.0, f64::max)
}

/// A seam while it is divided.
struct Division<'a, 's> {
    seams: &'a Seams,
    seam: &'a Seam,
    sheets: &'a [Sheet<'s>],
    cells: &'a [Cells],
    /// How far its polygon may be away.
    tolerance: f64,
    /// The Bézier pieces of its first edge.
    pieces: Vec<(Interval, Vec<DVec4>)>,
}

/// A place on a seam.
#[derive(Clone, Debug)]
struct Stop {
    fraction: f64,
    /// The parameters there of its edges.
    parameters: Vec<f64>,
}

impl<'a, 's> Division<'a, 's> {
    fn new(seams: &'a Seams, seam: &'a Seam, sheets: &'a [Sheet<'s>], cells: &'a [Cells]) -> Self {
        let of = |&(edge, _): &(usize, bool)| sheets[seams.edges[edge].sheet].tolerance();
        let tolerance = BORDER_SHARE * seam.edges.iter().map(of).fold(f64::INFINITY, f64::min);
        let first = &seams.edges[seam.edges[0].0];
        let knots = first.curve.knots();
        let piece = |span| bezier::piece(knots, first.curve.control_points(), span);
        let pieces = knots.spans().map(|span| (knots.span_interval(span), piece(span))).collect();
        Self { seams, seam, sheets, cells, tolerance, pieces }
    }

    fn stop(&self, fraction: f64) -> Stop {
        let parameter =
            |&(edge, turns): &(usize, bool)| self.seams.edges[edge].parameter(fraction, turns);
        Stop { fraction, parameters: self.seam.edges.iter().map(parameter).collect() }
    }

    /// Where there are vertices.
    fn stops(&self, most: usize) -> Result<Vec<Stop>, GeomError> {
        let mut stops = vec![self.stop(0.0)];
        for section in self.forced().windows(2) {
            let (start, end) = (stops[stops.len() - 1].clone(), self.stop(section[1]));
            let halved = self.halved(start.clone(), end, most)?;
            let section = [section[0], section[1]];
            match self.fewer_equal(&start, section, halved.len()) {
                Some(equal) => stops.extend(equal),
                None => stops.extend(halved),
            }
            if most < stops.len() {
                return Err(GeomError::TooManyVertices { got: stops.len(), most });
            }
        }
        Ok(stops)
    }

    /// The stops behind the start up to the end, by halving.
    fn halved(&self, start: Stop, end: Stop, most: usize) -> Result<Vec<Stop>, GeomError> {
        let mut stops = Vec::new();
        let (mut low, mut todo) = (start, vec![(end, 0)]);
        while let Some((high, n_halvings)) = todo.pop() {
            if MAX_HALVINGS <= n_halvings || self.fits(&low, &high) {
                stops.push(high.clone());
                low = high;
            } else {
                let middle = self.stop(0.5 * (low.fraction + high.fraction));
                todo.extend([(high, n_halvings + 1), (middle, n_halvings + 1)]);
            }
            let got = stops.len() + todo.len();
            if most < got {
                return Err(GeomError::TooManyVertices { got, most });
            }
        }
        Ok(stops)
    }

    /// The stops at equal parts, if they are fewer than by halving.
    fn fewer_equal(&self, start: &Stop, section: [f64; 2], n_halved: usize) -> Option<Vec<Stop>> {
        let try_parts = |n: usize| {
            let mut stops: Vec<Stop> = Vec::with_capacity(n);
            for i in 1..=n {
                let stop = self.stop(equal(section, i, n));
                if !self.fits(stops.last().unwrap_or(start), &stop) {
                    return None;
                }
                stops.push(stop);
            }
            Some(stops)
        };
        // Fewer than half are not tried: where that is enough, halving finds about as few.
        let (mut few, mut many, mut best) = (n_halved / 2, n_halved, None);
        while few + 1 < many {
            let middle = usize::midpoint(few, many);
            match try_parts(middle) {
                Some(stops) => (many, best) = (middle, Some(stops)),
                None => few = middle,
            }
        }
        best
    }

    /// The ends, and where a surface on it has a break.
    fn forced(&self) -> Vec<f64> {
        let mut forced = vec![0.0, 1.0];
        for &(edge, turns) in &self.seam.edges {
            let edge = &self.seams.edges[edge];
            // Lines of constant u end on edges along u.
            let along = usize::from(edge.number < 2);
            for line in &self.sheets[edge.sheet].breaks[along] {
                let fraction = edge.curve.fraction_at(&edge.lengths, line.at);
                forced.push(if turns { 1.0 - fraction } else { fraction });
            }
        }
        forced.sort_by(f64::total_cmp);
        forced.dedup_by(|a, b| *a - *b <= PLACE_RELATIVE);
        if let Some(last) = forced.last_mut() {
            *last = 1.0;
        }
        forced
    }

    /// Whether one leg may run between two stops.
    fn fits(&self, low: &Stop, high: &Stop) -> bool {
        if self.tolerance < deviation(&self.pieces, [low.parameters[0], high.parameters[0]]) {
            return false;
        }
        let ends = low.parameters.iter().zip(&high.parameters);
        self.seam.edges.iter().zip(ends).all(|(&(edge, _), (&a, &b))| {
            let edge = &self.seams.edges[edge];
            let (ends, cells) = ([a.min(b), a.max(b)], &self.cells[edge.sheet]);
            let is_last = edge.number % 2 == 1;
            cells.allow(match edge.number {
                0 | 1 => [cells.rim(0, is_last), ends],
                _ => [ends, cells.rim(1, is_last)],
            })
        })
    }
}

fn equal([low, high]: [f64; 2], i: usize, n: usize) -> f64 {
    if i == n { high } else { low + (high - low) * (i as f64 / n as f64) }
}

/// A bound of how far a curve is from its chord between two parameters.
fn deviation(pieces: &[(Interval, Vec<DVec4>)], [start, end]: [f64; 2]) -> f64 {
    let mut parts: Vec<Vec<DVec4>> = Vec::new();
    for (interval, points) in pieces {
        if interval.end() <= start || end <= interval.start() {
            continue;
        }
        let mut part = points.clone();
        let fraction = interval.fraction_of(end);
        if fraction < 1.0 {
            part = bezier::cut_at(&part, fraction).0;
        }
        let whole = interval.fraction_of(end.min(interval.end()));
        let fraction = interval.fraction_of(start) / whole;
        if 0.0 < fraction {
            part = bezier::cut_at(&part, fraction).1;
        }
        parts.push(part);
    }
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return 0.0 };
    let chord = [first[0], last[last.len() - 1]];
    parts.iter().map(|part| chord_deviation(part, chord)).fold(0.0, f64::max)
}
