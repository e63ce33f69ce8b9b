//! Plane sections of meshes.

use std::collections::BTreeMap;

use glam::DVec3;

use super::Mesh;
use crate::{Frame, GeomError, NurbsCurve};

/// An edge by the bits of its corners, which are the same for both of its triangles.
type EdgeKey = [[u64; 3]; 2];

/// A stretch across a triangle, with the edges that it starts and ends on.
struct TriangleCut {
    keys: [EdgeKey; 2],
    points: [DVec3; 2],
}

impl Mesh {
    /// The polylines in which a plane cuts the triangles; to their left, seen from the side of the
    /// normals, the mesh is above the plane.
    ///
    /// What lies in the plane counts as above it, so that a face in the plane is told by the border
    /// towards what is below.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::polyline`].
    pub fn section(&self, plane: Frame) -> Result<Vec<NurbsCurve>, GeomError> {
        let stretches: Vec<TriangleCut> =
            self.corners().filter_map(|corners| stretch(corners, plane)).collect();
        let lines = chained(&stretches).into_iter().filter(|line| 1 < line.len());
        lines.map(|line| NurbsCurve::polyline(&line)).collect()
    }
}

fn stretch(corners: [DVec3; 3], plane: Frame) -> Option<TriangleCut> {
    let heights = corners.map(|corner| (corner - plane.origin()).dot(plane.z()));
    let is_above = heights.map(|height| 0.0 <= height);
    let falling = (0..3).find(|&i| is_above[i] && !is_above[(i + 1) % 3])?;
    let rising = (0..3).find(|&i| !is_above[i] && is_above[(i + 1) % 3])?;
    let cut = |i: usize| {
        let k = (i + 1) % 3;
        let key = |i: usize| corners[i].to_array().map(f64::to_bits);
        let (i, k) = if key(i) <= key(k) { (i, k) } else { (k, i) };
        let fraction = heights[i] / (heights[i] - heights[k]);
        ([key(i), key(k)], corners[i].lerp(corners[k], fraction))
    };
    let ((start_key, start), (end_key, end)) = (cut(falling), cut(rising));
    Some(TriangleCut { keys: [start_key, end_key], points: [start, end] })
}

/// The stretches one behind the other: first the lines with ends, then the closed ones.
fn chained(stretches: &[TriangleCut]) -> Vec<Vec<DVec3>> {
    let mut from: BTreeMap<EdgeKey, Vec<usize>> = BTreeMap::new();
    let mut n_ends: BTreeMap<EdgeKey, usize> = BTreeMap::new();
    for (i, stretch) in stretches.iter().enumerate().rev() {
        from.entry(stretch.keys[0]).or_default().push(i);
        *n_ends.entry(stretch.keys[1]).or_default() += 1;
    }
    let begins = |i: &usize| !n_ends.contains_key(&stretches[*i].keys[0]);
    let order: Vec<usize> = (0..stretches.len()).filter(begins).chain(0..stretches.len()).collect();
    let mut is_done = vec![false; stretches.len()];
    let mut lines = Vec::new();
    for first in order {
        if is_done[first] {
            continue;
        }
        let mut line = vec![stretches[first].points[0]];
        let mut next = Some(first);
        while let Some(i) = next {
            is_done[i] = true;
            let [_, end] = stretches[i].points;
            if line.last() != Some(&end) {
                line.push(end);
            }
            let behind = from.get_mut(&stretches[i].keys[1]);
            next = behind.and_then(|all| {
                while let Some(i) = all.pop() {
                    if !is_done[i] {
                        return Some(i);
                    }
                }
                None
            });
        }
        lines.push(line);
    }
    lines
}
