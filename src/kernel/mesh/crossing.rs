//! Where a mesh goes through itself, or lies on itself.
//!
//! A mesh that closes and goes through itself has an edge that goes through a triangle, with which it has no corner in
//! common: where two triangles cross, their common segment ends on edges of either. Where it lies on itself, triangles
//! overlap as seen along the normal of one of them.

use std::collections::{HashMap, HashSet};

use glam::{DVec2, DVec3};
use smallvec::SmallVec;

use super::{Mesh, nearest::MeshDistance};
use crate::{
    Bounds, GeomError,
    frame::unit,
    tolerance::{OVERLAID_COSINE, OVERLAID_SHARE, WEIGHT_SLACK},
};

/// A place of two triangles, by the weights of the corners of each.
pub(crate) type CommonWeights = [[f64; 3]; 2];

/// What two triangles of a mesh have in common.
pub(crate) enum TriangleMeeting {
    /// An edge of one goes through the other, its ends no less deep than this on either side.
    Crossing { place: CommonWeights, depth: f64 },
    /// They lie beside one another: some places in which one is over the other.
    Overlay { places: Vec<CommonWeights> },
}

/// Corners of a triangle within another one: six at most, but for rounding.
type CommonPolygon = SmallVec<[DVec2; 8]>;

/// A triangle with its plane; corners in that by two axes.
struct PlacedTriangle {
    corners: [DVec3; 3],
    bounds: Bounds,
    normal: DVec3,
    axes: [DVec3; 2],
    /// Its corners in its plane.
    flat: [DVec2; 3],
    /// What is no further from the plane lies in it.
    slack: f64,
}

impl Mesh {
    /// Goes through the pairs of triangles that cross, or do but for a slack, or lie over one another no further than
    /// `reach` away; looks at no more of them once there is an answer.
    ///
    /// # Errors
    /// `GeomError::Ended`.
    pub(crate) fn among_meetings<T>(
        &self,
        [reach, slack]: [f64; 2],
        mut look: impl FnMut([u32; 2], TriangleMeeting) -> Option<T>,
    ) -> Result<Option<T>, GeomError> {
        let Some(tree) = MeshDistance::new(self) else { return Ok(None) };
        let placed = self.corners().map(|corners| PlacedTriangle::new(corners, slack));
        let placed: Vec<Option<PlacedTriangle>> = placed.collect();
        for (i, own) in placed.iter().enumerate() {
            GeomError::go_on(1)?;
            let Some(own) = own else { continue };
            let around = own.bounds;
            let near = Bounds { min: around.min - reach, max: around.max + reach };
            let (mut found, triangle) = (None, i as u32);
            tree.each_near(near, |other| {
                let Some(beside) = placed[other as usize].as_ref() else { return };
                if other <= triangle || found.is_some() || !beside.bounds.is_near(near, 0.0) {
                    return;
                }
                found = own
                    .crossings(beside)
                    .chain(own.overlay(beside, reach))
                    .find_map(|meeting| look([triangle, other], meeting));
            });
            if found.is_some() {
                return Ok(found);
            }
        }
        Ok(None)
    }

    /// Whether each vertex is on an edge that one triangle alone has.
    pub(crate) fn border_vertices(&self) -> Vec<bool> {
        let sides = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
        let all: HashSet<[u32; 2]> = self.triangles.iter().copied().flat_map(sides).collect();
        let mut is_border = vec![false; self.n_vertices()];
        for &[from, to] in all.iter().filter(|&&[from, to]| !all.contains(&[to, from])) {
            (is_border[from as usize], is_border[to as usize]) = (true, true);
        }
        is_border
    }

    /// The middle of an edge, by the places of its ends, that more than two triangles have.
    pub(crate) fn crowded_edge(&self) -> Option<DVec3> {
        let bits = |place: DVec3| place.to_array().map(|x| (x + 0.0).to_bits());
        let mut counts: HashMap<[[u64; 3]; 2], usize> = HashMap::new();
        for corners in self.corners() {
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                let mut ends = [corners[from], corners[to]].map(bits);
                ends.sort_unstable();
                let count = counts.entry(ends).or_default();
                *count += 1;
                if 2 < *count {
                    return Some(corners[from].midpoint(corners[to]));
                }
            }
        }
        None
    }
}

impl PlacedTriangle {
    /// None of a triangle without a plane.
    fn new(corners: [DVec3; 3], slack: f64) -> Option<Self> {
        let [a, b, c] = corners;
        let normal = unit((b - a).cross(c - a))?;
        let along = unit(b - a)?;
        let axes = [along, normal.cross(along)];
        let bounds = Bounds { min: a.min(b).min(c), max: a.max(b).max(c) };
        let placed = Self { corners, bounds, normal, axes, flat: [DVec2::ZERO; 3], slack };
        Some(Self { flat: corners.map(|corner| placed.flat_place(corner)), ..placed })
    }

    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.corners[0])
    }

    fn flat_place(&self, point: DVec3) -> DVec2 {
        let off = point - self.corners[0];
        DVec2::new(off.dot(self.axes[0]), off.dot(self.axes[1]))
    }

    /// Where edges of one go through the other.
    fn crossings<'t>(&'t self, other: &'t Self) -> impl Iterator<Item = TriangleMeeting> + 't {
        let sides = [(self, other, false), (other, self, true)];
        sides.into_iter().flat_map(|(one, other, is_turned)| {
            let heights = other.corners.map(|corner| one.height(corner));
            let least = one.slack;
            let is_beside =
                heights.iter().all(|&h| least < h) || heights.iter().all(|&h| h < -least);
            let edges: &[[usize; 2]] = if is_beside { &[] } else { &[[0, 1], [1, 2], [2, 0]] };
            edges.iter().filter_map(move |&edge| one.pierced(other, edge, heights, is_turned))
        })
    }

    /// Where an edge of another one goes through it, whose corners have these heights; or comes to it within the slack.
    fn pierced(
        &self,
        other: &Self,
        [from, to]: [usize; 2],
        heights: [f64; 3],
        is_turned: bool,
    ) -> Option<TriangleMeeting> {
        let [p, q] = [other.corners[from], other.corners[to]];
        if self.corners.contains(&p) || self.corners.contains(&q) {
            return None;
        }
        let [before, behind] = [heights[from], heights[to]];
        let share = match before * behind < 0.0 {
            true => before / (before - behind),
            false => f64::from(u8::from(behind.abs() < before.abs())),
        };
        let point = p.lerp(q, share);
        let own = weights(self.flat, self.flat_place(point));
        if self.slack < self.height(point).abs() || own.iter().any(|&w| w < -WEIGHT_SLACK) {
            return None;
        }
        let mut others = [0.0; 3];
        (others[from], others[to]) = (1.0 - share, share);
        let place = if is_turned { [others, own] } else { [own, others] };
        let depth = if before * behind < 0.0 { before.abs().min(behind.abs()) } else { 0.0 };
        Some(TriangleMeeting::Crossing { place, depth })
    }

    /// The places in which another one is over it, if it is no further away and about parallel.
    fn overlay(&self, other: &Self, reach: f64) -> Option<TriangleMeeting> {
        if self.normal.dot(other.normal).abs() < OVERLAID_COSINE {
            return None;
        }
        let heights = other.corners.map(|corner| self.height(corner));
        if heights.iter().all(|&h| reach < h) || heights.iter().all(|&h| h < -reach) {
            return None;
        }
        let [own, theirs] = [self.flat, other.corners.map(|corner| self.flat_place(corner))];
        let turned = match self.normal.dot(other.normal) < 0.0 {
            true => [theirs[0], theirs[2], theirs[1]],
            false => theirs,
        };
        let common = clipped(CommonPolygon::from_slice(&turned), own);
        let least = OVERLAID_SHARE * double_area(&own).min(double_area(&turned));
        if common.len() < 3 || double_area(&common) <= least {
            return None;
        }
        let middle = common.iter().sum::<DVec2>() / common.len() as f64;
        let height = heights.iter().zip(weights(theirs, middle)).map(|(h, weight)| h * weight);
        if reach < height.sum::<f64>().abs() {
            return None;
        }
        let between = common.iter().map(|corner| corner.midpoint(middle));
        let places = [middle].into_iter().chain(between);
        let places = places.map(|at| [weights(own, at), weights(theirs, at)]).collect();
        Some(TriangleMeeting::Overlay { places })
    }
}

/// The weights of the corners of a triangle at a place.
fn weights([a, b, c]: [DVec2; 3], at: DVec2) -> [f64; 3] {
    let whole = (b - a).perp_dot(c - a);
    let (second, third) = ((at - a).perp_dot(c - a) / whole, (b - a).perp_dot(at - a) / whole);
    [1.0 - second - third, second, third]
}

/// The part of a convex polygon within a triangle, both counter-clockwise. Sutherland & Hodgman, "Reentrant polygon
/// clipping" (1974).
fn clipped(mut polygon: CommonPolygon, triangle: [DVec2; 3]) -> CommonPolygon {
    for (from, to) in [(0, 1), (1, 2), (2, 0)] {
        let (start, way) = (triangle[from], triangle[to] - triangle[from]);
        let side = |point: DVec2| way.perp_dot(point - start);
        let sides: SmallVec<[f64; 8]> = polygon.iter().map(|&point| side(point)).collect();
        if sides.iter().all(|&side| side <= 0.0) {
            return CommonPolygon::new();
        }
        if sides.iter().all(|&side| 0.0 <= side) {
            continue;
        }
        let mut kept = CommonPolygon::new();
        for (i, &point) in polygon.iter().enumerate() {
            let next = (i + 1) % polygon.len();
            if 0.0 <= sides[i] {
                kept.push(point);
            }
            if sides[i] * sides[next] < 0.0 {
                kept.push(point.lerp(polygon[next], sides[i] / (sides[i] - sides[next])));
            }
        }
        polygon = kept;
    }
    polygon
}

/// Twice the area of a convex polygon.
fn double_area(polygon: &[DVec2]) -> f64 {
    let fan = polygon.windows(2).skip(1);
    fan.map(|pair| (pair[0] - polygon[0]).perp_dot(pair[1] - polygon[0])).sum()
}
