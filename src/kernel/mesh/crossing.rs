//! Where a mesh goes through itself.

use std::collections::HashMap;

use glam::DVec3;

use super::{Mesh, nearest::MeshDistance};
use crate::{Bounds, GeomError, frame::unit};

impl Mesh {
    /// A place where more than two triangles have an edge in common, or where an edge goes through a triangle with
    /// which it has no corner in common, and both of its ends are deeper than `depth` on either side of the
    /// triangle's plane.
    ///
    /// # Errors
    /// `GeomError::Ended`.
    pub(crate) fn crossing(&self, depth: f64) -> Result<Option<DVec3>, GeomError> {
        if let Some(place) = self.crowded_edge() {
            return Ok(Some(place));
        }
        let Some(tree) = MeshDistance::new(self) else { return Ok(None) };
        for triangle in 0..self.n_triangles() as u32 {
            GeomError::go_on(1)?;
            let [a, b, c] = self.corners_of(triangle);
            for edge in [[a, b], [b, c], [c, a]] {
                let Some(around) = Bounds::of(edge) else { continue };
                let mut found = None;
                tree.each_near(around, |other| {
                    let corners = self.corners_of(other);
                    found = found.or_else(|| pierced(edge, corners, depth));
                });
                if found.is_some() {
                    return Ok(found);
                }
            }
        }
        Ok(None)
    }

    /// The middle of an edge, by the places of its ends, that more than two triangles have.
    fn crowded_edge(&self) -> Option<DVec3> {
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

/// Where an edge goes through a triangle.
fn pierced([p, q]: [DVec3; 2], corners: [DVec3; 3], depth: f64) -> Option<DVec3> {
    if corners.contains(&p) || corners.contains(&q) {
        return None;
    }
    let [a, b, c] = corners;
    let normal = unit((b - a).cross(c - a))?;
    let [before, behind] = [p, q].map(|end| normal.dot(end - a));
    if before.abs().min(behind.abs()) <= depth || 0.0 < before * behind {
        return None;
    }
    let point = p.lerp(q, before / (before - behind));
    let is_left = |[from, to]: [DVec3; 2]| 0.0 <= normal.dot((to - from).cross(point - from));
    [[a, b], [b, c], [c, a]].into_iter().all(is_left).then_some(point)
}
