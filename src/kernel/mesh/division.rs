//! The division of a seam into legs.
//!
//! It is halved, or cut into equal parts where that takes fewer, until it is near enough to its chord
//! and until the surfaces on it can follow with triangles.

use std::{
    cell::RefCell,
    collections::HashMap,
    sync::{Mutex, PoisonError},
};

use glam::DVec3;
use smallvec::SmallVec;

use super::{
    chord::{PiecePoints, chord_deviation, cut_before},
    edge::PatchEdge,
    seam::{EdgeStretch, SharedEdge, SharedEdges, Vertices},
    surface_patch::{Cells, SurfacePatch},
};
use crate::{
    CountError, Direction, GeomError, Interval, bezier,
    ceiling::PARAMETER_HALVINGS,
    side_by_side,
    tolerance::{BORDER_SHARE, PLACE_RELATIVE},
    work,
};

/// The parameters on a seam's stretches at the fractions that were looked at, by the bits of these:
/// each is found by Newton's method on an arc length, and asked again when the seam is divided anew.
type KnownParameters = HashMap<u64, StretchParameters>;

/// A parameter for each stretch of a seam, of which there are mostly one or two.
type StretchParameters = SmallVec<[f64; 2]>;

/// Those of all seams.
pub(super) type KnownPlaces = Vec<Mutex<KnownParameters>>;

impl SharedEdges {
    /// Room for the places of all seams.
    pub(super) fn places(&self) -> KnownPlaces {
        self.seams.iter().map(|_| Mutex::default()).collect()
    }

    /// The vertices on the four edges of each sheet, by up to `n_threads` threads.
    ///
    /// # Errors
    /// Those of [`SurfacePatch::point_at`]; `CountError::TooManyVertices`.
    pub(super) fn vertices(
        &self,
        sheets: &[SurfacePatch<'_>],
        cells: &[Cells],
        known: &KnownPlaces,
        most: usize,
        n_threads: usize,
    ) -> Result<Vec<[Vertices; 4]>, GeomError> {
        let mut found: Vec<Vertices> = vec![Vertices::new(); self.stretches.len()];
        let all: Vec<usize> = (0..self.seams.len()).collect();
        self.divide(&all, (sheets, cells, known), [most, n_threads], &mut found)?;
        Ok(self.around(sheets.len(), found))
    }

    /// Finds the vertices on the stretches of some seams.
    ///
    /// # Errors
    /// Those of [`Self::vertices`].
    pub(super) fn divide(
        &self,
        seams: &[usize],
        (sheets, cells, known): (&[SurfacePatch<'_>], &[Cells], &KnownPlaces),
        [most, n_threads]: [usize; 2],
        found: &mut [Vertices],
    ) -> Result<(), GeomError> {
        let divided = side_by_side::map(seams, n_threads, |&i| {
            let mut known = known[i].lock().unwrap_or_else(PoisonError::into_inner);
            let seam = &self.seams[i];
            self.divided(seam, SeamDivision::new(self, seam, sheets, cells, &mut known), most)
        });
        for (&seam, divided) in seams.iter().zip(divided) {
            let (stops, points) = divided?;
            for (i, &(stretch, turns)) in self.seams[seam].stretches.iter().enumerate() {
                let places = stops.iter().zip(&points);
                let vertices = places.map(|(stop, &point)| (stop.parameters[i], point));
                found[stretch] = if turns { vertices.rev().collect() } else { vertices.collect() };
            }
        }
        Ok(())
    }

    /// The vertices on the four edges of each sheet, of those on each stretch; those of an edge that is a point only at
    /// its ends.
    pub(super) fn around(&self, n_sheets: usize, found: Vec<Vertices>) -> Vec<[Vertices; 4]> {
        let mut all: Vec<[Vertices; 4]> = (0..n_sheets).map(|_| Default::default()).collect();
        for edge in self.edges.iter().filter(|edge| edge.is_point) {
            let point = self.corners[edge.corners[0] as usize];
            let ends = [edge.domain().start(), edge.domain().end()];
            all[edge.sheet][edge.number] = ends.map(|t| (t, point)).to_vec();
        }
        for (stretch, vertices) in self.stretches.iter().zip(found) {
            let edge = &self.edges[stretch.edge];
            let whole = &mut all[edge.sheet][edge.number];
            // The end of the stretch before is the start of this one.
            whole.pop();
            whole.extend(vertices);
        }
        all
    }

    /// The sheets that share a seam.
    pub(super) fn sheets_of(&self, seam: usize) -> impl Iterator<Item = usize> + '_ {
        let stretches = self.seams[seam].stretches.iter();
        stretches.map(|&(stretch, _)| self.edges[self.stretches[stretch].edge].sheet)
    }

    /// The places where a seam is divided, and their points.
    fn divided(
        &self,
        seam: &SharedEdge,
        division: SeamDivision<'_, '_>,
        most: usize,
    ) -> Result<(Vec<SeamPlace>, Vec<DVec3>), GeomError> {
        let stops = division.stops(most)?;
        let first = &self.stretches[seam.stretches[0].0];
        let edge = &self.edges[first.edge];
        let sheet = &division.sheets[edge.sheet];
        let points = stops.iter().map(|stop| edge.point(sheet, stop.parameters[0]));
        let mut points = points.collect::<Result<Vec<_>, GeomError>>()?;
        for (place, end) in [(0, 0), (points.len() - 1, 1)] {
            points[place] = self.corners[first.ends[end].corner as usize];
        }
        Ok((stops, points))
    }
}

/// A seam while it is divided.
pub(super) struct SeamDivision<'a, 's> {
    seams: &'a SharedEdges,
    seam: &'a SharedEdge,
    sheets: &'a [SurfacePatch<'s>],
    cells: &'a [Cells],
    /// How far its polygon may be away.
    tolerance: f64,
    /// The Bézier pieces of its first stretch.
    pieces: Vec<(Interval, PiecePoints)>,
    known: RefCell<&'a mut KnownParameters>,
}

/// A place on a seam.
#[derive(Clone, Debug)]
pub(super) struct SeamPlace {
    fraction: f64,
    /// The parameters there of its stretches.
    pub(super) parameters: StretchParameters,
}

impl<'a, 's> SeamDivision<'a, 's> {
    pub(super) fn new(
        seams: &'a SharedEdges,
        seam: &'a SharedEdge,
        sheets: &'a [SurfacePatch<'s>],
        cells: &'a [Cells],
        known: &'a mut KnownParameters,
    ) -> Self {
        let edge = |stretch: usize| &seams.edges[seams.stretches[stretch].edge];
        let tolerances =
            seam.stretches.iter().map(|&(stretch, _)| sheets[edge(stretch).sheet].tolerance());
        let tolerance = BORDER_SHARE * tolerances.fold(f64::INFINITY, f64::min);
        let first = &seams.stretches[seam.stretches[0].0];
        let curve = &seams.edges[first.edge].curve;
        let knots = curve.knots();
        let spans = knots.spans().map(|span| (knots.span_interval(span), span));
        let pieces = spans
            .filter(|(interval, _)| first.touches(*interval))
            .map(|(interval, span)| {
                let points = bezier::piece(knots, curve.control_points(), span);
                (interval, points.into())
            })
            .collect();
        Self { seams, seam, sheets, cells, tolerance, pieces, known: RefCell::new(known) }
    }

    /// What it consists of: stretches, their edges, and whether they run against the first.
    fn stretches(&self) -> impl Iterator<Item = (&'a EdgeStretch, &'a PatchEdge, bool)> + use<'a> {
        let seams = self.seams;
        self.seam.stretches.iter().map(move |&(stretch, turns)| {
            let stretch = &seams.stretches[stretch];
            (stretch, &seams.edges[stretch.edge], turns)
        })
    }

    fn stop(&self, fraction: f64) -> SeamPlace {
        let mut known = self.known.borrow_mut();
        let parameters = known.entry(fraction.to_bits());
        let parameters = parameters.or_insert_with(|| self.parameters(fraction));
        SeamPlace { fraction, parameters: parameters.clone() }
    }

    /// The parameters of the stretches at a fraction, each found once of stretches that are the same.
    fn parameters(&self, fraction: f64) -> StretchParameters {
        let mut parameters = StretchParameters::new();
        for (i, (stretch, edge, turns)) in self.stretches().enumerate() {
            let same = self.seam.repeats[i];
            parameters.push(match same < i {
                true => parameters[same],
                false => stretch.parameter(edge, fraction, turns),
            });
        }
        parameters
    }

    /// Where there are vertices.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`].
    pub(super) fn stops(&self, most: usize) -> Result<Vec<SeamPlace>, GeomError> {
        let mut stops = vec![self.stop(0.0)];
        for section in self.forced().windows(2) {
            let (start, end) = (stops[stops.len() - 1].clone(), self.stop(section[1]));
            let halved = self.halved(start.clone(), end, most)?;
            let section = [section[0], section[1]];
            match self.fewer_equal(&start, section, halved.len()) {
                Some(equal) => stops.extend(equal),
                None => stops.extend(halved),
            }
            GeomError::go_on(1)?;
            if most < stops.len() {
                return Err(CountError::TooManyVertices { got: stops.len(), most }.into());
            }
        }
        Ok(stops)
    }

    /// The stops behind the start up to the end, by halving.
    fn halved(
        &self,
        start: SeamPlace,
        end: SeamPlace,
        most: usize,
    ) -> Result<Vec<SeamPlace>, GeomError> {
        let mut stops = Vec::new();
        let (mut low, mut todo) = (start, vec![(end, 0)]);
        while let Some((high, n_halvings)) = todo.pop() {
            GeomError::go_on(1)?;
            if PARAMETER_HALVINGS <= n_halvings || self.fits(&low, &high) {
                stops.push(high.clone());
                low = high;
            } else {
                let middle = self.stop(0.5 * (low.fraction + high.fraction));
                todo.extend([(high, n_halvings + 1), (middle, n_halvings + 1)]);
            }
            let got = stops.len() + todo.len();
            if most < got {
                return Err(CountError::TooManyVertices { got, most }.into());
            }
        }
        Ok(stops)
    }

    /// The stops at equal parts, if they are fewer than by halving.
    fn fewer_equal(
        &self,
        start: &SeamPlace,
        section: [f64; 2],
        n_halved: usize,
    ) -> Option<Vec<SeamPlace>> {
        let try_parts = |n: usize| {
            let mut stops: Vec<SeamPlace> = Vec::with_capacity(n);
            for i in 1..=n {
                let stop = self.stop(equal(section, i, n));
                if !work::goes_on(1) || !self.fits(stops.last().unwrap_or(start), &stop) {
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
        for (stretch, edge, turns) in self.stretches() {
            for line in edge.breaks(&self.sheets[edge.sheet]) {
                let fraction = stretch.fraction(edge, line.at);
                forced
                    .extend(fraction.map(|fraction| if turns { 1.0 - fraction } else { fraction }));
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
    fn fits(&self, low: &SeamPlace, high: &SeamPlace) -> bool {
        if self.tolerance < deviation(&self.pieces, [low.parameters[0], high.parameters[0]]) {
            return false;
        }
        let ends = low.parameters.iter().zip(&high.parameters);
        self.stretches().zip(ends).all(|((_, edge, _), (&a, &b))| {
            let (ends, cells) = ([a.min(b), a.max(b)], &self.cells[edge.sheet]);
            let is_last = edge.number % 2 == 1;
            if cells.ball().is_some_and(|ball| !ball.allows_leg(edge.number, ends)) {
                return false;
            }
            cells.allow(match edge.number {
                0 | 1 => [cells.rim(Direction::U, is_last), ends],
                _ => [ends, cells.rim(Direction::V, is_last)],
            })
        })
    }
}

fn equal([low, high]: [f64; 2], i: usize, n: usize) -> f64 {
    if i == n { high } else { low + (high - low) * (i as f64 / n as f64) }
}

/// A bound of how far a curve is from its chord between two parameters, by its pieces in order.
fn deviation(pieces: &[(Interval, PiecePoints)], [start, end]: [f64; 2]) -> f64 {
    let first = pieces.partition_point(|(interval, _)| interval.end() <= start);
    let touched = pieces[first..].iter().take_while(|(interval, _)| interval.start() < end);
    let part = |(interval, points): &(Interval, PiecePoints)| {
        let mut part = points.clone();
        let fraction = interval.fraction_of(end);
        if fraction < 1.0 {
            part = cut_before(&mut part, fraction);
        }
        let whole = interval.fraction_of(end.min(interval.end()));
        let fraction = interval.fraction_of(start) / whole;
        if 0.0 < fraction {
            cut_before(&mut part, fraction);
        }
        part
    };
    let parts: SmallVec<[PiecePoints; 2]> = touched.map(part).collect();
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return 0.0 };
    let chord = [first[0], last[last.len() - 1]];
    parts.iter().map(|part| chord_deviation(part, chord)).fold(0.0, f64::max)
}
