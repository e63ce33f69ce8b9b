//! Closed triangles without slivers and folds.
//!
//! Where faces coincide but for rounding, a boolean leaves triangles whose three corners are on one line, and sheets
//! without thickness, of which front and back are triangles of their own. To leave a sliver out would tear the mesh:
//! its longest side is flipped instead, so that the triangle beyond gets the corner between. Along the rim of a sheet
//! two triangles lie on one another. Their common part goes, by a flip where one holds the tip of the other and
//! otherwise by a vertex where their sides cross, and with it the rim moves inward until the sheet is gone. Each step
//! leaves the boundary of all triangles as it is, which is none.

use std::collections::HashMap;

use glam::DVec3;

use crate::{ceiling::FLATTENING_STEPS, tolerance::FOLD_SINE, work};

/// Triangles in the making.
struct FlattenedNet {
    vertices: Vec<DVec3>,
    /// A length that is rounding.
    rounding: f64,
    triangles: Vec<Option<[u32; 3]>>,
    /// The triangles that run along a side, by its ends.
    along: HashMap<[u32; 2], Vec<u32>>,
    /// Triangles that are new.
    todo: Vec<u32>,
}

/// Two triangles that lie on one another beside a side: the ends of that, and the third corners.
#[derive(Clone, Copy)]
struct OverlappingPair {
    triangles: [u32; 2],
    ends: [u32; 2],
    tips: [u32; 2],
}

/// Closed triangles, with the vertices behind the given ones that they need, without what has no thickness; none
/// where a side has no neighbour, or where that takes too many steps.
pub(super) fn flattened(
    vertices: Vec<DVec3>,
    triangles: &[[u32; 3]],
    rounding: f64,
) -> Option<(Vec<DVec3>, Vec<[u32; 3]>)> {
    let along = HashMap::with_capacity(3 * triangles.len());
    let mut net =
        FlattenedNet { vertices, rounding, triangles: Vec::new(), along, todo: Vec::new() };
    triangles.iter().for_each(|&corners| net.add(corners));
    let mut n_steps = FLATTENING_STEPS * triangles.len();
    while let Some(triangle) = net.todo.pop() {
        let Some(corners) = net.triangles[triangle as usize] else { continue };
        let is_changed = if net.is_sliver(corners) {
            net.flip_sliver(triangle, corners)?;
            true
        } else if let Some(fold) = net.fold_of(triangle, corners) {
            net.unfold(fold)?;
            true
        } else {
            false
        };
        if is_changed {
            n_steps = n_steps.checked_sub(1).filter(|_| work::goes_on(1))?;
        }
    }
    Some((net.vertices, net.triangles.into_iter().flatten().collect()))
}

impl FlattenedNet {
    fn place(&self, vertex: u32) -> DVec3 {
        self.vertices[vertex as usize]
    }

    /// Adds a triangle, unless it is the back of another one, which then goes too.
    fn add(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            return;
        }
        let is_back =
            |&&other: &&u32| self.triangles[other as usize].is_some_and(|of| of.contains(&c));
        let back = self.along.get(&[b, a]).and_then(|backs| backs.iter().rev().find(is_back));
        if let Some(&back) = back {
            self.remove(back);
            return;
        }
        let number = self.triangles.len() as u32;
        self.triangles.push(Some(corners));
        for side in sides(corners) {
            self.along.entry(side).or_default().push(number);
        }
        self.todo.push(number);
    }

    /// Takes a triangle away; what was beside it has new neighbours.
    fn remove(&mut self, triangle: u32) {
        let Some(corners) = self.triangles[triangle as usize].take() else { return };
        for [a, b] in sides(corners) {
            if let Some(there) = self.along.get_mut(&[a, b]) {
                there.retain(|&other| other != triangle);
            }
            self.todo.extend(self.along.get(&[b, a]).into_iter().flatten());
        }
    }

    /// A triangle that runs against a side, with its third corner.
    fn beyond(&self, [a, b]: [u32; 2]) -> Option<(u32, u32)> {
        let triangle = *self.along.get(&[b, a])?.last()?;
        Some((triangle, self.tip(triangle, [a, b])?))
    }

    /// The corner of a triangle that is no end of a side.
    fn tip(&self, triangle: u32, [a, b]: [u32; 2]) -> Option<u32> {
        let corners = self.triangles[triangle as usize]?;
        corners.into_iter().find(|&corner| corner != a && corner != b)
    }

    fn is_sliver(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.place(corner));
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        (b - a).cross(c - a).length() <= self.rounding * longest
    }

    /// Takes a sliver away: what is beyond its longest side gets the corner between.
    fn flip_sliver(&mut self, sliver: u32, corners: [u32; 3]) -> Option<()> {
        let length = |[a, b]: [u32; 2]| self.place(a).distance(self.place(b));
        let [a, b] = sides(corners)
            .into_iter()
            .reduce(|one, other| if length(one) < length(other) { other } else { one })?;
        let middle = self.tip(sliver, [a, b])?;
        let (beyond, apex) = self.beyond([a, b])?;
        self.remove(sliver);
        self.remove(beyond);
        if apex != middle {
            self.add([b, middle, apex]);
            self.add([middle, a, apex]);
        }
        Some(())
    }

    /// A triangle that lies on this one beside one of its sides.
    fn fold_of(&self, triangle: u32, corners: [u32; 3]) -> Option<OverlappingPair> {
        sides(corners).into_iter().find_map(|[a, b]| {
            let tip = self.tip(triangle, [a, b])?;
            let others = self.along.get(&[b, a])?;
            others.iter().find_map(|&other| {
                let tips = [tip, self.tip(other, [a, b])?];
                let fold = OverlappingPair { triangles: [triangle, other], ends: [a, b], tips };
                self.is_flat(fold).then_some(fold)
            })
        })
    }

    /// Whether two triangles at a side are in one plane, on the same side of it.
    fn is_flat(&self, OverlappingPair { ends, tips, .. }: OverlappingPair) -> bool {
        let [a, b] = ends.map(|end| self.place(end));
        let [c, d] = tips.map(|tip| self.place(tip));
        let [one, other] = [c, d].map(|tip| (b - a).cross(tip - a));
        // The plane is that of the larger one.
        let (normal, tip) = if other.length() < one.length() { (one, d) } else { (other, c) };
        let least = one.length().min(other.length()) / (b - a).length();
        let height = (tip - a).dot(normal) / normal.length();
        0.0 < one.dot(other) && height.abs() <= self.rounding.min(FOLD_SINE * least)
    }

    /// Takes away what two triangles have in common.
    fn unfold(
        &mut self,
        OverlappingPair { triangles, ends: [a, b], tips: [c, d] }: OverlappingPair,
    ) -> Option<()> {
        let [from, to, one, other] = [a, b, c, d].map(|corner| self.place(corner));
        let [normal, other_normal] = [one, other].map(|tip| (to - from).cross(tip - from));
        let normal = if normal.length() < other_normal.length() { other_normal } else { normal };
        // How far a place is to the left of a line, seen from the first triangle's front.
        let left = |place: DVec3, [start, end]: [DVec3; 2]| {
            let along = end - start;
            normal.dot(along.cross(place - start)) / (normal.length() * along.length())
        };
        let is_within = |place: DVec3, lines: [[DVec3; 2]; 2]| {
            lines.iter().all(|&line| -self.rounding <= left(place, line))
        };
        let of_one = [[to, one], [one, from]];
        let of_other = [[to, other], [other, from]];
        if is_within(one, of_other) || is_within(other, of_one) {
            triangles.iter().for_each(|&triangle| self.remove(triangle));
            self.add([a, d, c]);
            self.add([d, b, c]);
            return Some(());
        }

        // Put a vertex where the side of one crosses that of the other, and divide what is beyond these.
        let crosses_at_start = left(one, of_other[1]) < 0.0;
        let [side, across] = if crosses_at_start { [[b, c], [a, d]] } else { [[c, a], [d, b]] };
        let (beyond, apex) = self.beyond(side)?;
        let (beyond_other, other_apex) = self.beyond(across)?;
        let [start, end] = side.map(|corner| self.place(corner));
        let line = across.map(|corner| self.place(corner));
        let [before, behind] = [left(start, line), left(end, line)];
        let crossing = start + (end - start) * (before / (before - behind));
        let x = self.vertices.len() as u32;
        self.vertices.push(crossing);
        for triangle in [triangles[0], triangles[1], beyond, beyond_other] {
            self.remove(triangle);
        }
        self.add([side[1], x, apex]);
        self.add([x, side[0], apex]);
        self.add([across[1], x, other_apex]);
        self.add([x, across[0], other_apex]);
        if crosses_at_start {
            self.add([a, x, c]);
            self.add([b, x, d]);
        } else {
            self.add([x, b, c]);
            self.add([x, a, d]);
        }
        Some(())
    }
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::flattened;

    fn places(places: &[(f64, f64)]) -> Vec<DVec3> {
        places.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
    }

    #[test]
    fn a_corner_between_two_others_divides_the_triangle_beyond() {
        let mut vertices = places(&[(0.0, 0.0), (4.0, 0.0), (2.0, 3.0), (2.0, 3.0), (1.0, 1e-14)]);
        vertices[3].z = -4.0;
        // A tetrahedron with a sliver at the edge between two of its sides.
        let triangles = [[0, 1, 2], [1, 0, 4], [0, 3, 4], [4, 3, 1], [2, 1, 3], [0, 2, 3]];
        let (_, mut found) = flattened(vertices, &triangles, 1e-12).unwrap();
        // Each from its least corner on.
        for [a, b, c] in &mut found {
            while *b < *a || *c < *a {
                (*a, *b, *c) = (*b, *c, *a);
            }
        }
        found.sort_unstable();
        assert_eq!(found, [[0, 2, 3], [0, 3, 4], [0, 4, 2], [1, 2, 4], [1, 3, 2], [1, 4, 3]]);
    }

    #[test]
    fn a_sheet_whose_sides_are_divided_otherwise_goes() {
        let rim = places(&[(0.0, 0.0), (4.0, -1.0), (5.0, 3.0), (2.0, 5.0), (-1.0, 3.0)]);
        let front = [[0, 1, 2], [0, 2, 3], [0, 3, 4]];
        for start in 0..5 {
            let back = [[0, 2, 1], [0, 3, 2], [0, 4, 3]]
                .map(|corners| corners.map(|corner| (corner + start) % 5));
            let all = [front, back].concat();
            let (_, left) = flattened(rim.clone(), &all, 1e-12).unwrap();
            assert!(left.is_empty(), "{left:?}");
        }
    }
}
