//! Arcs cut at their meetings, with places within the tolerance as one vertex.

use std::collections::BTreeMap;

use glam::DVec3;

use super::{Apart, Arrangement, PlaneEdge, Ring, meet, near::near_pairs};
use crate::{
    GeomError, Interval, NurbsCurve,
    disjoint_sets::DisjointSets,
    frame::norm,
    side_by_side,
    sorting::sort_by,
    tolerance::{ONE_PLACE_SHARE, PARAMETER_RELATIVE, VERTEX_REACH},
};

/// Tolerances within which edges with the same ends are one: each may be one away from the middle.
const ALONG: f64 = 2.0;

/// Pairs of arcs for which a further thread pays.
const WORTH_A_THREAD: usize = 100;

/// Parts of an edge whose ends tell how far it goes.
const EXTENT_PARTS: usize = 8;

/// A place on an arc at which it is cut.
#[derive(Clone, Copy)]
struct CutPoint {
    arc: usize,
    parameter: f64,
    point: DVec3,
}

impl Arrangement {
    /// That of all arcs of rings, by up to `n_threads` threads.
    ///
    /// # Errors
    /// `IntersectionError::RunsAlongItself`, `IntersectionError::Tangled`.
    pub(crate) fn of(
        rings: &[Ring],
        apart: Apart,
        tolerance: f64,
        n_threads: usize,
    ) -> Result<Self, GeomError> {
        let arcs: Vec<NurbsCurve> = rings.iter().flat_map(|ring| &ring.arcs).cloned().collect();
        let groups: Vec<usize> =
            rings.iter().flat_map(|ring| ring.arcs.iter().map(|_| ring.group)).collect();
        let ends = arcs.iter().enumerate().flat_map(|(arc, curve)| {
            let domain = curve.domain();
            let ends = [(domain.start(), curve.start()), (domain.end(), curve.end())];
            ends.map(|(parameter, point)| CutPoint { arc, parameter, point })
        });
        let mut cuts: Vec<CutPoint> = ends.collect();
        let is_wanted = |i: usize, j: usize| apart == Apart::Nothing || groups[i] != groups[j];
        let pairs = near_pairs(&arcs, is_wanted, tolerance)?;
        let n_threads = n_threads.min(pairs.len() / WORTH_A_THREAD + 1);
        let found = side_by_side::map(&pairs, n_threads, |&[i, j]| match i == j {
            true => meet::own_meetings(&arcs[i], tolerance),
            false => meet::meetings(&arcs[i], &arcs[j], tolerance),
        });
        for ([i, j], found) in pairs.into_iter().zip(found) {
            for [s, t] in found? {
                let (p, q) = (arcs[i].point_at(s), arcs[j].point_at(t));
                let point = p.midpoint(q);
                cuts.extend([(i, s), (j, t)].map(|(arc, parameter)| CutPoint {
                    arc,
                    parameter,
                    point,
                }));
            }
        }
        let (vertices, vertex_of) = vertices(&cuts, tolerance);
        let (edges, repeated, swallowed) = (Vec::new(), None, None);
        let mut arrangement = Self { vertices, edges, repeated, swallowed, arcs, tolerance };
        arrangement.cut(&cuts, &vertex_of, &groups)?;
        arrangement.swallowed = arrangement.first_swallowed(rings);
        arrangement.merge();
        Ok(arrangement)
    }

    /// Makes edges of what is between cuts.
    fn cut(
        &mut self,
        cuts: &[CutPoint],
        vertex_of: &[usize],
        groups: &[usize],
    ) -> Result<(), GeomError> {
        let mut of_arc: Vec<Vec<(f64, usize)>> = vec![Vec::new(); self.arcs.len()];
        for (cut, &vertex) in cuts.iter().zip(vertex_of) {
            of_arc[cut.arc].push((cut.parameter, vertex));
        }
        for (arc, places) in of_arc.iter_mut().enumerate() {
            sort_by(places, |a, b| a.0.total_cmp(&b.0));
            let curve = &self.arcs[arc];
            let Some(&(mut start, mut from)) = places.first() else { continue };
            // How far the curve is from the vertex there.
            let off = |t: f64, vertex: usize| norm(curve.point_at(t) - self.vertices[vertex]);
            let is_end = |t: f64| t <= curve.domain().start() || curve.domain().end() <= t;
            for &(end, to) in &places[1..] {
                GeomError::go_on(1)?;
                let Ok(interval) = Interval::new(start, end) else {
                    from = to;
                    continue;
                };
                let extent = if from == to { extent(curve, interval) } else { f64::INFINITY };
                if extent <= VERTEX_REACH * self.tolerance {
                    // Of several cuts at a vertex the nearest counts, for what begins and for what ended there.
                    if !is_end(start) && (is_end(end) || off(end, to) < off(start, to)) {
                        if let Some(before) = self.edges.last_mut()
                            && before.arc == arc
                            && before.interval.end() >= start
                            && let Ok(whole) = Interval::new(before.interval.start(), end)
                        {
                            before.curve = part_of(curve, whole)?;
                            before.interval = whole;
                        }
                        start = end;
                    }
                    continue;
                }
                let curve = part_of(curve, interval)?;
                let passes = vec![(groups[arc], 1)];
                self.edges.push(PlaneEdge { arc, interval, curve, ends: [from, to], passes });
                (start, from) = (end, to);
            }
        }
        Ok(())
    }

    /// A place of the first ring of which cutting has left no edge.
    fn first_swallowed(&self, rings: &[Ring]) -> Option<DVec3> {
        let mut is_left = vec![false; self.arcs.len()];
        self.edges.iter().for_each(|edge| is_left[edge.arc] = true);
        let mut numbers = 0..self.arcs.len();
        let swallowed = rings.iter().find(|ring| {
            let own = numbers.by_ref().take(ring.arcs.len());
            own.filter(|&arc| is_left[arc]).count() == 0
        })?;
        swallowed.arcs.first().map(NurbsCurve::start)
    }

    /// Makes one edge of those that lie along one another, and drops what runs back along itself.
    fn merge(&mut self) {
        let mut by_ends: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        let mut merged: Vec<PlaneEdge> = Vec::with_capacity(self.edges.len());
        for edge in std::mem::take(&mut self.edges) {
            let [a, b] = edge.ends;
            let known = by_ends.entry([a.min(b), a.max(b)]).or_default();
            let along = known.iter().find_map(|&other| {
                sense_along(&edge, &merged[other], ALONG * self.tolerance)
                    .map(|sense| (other, sense))
            });
            let Some((other, sense)) = along else {
                known.push(merged.len());
                merged.push(edge);
                continue;
            };
            let start = merged[other].ends[0];
            // Two arcs that touch at a small angle are near one another there, but not one.
            let is_one = {
                let middle = edge.curve.point_at(edge.curve.domain().at(0.5));
                merged[other].curve.closest(middle, self.tolerance).distance
                    <= ONE_PLACE_SHARE * self.tolerance
            };
            let passes = &mut merged[other].passes;
            for (group, times) in edge.passes {
                match passes.iter_mut().find(|pass| pass.0 == group) {
                    Some(pass) => {
                        pass.1 += sense * times;
                        if is_one {
                            self.repeated.get_or_insert((start, group));
                        }
                    }
                    None => passes.push((group, sense * times)),
                }
            }
            passes.retain(|pass| pass.1 != 0);
        }
        merged.retain(|edge| !edge.passes.is_empty());
        self.edges = merged;
    }
}

/// The vertices, and that of each cut: places within the tolerance of one another are one.
fn vertices(cuts: &[CutPoint], tolerance: f64) -> (Vec<DVec3>, Vec<usize>) {
    let mut places = DisjointSets::new(cuts.len());
    let mut order: Vec<usize> = (0..cuts.len()).collect();
    sort_by(&mut order, |&i, &j| cuts[i].point.x.total_cmp(&cuts[j].point.x).then(i.cmp(&j)));
    for (place, &i) in order.iter().enumerate() {
        let own = cuts[i].point;
        for &j in order[place + 1..].iter().take_while(|&&j| cuts[j].point.x <= own.x + tolerance) {
            if norm(cuts[j].point - own) <= tolerance {
                places.unite(i, j);
            }
        }
    }
    // The first of those that are one gives the place: the given ends come before meetings.
    let mut vertices = Vec::new();
    let mut numbers = vec![0; cuts.len()];
    for i in 0..cuts.len() {
        let root = places.least(i);
        if root == i {
            numbers[i] = vertices.len();
            vertices.push(cuts[i].point);
        } else {
            numbers[i] = numbers[root];
        }
    }
    (vertices, numbers)
}

/// A part of a curve. One that ends beside a knot ends in it, so that no span is left that is rounding.
fn part_of(curve: &NurbsCurve, interval: Interval) -> Result<NurbsCurve, GeomError> {
    let domain = curve.domain();
    if interval == domain {
        return Ok(curve.clone());
    }
    let (slack, breaks) = (PARAMETER_RELATIVE * domain.length(), curve.knots().breaks());
    let onto_knot = |t: f64| {
        let behind = breaks.partition_point(|&knot| knot < t - slack);
        breaks.get(behind).copied().filter(|&knot| knot <= t + slack).unwrap_or(t)
    };
    let onto_knots = Interval::new(onto_knot(interval.start()), onto_knot(interval.end()));
    curve.trimmed(onto_knots.unwrap_or(interval))
}

/// How far a part of a curve goes from its start.
fn extent(curve: &NurbsCurve, interval: Interval) -> f64 {
    let start = curve.point_at(interval.start());
    let away = |t: f64| norm(curve.point_at(t) - start);
    interval.steps(EXTENT_PARTS).into_iter().map(away).fold(0.0, f64::max)
}

/// Whether an edge lies along another with the same ends: 1 if it runs with it, −1 if against it.
fn sense_along(edge: &PlaneEdge, other: &PlaneEdge, tolerance: f64) -> Option<i32> {
    let bounds = other.curve.bounds();
    let mut places = [0.0; 3];
    for (place, fraction) in places.iter_mut().zip([0.5, 0.25, 0.75]) {
        let point = edge.curve.point_at(edge.interval.at(fraction));
        // Most arcs between the same ends bulge to either side.
        if !bounds.contains(point, tolerance) {
            return None;
        }
        let nearest = other.curve.closest(point, tolerance);
        if tolerance < nearest.distance {
            return None;
        }
        *place = nearest.parameter;
    }
    let runs_along = match edge.ends[0] == edge.ends[1] {
        true => places[1] < places[2],
        false => edge.ends == other.ends,
    };
    Some(if runs_along { 1 } else { -1 })
}
