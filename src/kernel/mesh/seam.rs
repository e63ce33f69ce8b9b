//! The edges of surfaces as polygons that surfaces side by side share.
//!
//! Edges are cut where corners of any surface lie on them, so that where edges run together, stretches
//! of them are one curve from end to end. A stretch is divided by its arc length, so that its
//! polygon does not depend on how a surface runs along it. Stretches that are one curve, in either
//! direction, are divided together, and their vertices are the same numbers.

use glam::DVec3;

use super::{
    cell_bounds::TessellationOptions,
    edge::{EdgeCorner, PatchEdge},
    places_along::PlacesAlong,
    surface_patch::{SHARE, SurfacePatch},
    weld::welded,
};
use crate::{GeomError, Interval, sorting::sort_by_key, tolerance::WELD_SHARE};

/// Parts of a stretch between which it is compared with another.
const COMPARED: usize = 8;

/// A part of an edge from one corner on it to the next.
#[derive(Debug)]
pub(super) struct EdgeStretch {
    pub(super) edge: usize,
    pub(super) ends: [EdgeCorner; 2],
}

/// Stretches that are one curve; the first gives the points.
#[derive(Debug)]
pub(super) struct SharedEdge {
    /// Indices of stretches, and whether they run against the first.
    pub(super) stretches: Vec<(usize, bool)>,
    /// For each of these the first that has the same parameters everywhere.
    pub(super) repeats: Vec<usize>,
}

/// Vertices on an edge: parameters along it, growing, and places.
pub(super) type Vertices = Vec<(f64, DVec3)>;

/// All edges of some sheets.
#[derive(Debug)]
pub(super) struct SharedEdges {
    pub(super) edges: Vec<PatchEdge>,
    /// Those of an edge one behind the other; none of edges that are points.
    pub(super) stretches: Vec<EdgeStretch>,
    pub(super) seams: Vec<SharedEdge>,
    /// Where the corners are that others are welded to: those of the sheets, and behind them places that edges
    /// must have vertices at.
    pub(super) corners: Vec<DVec3>,
    n_of_sheets: usize,
}

impl SharedEdges {
    /// Finds what the sheets share, and takes what that costs from their tolerances; edges on which one of the
    /// places lies have a vertex there.
    ///
    /// # Errors
    /// Those of [`SurfacePatch::point_at`].
    pub(super) fn of(
        sheets: &mut [SurfacePatch<'_>],
        places: &[DVec3],
        wanted: &TessellationOptions,
    ) -> Result<Self, GeomError> {
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
        let n_of_sheets = corners.len();
        corners.extend_from_slice(places);
        let names = welded(&corners, weld);
        let mut edges = Vec::with_capacity(n_of_sheets);
        for (i, sheet) in sheets.iter().enumerate() {
            // The corners are u0v0, u0v1, u1v0, u1v1.
            let ends = [[0, 1], [2, 3], [0, 2], [1, 3]];
            for (number, curve) in sheet.spline.edges().into_iter().enumerate() {
                let corners = ends[number].map(|corner| names[4 * i + corner]);
                edges.push(PatchEdge::new(i, number, curve, corners, weld));
            }
        }
        let (stretches, joined) = (Vec::new(), Vec::new());
        let mut seams = Self { edges, stretches, seams: joined, corners, n_of_sheets };
        seams.cut(sheets, &names, weld, wanted.tolerance)?;
        let mut gaps = seams.join(sheets, weld, wanted.tolerance)?;
        if seams.mend() {
            gaps = seams.join(sheets, weld, wanted.tolerance)?;
        }
        for (sheet, gap) in sheets.iter_mut().zip(gaps) {
            sheet.reserve(gap);
        }
        Ok(seams)
    }

    /// Cuts each edge where corners lie on it, those of its own sheet too.
    fn cut(
        &mut self,
        sheets: &[SurfacePatch<'_>],
        names: &[u32],
        weld: f64,
        tolerance: f64,
    ) -> Result<(), GeomError> {
        // Only the corners that others are welded to.
        let known = PlacesAlong::new(&self.corners, |corner| names[corner as usize] == corner);
        let mut stretches = Vec::with_capacity(self.edges.len());
        for (index, edge) in self.edges.iter().enumerate().filter(|(_, edge)| !edge.is_point) {
            let sheet = &sheets[edge.sheet];
            let slack = slack(sheet, tolerance);
            let reach = weld + slack;
            let near = edge
                .hull()
                .map_or(known.all(), |hull| known.between(hull.min - reach, hull.max + reach));
            let cuts = edge.cuts(sheet, &self.corners, near, [weld, slack])?;
            let stretch =
                |ends: &[EdgeCorner]| EdgeStretch { edge: index, ends: [ends[0], ends[1]] };
            stretches.extend(cuts.windows(2).map(stretch));
        }
        self.stretches = stretches;
        Ok(())
    }

    /// Finds the stretches that are one curve; how far that moves vertices of each sheet.
    fn join(
        &mut self,
        sheets: &[SurfacePatch<'_>],
        weld: f64,
        tolerance: f64,
    ) -> Result<Vec<f64>, GeomError> {
        let mut order: Vec<usize> = (0..self.stretches.len()).collect();
        let ends = |stretch: usize| {
            let [a, b] = self.stretches[stretch].ends.map(|end| end.corner);
            [a.min(b), a.max(b)]
        };
        sort_by_key(&mut order, |&stretch| (ends(stretch), stretch));
        let mut gaps = vec![0.0_f64; sheets.len()];
        let mut seams = Vec::new();
        for alike in order.chunk_by(|&a, &b| ends(a) == ends(b)) {
            let mut here: Vec<(Vec<DVec3>, SharedEdge)> = Vec::new();
            for &stretch in alike {
                let of = |stretch: usize| self.edges[self.stretches[stretch].edge].sheet;
                // One alone is compared with none.
                let places =
                    if alike.len() == 1 { Vec::new() } else { self.compared(stretch, sheets)? };
                let gap = &mut gaps[of(stretch)];
                *gap = gap.max(self.moved_at_ends(stretch, sheets)?);
                let found = here.iter().enumerate().find_map(|(i, (others, seam))| {
                    let both = [stretch, seam.stretches[0].0].map(|stretch| &sheets[of(stretch)]);
                    let slack = both.map(|sheet| slack(sheet, tolerance));
                    let slack = slack[0].max(slack[1]);
                    let (along, against) =
                        (apart(&places, others, false), apart(&places, others, true));
                    let (gap, turns) =
                        if against < along { (against, true) } else { (along, false) };
                    (gap <= weld + slack).then_some((i, gap + slack, turns))
                });
                match found {
                    Some((i, moved, turns)) => {
                        *gap = gap.max(moved);
                        let seam = &mut here[i].1;
                        seam.repeats.push(self.repeated(&seam.stretches, (stretch, turns)));
                        seam.stretches.push((stretch, turns));
                    }
                    None => here.push((
                        places,
                        SharedEdge { stretches: vec![(stretch, false)], repeats: vec![0] },
                    )),
                }
            }
            seams.extend(here.into_iter().map(|(_, seam)| seam));
        }
        self.seams = seams;
        Ok(gaps)
    }

    /// Which of the stretches before has the parameters of one everywhere; its own place if there is none.
    fn repeated(&self, before: &[(usize, bool)], (stretch, turns): (usize, bool)) -> usize {
        let this = &self.stretches[stretch];
        let curve = &self.edges[this.edge].curve;
        let is_same = |&(other, other_turns): &(usize, bool)| {
            let other = &self.stretches[other];
            let others = &self.edges[other.edge].curve;
            turns == other_turns
                && this.ends.iter().zip(&other.ends).all(|(a, b)| a.is_at(b))
                && curve.knots() == others.knots()
                && curve.control_points() == others.control_points()
        };
        before.iter().position(is_same).unwrap_or(before.len())
    }

    /// Makes one of stretches, one behind the other, that the same edges share, where none of these
    /// ends: a corner that only touches edges joins nothing. Whether there are such.
    fn mend(&mut self) -> bool {
        let mut sharing: Vec<&[usize]> = vec![&[]; self.stretches.len()];
        let edges_of = |seam: &SharedEdge| {
            let edges = seam.stretches.iter().map(|&(stretch, _)| self.stretches[stretch].edge);
            let mut edges: Vec<usize> = edges.collect();
            edges.sort_unstable();
            edges
        };
        let edges: Vec<Vec<usize>> = self.seams.iter().map(edges_of).collect();
        for (seam, edges) in self.seams.iter().zip(&edges) {
            seam.stretches.iter().for_each(|&(stretch, _)| sharing[stretch] = edges);
        }
        let mut mended: Vec<EdgeStretch> = Vec::with_capacity(self.stretches.len());
        for (i, stretch) in self.stretches.iter().enumerate() {
            let corner = stretch.ends[0].corner;
            let is_of_sheet = (corner as usize) < self.n_of_sheets;
            let is_end = |edge: &usize| self.edges[*edge].corners.contains(&corner);
            let touches = || is_of_sheet && !sharing[i].iter().any(is_end);
            match mended.last_mut().filter(|before| before.edge == stretch.edge) {
                Some(before) if sharing[i - 1] == sharing[i] && touches() => {
                    before.ends[1] = stretch.ends[1];
                }
                _ => mended.push(EdgeStretch { ..*stretch }),
            }
        }
        let are_fewer = mended.len() < self.stretches.len();
        self.stretches = mended;
        are_fewer
    }

    /// Places of a stretch between equal parts of its length.
    fn compared(
        &self,
        stretch: usize,
        sheets: &[SurfacePatch<'_>],
    ) -> Result<Vec<DVec3>, GeomError> {
        let stretch = &self.stretches[stretch];
        let edge = &self.edges[stretch.edge];
        let at = |i: usize| {
            let t = stretch.parameter(edge, i as f64 / COMPARED as f64, false);
            edge.point(&sheets[edge.sheet], t)
        };
        (1..COMPARED).map(at).collect()
    }

    /// How far the ends of a stretch are from the corners there.
    fn moved_at_ends(&self, stretch: usize, sheets: &[SurfacePatch<'_>]) -> Result<f64, GeomError> {
        let stretch = &self.stretches[stretch];
        let edge = &self.edges[stretch.edge];
        let mut most = 0.0_f64;
        for end in stretch.ends {
            let place = edge.point(&sheets[edge.sheet], end.parameter)?;
            most = most.max(place.distance(self.corners[end.corner as usize]));
        }
        Ok(most)
    }
}

impl EdgeStretch {
    /// The parameter at a fraction of its length, of that from the end where it `turns`.
    pub(super) fn parameter(&self, edge: &PatchEdge, fraction: f64, turns: bool) -> f64 {
        let [start, end] = self.ends;
        let fraction = if turns { 1.0 - fraction } else { fraction };
        if fraction <= 0.0 {
            start.parameter
        } else if 1.0 <= fraction {
            end.parameter
        } else {
            edge.parameter(start.fraction + (end.fraction - start.fraction) * fraction)
        }
    }

    /// Whether more of it than an end is in an interval of its edge's parameters.
    pub(super) fn touches(&self, interval: Interval) -> bool {
        let [start, end] = self.ends.map(|end| end.parameter);
        interval.start() < end && start < interval.end()
    }

    /// The fraction of its length before a parameter, if that is inside it.
    pub(super) fn fraction(&self, edge: &PatchEdge, parameter: f64) -> Option<f64> {
        let [start, end] = self.ends;
        let is_inside = start.parameter < parameter && parameter < end.parameter;
        let part = |fraction: f64| (fraction - start.fraction) / (end.fraction - start.fraction);
        is_inside.then(|| part(edge.fraction(parameter)))
    }
}

/// How far the points of a sheet may be from the spline that its edges are taken of.
fn slack(sheet: &SurfacePatch<'_>, tolerance: f64) -> f64 {
    if sheet.is_function() { SHARE * tolerance } else { 0.0 }
}

/// How far apart places are, in order or against it.
fn apart(a: &[DVec3], b: &[DVec3], turns: bool) -> f64 {
    let n = a.len();
    let other = |i: usize| if turns { b[n - 1 - i] } else { b[i] };
    (0..n).map(|i| a[i].distance(other(i))).fold(0.0, f64::max)
}
