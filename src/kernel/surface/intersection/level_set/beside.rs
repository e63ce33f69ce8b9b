//! Edges and corners of one surface that lie on another within the tolerance where no curve is told.
//!
//! Such an edge does not reach the other surface, or reaches it in less than the tolerance tells apart: there both touch
//! within the tolerance, and do not cross. Where a spline stands in for a function it may cross all the same.

use std::ops::Range;

use glam::DVec3;

use super::LevelSet;
use crate::{NurbsCurve, NurbsSurface, numeric::golden_section::golden_section};

/// Parts of an edge that are looked at, whether they lie on another surface.
const N_PARTS: usize = 16;

/// Tolerances from a curve within which a place is told by it.
const TOLD: f64 = 4.0;

/// Stretches between a place and what is told aside, at whose ends it is looked whether both surfaces are there.
const STRIP_LOOKS: usize = 8;

/// A stretch of an edge of one of two surfaces that lies on the other and is on no curve that is told.
struct EdgeOnOther<'s> {
    beside: SurfaceBeside<'s>,
    edge: NurbsCurve,
    /// The parts of the edge that it is made of.
    parts: Range<usize>,
}

/// One surface beside another, and what is told of both.
#[derive(Clone, Copy)]
struct SurfaceBeside<'s> {
    own: &'s NurbsSurface,
    other: &'s NurbsSurface,
    told: &'s LevelSet,
    tolerance: f64,
}

/// Of two surfaces the stretches of edges that lie on the other beside what is told.
fn edges_beside<'s>(
    told: &'s LevelSet,
    [a, b]: [&'s NurbsSurface; 2],
    tolerance: f64,
) -> Vec<EdgeOnOther<'s>> {
    let pairs = [(a, b), (b, a)].into_iter();
    let found = pairs.flat_map(|(own, other)| {
        let beside = SurfaceBeside { own, other, told, tolerance };
        own.edges().into_iter().flat_map(move |edge| beside.stretches(&edge))
    });
    found.collect()
}

/// A place beside what is told at which an edge of one of two surfaces that lies on the other comes to it within a
/// distance.
pub(super) fn edge_that_reaches(
    told: &LevelSet,
    surfaces: [&NurbsSurface; 2],
    [tolerance, distance]: [f64; 2],
) -> Option<DVec3> {
    let edges = edges_beside(told, surfaces, tolerance);
    edges.iter().find_map(|edge| edge.place_within(distance))
}

/// What two surfaces share, with edges and corners that lie on the other within the tolerance.
pub(super) fn with_edges_beside(
    mut told: LevelSet,
    surfaces: [&NurbsSurface; 2],
    tolerance: f64,
) -> LevelSet {
    let edges = edges_beside(&told, surfaces, tolerance);
    let contacts: Vec<DVec3> = edges.iter().map(EdgeOnOther::point).collect();
    let ends: Vec<DVec3> = edges.iter().flat_map(EdgeOnOther::ends).collect();
    let [a, b] = surfaces;
    let is_end = |corner: DVec3| ends.iter().any(|end| end.distance(corner) <= TOLD * tolerance);
    let mut corners: Vec<(f64, DVec3, [&NurbsSurface; 2])> = Vec::new();
    for pair in [[a, b], [b, a]] {
        let [own, other] = pair;
        for corner in own.edges().into_iter().flat_map(|edge| [edge.start(), edge.end()]) {
            if let Some(distance) = distance_within(other, corner, tolerance)
                && !is_end(corner)
            {
                corners.push((distance, corner, pair));
            }
        }
    }
    // Of several that lead to one another the nearest tells.
    corners.sort_by(|one, another| one.0.total_cmp(&another.0));
    for (distance, corner, [own, other]) in corners {
        // One place with a corner that is nearer to both is that corner, as two tips are.
        let away = |touch: DVec3| [own, other].map(|surface| surface.closest(touch).distance);
        let is_worse = |&touch: &DVec3| {
            touch.distance(corner) <= tolerance && away(touch).into_iter().any(|gap| distance < gap)
        };
        if let Some(touch) = told.touches.iter_mut().find(|touch| is_worse(touch)) {
            *touch = corner;
        }
        let is_told = SurfaceBeside { own, other, told: &told, tolerance }.is_told(corner);
        if !is_told {
            told.touches.push(corner);
        }
    }
    told.contacts.extend(contacts);
    told
}

/// How far a point is from a surface where it is on it.
fn distance_within(surface: &NurbsSurface, point: DVec3, tolerance: f64) -> Option<f64> {
    let is_near = surface.bounds().contains(point, tolerance);
    let distance = is_near.then(|| surface.closest(point).distance)?;
    (distance <= tolerance).then_some(distance)
}

impl EdgeOnOther<'_> {
    /// The place of its edge behind so many parts of that.
    fn place(&self, n_parts: f64) -> DVec3 {
        place_of(&self.edge, n_parts)
    }

    /// One of its places, none of its ends.
    fn point(&self) -> DVec3 {
        self.place(self.parts.start as f64 + 0.5)
    }

    fn ends(&self) -> [DVec3; 2] {
        [self.parts.start, self.parts.end].map(|n_parts| self.place(n_parts as f64))
    }

    /// Where it comes to the other surface within a distance, and no curve is told: at one of the ends and middles of
    /// its parts, or between these about one that is no further away than its neighbours.
    fn place_within(&self, distance: f64) -> Option<DVec3> {
        let away = |n_parts: f64| self.beside.other.closest(self.place(n_parts)).distance;
        let halves = 2 * self.parts.start..=2 * self.parts.end;
        let looks: Vec<f64> = halves.map(|n_halves| 0.5 * n_halves as f64).collect();
        let distances: Vec<f64> = looks.iter().map(|&n_parts| away(n_parts)).collect();
        let reaching = |n_parts: f64, its_distance: f64| {
            let place = self.place(n_parts);
            (its_distance <= distance && !self.beside.is_told(place)).then_some(place)
        };
        (0..looks.len()).find_map(|i| {
            let around = i.saturating_sub(1)..(i + 2).min(looks.len());
            let is_least = distances[around.clone()].iter().all(|&beside| distances[i] <= beside);
            let between = || {
                let ends = [looks[around.start], looks[around.end - 1]];
                let (nearest, least) = golden_section(away, ends);
                reaching(nearest, least)
            };
            let found = reaching(looks[i], distances[i]);
            if is_least { found.or_else(between) } else { found }
        })
    }
}

/// The place of an edge behind so many of its parts.
fn place_of(edge: &NurbsCurve, n_parts: f64) -> DVec3 {
    edge.point_at(edge.domain().at(n_parts / N_PARTS as f64))
}

impl<'s> SurfaceBeside<'s> {
    /// The stretches of an edge that lie on the other surface and are not told.
    fn stretches(self, edge: &NurbsCurve) -> Vec<EdgeOnOther<'s>> {
        let mut found: Vec<EdgeOnOther<'s>> = Vec::new();
        for part in (0..N_PARTS).filter(|&part| self.is_beside(edge, part)) {
            match found.last_mut() {
                Some(last) if last.parts.end == part => last.parts.end += 1,
                _ => {
                    let parts = part..part + 1;
                    found.push(EdgeOnOther { beside: self, edge: edge.clone(), parts });
                }
            }
        }
        found
    }

    /// Whether a part of an edge lies on the other surface, by three places, and is not told.
    fn is_beside(&self, edge: &NurbsCurve, part: usize) -> bool {
        let [middle, start, end] = [0.5, 0.0, 1.0].map(|share| place_of(edge, part as f64 + share));
        TOLD * self.tolerance < start.distance(end)
            && [middle, start, end].into_iter().all(|point| self.is_on(point))
            && !self.is_told(middle)
    }

    fn is_on(&self, point: DVec3) -> bool {
        distance_within(self.other, point, self.tolerance).is_some()
    }

    /// Whether a point is at a curve or a touch that is told. Where surfaces part slowly these lie aside, and what is
    /// between is on both.
    fn is_told(&self, point: DVec3) -> bool {
        let leads_to = |aside: DVec3| {
            point.distance(aside) <= TOLD * self.tolerance
                || (1..STRIP_LOOKS).all(|i| {
                    let between = point.lerp(aside, i as f64 / STRIP_LOOKS as f64);
                    let foot = self.own.closest(between).point;
                    self.other.closest(foot).distance <= self.tolerance
                })
        };
        let at_curve = |curve: &NurbsCurve| leads_to(curve.closest(point, self.tolerance).point);
        self.told.curves.iter().any(at_curve)
            || self.told.touches.iter().any(|&touch| leads_to(touch))
    }
}
