//! Edges and corners of one surface that lie on another within the tolerance where no curve is told.
//!
//! Such an edge does not reach the other surface, or reaches it in less than the tolerance tells apart: there both touch
//! within the tolerance, and do not cross. Where a spline stands in for a function it may cross all the same.

use glam::DVec3;

use super::LevelSet;
use crate::{NurbsCurve, NurbsSurface};

/// Stretches of an edge that are looked at, whether they lie on another surface.
const N_LOOKS: usize = 16;

/// Tolerances from a curve within which a place is told by it.
const TOLD: f64 = 4.0;

/// Stretches between a place and what is told aside, at whose ends it is looked whether both surfaces are there.
const STRIP_LOOKS: usize = 8;

/// An edge of one of two surfaces, a stretch of which lies on the other and is on no curve that is told.
pub(super) struct EdgeOnOther {
    edge: NurbsCurve,
    /// In the middle of the stretch.
    pub(super) point: DVec3,
    /// How near it comes to the other surface where it is looked at.
    pub(super) least_distance: f64,
}

/// One surface beside another, and what is told of both.
struct SurfaceBeside<'s> {
    own: &'s NurbsSurface,
    other: &'s NurbsSurface,
    told: &'s LevelSet,
    tolerance: f64,
}

impl EdgeOnOther {
    /// Of two surfaces the edges that lie on the other somewhere beside what is told.
    pub(super) fn all(told: &LevelSet, [a, b]: [&NurbsSurface; 2], tolerance: f64) -> Vec<Self> {
        let pairs = [(a, b), (b, a)].into_iter();
        let found = pairs.flat_map(|(own, other)| {
            let beside = SurfaceBeside { own, other, told, tolerance };
            own.edges().into_iter().filter_map(move |edge| beside.look_along(edge))
        });
        found.collect()
    }
}

/// What two surfaces share, with edges and corners that lie on the other within the tolerance.
pub(super) fn with_edges_beside(
    mut told: LevelSet,
    surfaces: [&NurbsSurface; 2],
    tolerance: f64,
) -> LevelSet {
    let edges = EdgeOnOther::all(&told, surfaces, tolerance);
    let [a, b] = surfaces;
    let is_end = |corner: DVec3| {
        let ends = edges.iter().flat_map(|found| [found.edge.start(), found.edge.end()]);
        ends.into_iter().any(|end| end.distance(corner) <= TOLD * tolerance)
    };
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
    for (_, corner, [own, other]) in corners {
        let is_told = SurfaceBeside { own, other, told: &told, tolerance }.is_told(corner);
        if !is_told {
            told.touches.push(corner);
        }
    }
    told.contacts.extend(edges.into_iter().map(|found| found.point));
    told
}

/// How far a point is from a surface where it is on it.
fn distance_within(surface: &NurbsSurface, point: DVec3, tolerance: f64) -> Option<f64> {
    let is_near = surface.bounds().contains(point, tolerance);
    let distance = is_near.then(|| surface.closest(point).distance)?;
    (distance <= tolerance).then_some(distance)
}

impl SurfaceBeside<'_> {
    /// The first stretch of an edge that lies on the other surface and is not told.
    fn look_along(&self, edge: NurbsCurve) -> Option<EdgeOnOther> {
        let place = |share: f64| edge.point_at(edge.domain().at(share / N_LOOKS as f64));
        let found = (0..N_LOOKS).find_map(|i| {
            let places = [0.5, 0.0, 1.0].map(|share| place(i as f64 + share));
            let [middle, start, end] = places;
            let is_lost = TOLD * self.tolerance < start.distance(end)
                && places.iter().all(|&point| self.is_on(point))
                && !self.is_told(middle);
            is_lost.then_some(places)
        });
        let places = found?;
        let distances = places.map(|point| self.other.closest(point).distance);
        let least_distance = distances.into_iter().fold(f64::INFINITY, f64::min);
        Some(EdgeOnOther { edge, point: places[0], least_distance })
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
