//! Edges along which two surfaces are neighbours, and what is only there.
//!
//! Neighbours are as near to one another as one likes beside the edge that they share, and parallel
//! where they are smooth, so that halving their parts would not end. With the common edge E, and X
//! and Y what leads from it into each of them, a place that two parts share is
//! E(t) − E(τ) = sY − uX with u and s above zero. Chords of E are within a cone about its tangents, and
//! Y and −X within another: where these are apart the edge is all that the parts share.

use std::f64::consts::PI;

use glam::DVec3;

use super::pair::SurfacePart;
use crate::{
    Direction, GeomError, Interval, NurbsCurve, NurbsSurface, Side,
    frame::unit,
    surface::Edge,
    tolerance::{ALONG_EDGE, BESIDE_EDGE, CONE_CLEARANCE},
};

/// A stretch that an edge of one surface and an edge of the other have in common.
#[derive(Clone, Debug)]
pub(super) struct EdgeOverlap {
    edges: [Edge; 2],
    /// The end of each surface's domain where the edge is.
    ends: [f64; 2],
    /// The common stretch.
    pub(super) curve: NurbsCurve,
}

impl EdgeOverlap {
    /// All of two surfaces, as far as they are within a distance.
    ///
    /// # Errors
    /// As [`NurbsCurve::trimmed`].
    pub(super) fn all([a, b]: [&NurbsSurface; 2], distance: f64) -> Result<Vec<Self>, GeomError> {
        let mut seams = Vec::new();
        let (of_a, of_b) = (a.edges(), b.edges());
        for (first, curve) in Edge::ALL.into_iter().zip(&of_a) {
            for (second, other) in Edge::ALL.into_iter().zip(&of_b) {
                if let Some(curve) = common(curve, other, distance)? {
                    let ends = [end_of(a, first), end_of(b, second)];
                    seams.push(Self { edges: [first, second], ends, curve });
                }
            }
        }
        Ok(seams)
    }

    /// A point beside it that is on both surfaces, where they share an area there. What is only on a line that
    /// leaves the edge is none.
    pub(super) fn overlap(&self, [a, b]: [&NurbsSurface; 2], distance: f64) -> Option<DVec3> {
        let (along, side) = self.edges[0].place();
        let across = a.domain(along);
        let beside = |share: f64| across.at(if side == Side::Left { share } else { 1.0 - share });
        let domain = self.curve.domain();
        let inside = |share: f64| {
            let foot = a.closest(self.curve.point_at(domain.at(share))).parameters;
            BESIDE_EDGE.map(|share| match along {
                Direction::U => a.point_at(beside(share), foot[1]),
                Direction::V => a.point_at(foot[0], beside(share)),
            })
        };
        let is_shared = |share: &f64| {
            inside(*share).into_iter().all(|point| b.closest(point).distance <= distance)
        };
        let is_area = |share: &f64| is_shared(share) && is_shared(&(share + ALONG_EDGE));
        [0.25, 0.5, 0.75].into_iter().find(is_area).map(|share| inside(share)[0])
    }

    /// How many of the surfaces do not end there, as they close.
    pub(super) fn n_inside(&self, surfaces: [&NurbsSurface; 2], distance: f64) -> usize {
        let is_inside = |&(surface, edge): &(&NurbsSurface, Edge)| match edge.place().0 {
            Direction::U => surface.is_closed_u(distance),
            Direction::V => surface.is_closed_v(distance),
        };
        surfaces.into_iter().zip(self.edges).filter(is_inside).count()
    }

    /// Whether parts of both surfaces are beside it.
    pub(super) fn is_beside(&self, a: &SurfacePart, b: &SurfacePart) -> bool {
        [a, b].into_iter().zip(self.edges.into_iter().zip(self.ends)).all(|(part, (edge, end))| {
            let (along, side) = edge.place();
            let across = usize::from(along == Direction::V);
            match side {
                Side::Left => part.low[across] <= end,
                Side::Right => end <= part.high[across],
            }
        })
    }

    /// Whether it is all that two parts beside it share.
    pub(super) fn is_all_of(&self, a: &SurfacePart, b: &SurfacePart) -> bool {
        let [first, second] = [a.along(self.edges[0]), b.along(self.edges[1])];
        let (Some(tangent), Some(other)) = (mean(&first), mean(&second)) else { return false };
        let sign = if tangent.dot(other) < 0.0 { -1.0 } else { 1.0 };
        let along: Vec<DVec3> =
            first.into_iter().chain(second.into_iter().map(|step| step * sign)).collect();
        let away = a.inward(self.edges[0]).into_iter().map(|step| -step);
        let across: Vec<DVec3> = away.chain(b.inward(self.edges[1])).collect();
        let (Some(tangent), Some(out)) = (mean(&along), mean(&across)) else { return false };
        let spread = spread(&along, tangent) + spread(&across, out) + CONE_CLEARANCE;
        let between = tangent.angle_between(out);
        spread < between && spread < PI - between
    }

    /// The stretch, run along the product of the normals of both surfaces where that tells.
    pub(super) fn directed(&self, surfaces: [&NurbsSurface; 2]) -> NurbsCurve {
        let domain = self.curve.domain();
        let here = self.curve.derivatives_at(domain.at(0.5), 1);
        let normal = |surface: &NurbsSurface| {
            let [u, v] = surface.closest(here[0]).parameters;
            surface.normal_at(u, v).unwrap_or(DVec3::ZERO)
        };
        let [a, b] = surfaces.map(normal);
        if a.cross(b).dot(here[1]) < 0.0 { self.curve.reversed() } else { self.curve.clone() }
    }

    /// Those of several that are no part of one before them: where a surface closes, two of its edges
    /// are one.
    pub(super) fn different(seams: &[Self], distance: f64) -> Vec<&Self> {
        let mut found: Vec<&Self> = Vec::new();
        for seam in seams {
            let middle = seam.curve.point_at(seam.curve.domain().at(0.5));
            if !found.iter().any(|other| other.holds(middle, distance)) {
                found.push(seam);
            }
        }
        found
    }

    /// Whether a point is on it.
    pub(super) fn holds(&self, point: DVec3, distance: f64) -> bool {
        self.curve.foot_within(point, distance).is_some()
    }
}

fn end_of(surface: &NurbsSurface, edge: Edge) -> f64 {
    let (along, side) = edge.place();
    let domain = surface.domain(along);
    if side == Side::Left { domain.start() } else { domain.end() }
}

/// The middle of directions.
fn mean(steps: &[DVec3]) -> Option<DVec3> {
    unit(steps.iter().filter_map(|&step| unit(step)).sum())
}

/// How far directions are from one, at most.
fn spread(steps: &[DVec3], axis: DVec3) -> f64 {
    steps
        .iter()
        .filter_map(|&step| unit(step))
        .map(|step| step.angle_between(axis))
        .fold(0.0, f64::max)
}

/// The stretch of a curve that is within a distance of another; `None` where that is no longer
/// than the distance, or where the two part between their ends.
fn common(
    curve: &NurbsCurve,
    other: &NurbsCurve,
    distance: f64,
) -> Result<Option<NurbsCurve>, GeomError> {
    let (mine, its) = (curve.bounds(), other.bounds());
    if !mine.is_near(its, distance) || mine.diagonal() <= distance || its.diagonal() <= distance {
        return Ok(None);
    }
    let is_near = |t: f64| other.foot_within(curve.point_at(t), distance).is_some();
    let domain = curve.domain();
    let feet = [other.start(), other.end()].map(|end| curve.closest(end, distance));
    let mut ends: Vec<f64> = feet
        .into_iter()
        .filter(|foot| foot.distance <= distance)
        .map(|foot| foot.parameter)
        .chain([domain.start(), domain.end()])
        .collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    // More places than two different curves of these degrees have in common.
    let n_looks =
        4 * (curve.degree() + 1) * (other.degree() + 1) * (curve.n_segments() + other.n_segments());
    let is_shared = |ends: &[f64]| {
        let inside = (1..n_looks).map(|i| i as f64 / n_looks as f64);
        inside.map(|share| ends[0] + (ends[1] - ends[0]) * share).all(is_near)
    };
    let shared: Vec<&[f64]> = ends.windows(2).filter(|ends| is_shared(ends)).collect();
    let (Some(first), Some(last)) = (shared.first(), shared.last()) else { return Ok(None) };
    let (start, end) = (first[0], last[1]);
    if curve.point_at(start).distance(curve.point_at(0.5 * (start + end))) <= distance {
        return Ok(None);
    }
    if start <= domain.start() && domain.end() <= end {
        return Ok(Some(curve.clone()));
    }
    curve.trimmed(Interval::new(start, end)?).map(Some)
}
