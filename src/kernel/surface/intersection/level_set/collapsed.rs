//! Collapsed edges that lie on the other surface, such as a pole that a curve passes through.
//!
//! All parameters along such an edge are one point, so that no step of Newton's method leads over it: curves
//! end there, and are joined to what leaves on the other side.

use glam::DVec3;

use super::{
    SAMPLING,
    sample::MOST_TURN,
    surface_pair::{CollapsedEdge, PairParameters, PlaceCondition, SurfacePair},
    trace::GROWTH,
};
use crate::{NurbsCurve, NurbsSurface, frame::unit, tolerance::LAST_BIT};

/// A way this many times longer than it is along the curve leads past what it leads to.
const WIDEST_ARRIVAL: f64 = 1.2;

/// The edges of either surface that are points on the other one.
pub(super) fn collapsed(surfaces: [&NurbsSurface; 2], tolerance: f64) -> Vec<CollapsedEdge> {
    let bounds = surfaces.map(NurbsSurface::bounds);
    let is_point = |edge: &NurbsCurve| edge.bounds().diagonal() <= LAST_BIT.sqrt() * tolerance;
    let edges = surfaces.into_iter().flat_map(NurbsSurface::edges).filter(is_point);
    let mut found: Vec<CollapsedEdge> = Vec::new();
    for point in edges.map(|edge| edge.start()) {
        let is_known = found.iter().any(|known| known.point.distance(point) <= tolerance);
        if is_known || !bounds.iter().all(|bounds| bounds.contains(point, tolerance)) {
            continue;
        }
        let feet = surfaces.map(|surface| surface.closest(point));
        if feet.iter().any(|foot| tolerance < foot.distance) {
            continue;
        }
        let normal = |i: usize| {
            let [u, v] = feet[i].parameters;
            surfaces[i].normal_at(u, v).unwrap_or(DVec3::ZERO)
        };
        let across = normal(0).cross(normal(1));
        let is_clear = LAST_BIT.sqrt() < across.length();
        let tangent = unit(across).filter(|_| is_clear).unwrap_or(DVec3::ZERO);
        found.push(CollapsedEdge { point, tangent });
    }
    found
}

impl SurfacePair<'_> {
    /// Whether a point is a collapsed edge of either surface.
    pub(super) fn is_collapsed(&self, point: DVec3) -> bool {
        self.collapsed.iter().any(|edge| edge.point.distance(point) <= self.tolerance)
    }

    /// A collapsed edge that the next step may lead to.
    pub(super) fn collapsed_ahead(
        &self,
        last: PairParameters,
        sign: f64,
        step: f64,
    ) -> Option<&CollapsedEdge> {
        self.collapsed.iter().find(|edge| {
            let way = edge.point - last.point;
            let along = way.dot(last.tangent * sign);
            0.0 < along && along <= GROWTH * step && way.length() <= WIDEST_ARRIVAL * along
        })
    }

    /// A collapsed edge as the next place, where a cubic to it stays on the curve. Parameters along such an
    /// edge are all one point, so that no step leads over it.
    pub(super) fn arrival_at(
        &self,
        last: PairParameters,
        sign: f64,
        edge: &CollapsedEdge,
    ) -> Option<PairParameters> {
        let end = PairParameters { at: last.at, point: edge.point, tangent: edge.tangent };
        let way = edge.point - last.point;
        if way.length() <= self.tolerance {
            return Some(end);
        }
        let speed = self.speed(last);
        let half = 0.5 * way.dot(last.tangent);
        let middle = std::array::from_fn(|i| last.at[i] + speed[i] * half);
        let cubic = self.cubic(last, end, sign);
        let plane = PlaceCondition::InPlane { origin: cubic.middle(), normal: unit(way)? };
        let place = self.common_where(middle, plane)?;
        let turn = last.tangent.distance_squared(end.tangent);
        let is_followed = (end.tangent == DVec3::ZERO || turn <= MOST_TURN)
            && self.is_inside(place.at)
            && cubic.misses(place.point) <= SAMPLING * self.tolerance;
        is_followed.then_some(end)
    }
}
