//! How often pieces of curves cross a half-line along an axis.
//!
//! Of pieces all ahead of its start only the sides of their ends count, the others are halved: no crossing is solved for.

use glam::DVec3;

use crate::{
    Bounds, NurbsCurve,
    curve::part::{CurvePart, parts},
    homogeneous,
    tolerance::LAST_BIT,
};

/// Halvings of a piece in search of the side on which it passes a place.
pub(super) const HALVINGS: usize = 60;

/// Last bits of its coordinates within which a piece is at a place.
const NEAR_ROUNDINGS: f64 = 16.0;

/// A half-line along an axis.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    pub(super) start: DVec3,
    /// 0 for x, 1 for y.
    pub(super) axis: usize,
}

impl Ray {
    /// Whether it does not come to a box, other than along its border.
    pub(super) fn misses(self, Bounds { min, max }: Bounds) -> bool {
        self.misses_between([min.x, min.y], [max.x, max.y])
    }

    /// The same of the corners of a box in the plane.
    pub(super) fn misses_between(self, low: [f64; 2], high: [f64; 2]) -> bool {
        let (along, across) = (self.axis, 1 - self.axis);
        high[along] < self.start[along]
            || high[across] <= self.start[across]
            || self.start[across] < low[across]
    }

    /// How often a piece from end to end crosses it from right to left, less how often from left to
    /// right; none where the piece is at its start.
    pub(super) fn crossings(
        self,
        part: &CurvePart,
        ends: [DVec3; 2],
        n_halvings: usize,
    ) -> Option<i32> {
        let bounds = part.bounds.with(ends[0]).with(ends[1]);
        if self.misses(bounds) {
            return Some(0);
        }
        let (along, across) = (self.axis, 1 - self.axis);
        if self.start[along] < bounds.min[along] {
            let is_beyond = |point: DVec3| i32::from(self.start[across] < point[across]);
            let up = is_beyond(ends[1]) - is_beyond(ends[0]);
            return Some(if along == 0 { up } else { -up });
        }
        if n_halvings == 0 || bounds.diagonal() <= NEAR_ROUNDINGS * LAST_BIT * bounds.magnitude() {
            return None;
        }
        let halves = part.halves();
        let middle = homogeneous::project(halves[1].points[0]);
        let before = self.crossings(&halves[0], [ends[0], middle], n_halvings - 1)?;
        Some(before + self.crossings(&halves[1], [middle, ends[1]], n_halvings - 1)?)
    }
}

/// The Bézier pieces of a curve from one place to another, and their boxes.
pub(super) fn pieces_of(
    curve: &NurbsCurve,
    ends: [DVec3; 2],
) -> Vec<(CurvePart, [DVec3; 2], Bounds)> {
    let parts = parts(curve);
    let first = |part: &CurvePart| homogeneous::project(part.points[0]);
    let starts: Vec<DVec3> = parts
        .iter()
        .enumerate()
        .map(|(i, part)| if i == 0 { ends[0] } else { first(part) })
        .collect();
    let made = parts.into_iter().enumerate().map(|(i, part)| {
        let own = [starts[i], starts.get(i + 1).copied().unwrap_or(ends[1])];
        let bounds = part.bounds.with(own[0]).with(own[1]);
        (part, own, bounds)
    });
    made.collect()
}

/// How often closed chains of arcs go around a place; none where one of them is there.
pub(crate) fn winding_about<'c>(
    chains: impl Iterator<Item = &'c [NurbsCurve]>,
    place: DVec3,
) -> Option<i32> {
    let ray = Ray { start: place, axis: 0 };
    let mut sum = 0;
    for arcs in chains {
        for (i, arc) in arcs.iter().enumerate() {
            // The start of the next is the end of this one.
            let ends = [arc.start(), arcs[(i + 1) % arcs.len()].start()];
            let around = arc.bounds().with(ends[0]).with(ends[1]);
            let margin = NEAR_ROUNDINGS * LAST_BIT * around.magnitude();
            if ray.misses(Bounds { min: around.min - margin, max: around.max + margin }) {
                continue;
            }
            for (part, ends, _) in pieces_of(arc, ends) {
                sum += ray.crossings(&part, ends, HALVINGS)?;
            }
        }
    }
    Some(sum)
}
