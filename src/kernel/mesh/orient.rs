//! Which triangles of closed shells must turn so that they face outward.
//!
//! Vertices at one place, to the last bit, count as one: surfaces side by side share them. Triangles
//! with a common edge that no third has hang together, and face alike if they run along it against
//! one another. Parts that close so are turned outward by the sign of the volume that they enclose,
//! the sum of the tetrahedra under their triangles. Mirtich, *Fast and accurate computation of
//! polyhedral mass properties*, JGT 1 (1996).

use std::collections::HashMap;

use glam::DVec3;

use super::{Mesh, numbered_places::numbered};
use crate::{Bounds, tolerance::VANISHING_RELATIVE};

/// A side of a triangle, from the lesser of its places.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
struct OrientedSide {
    greater: u32,
    triangle: u32,
    is_forward: bool,
}

/// The sides of triangles, one lesser place after the other, those of each sorted; `starts` has the
/// first of each, and the end.
struct SidesByPlace {
    starts: Vec<usize>,
    sides: Vec<OrientedSide>,
}

/// Triangles in sets, each with whether it faces another way than the first of its set.
struct TriangleSets {
    parents: Vec<(u32, bool)>,
}

/// A closed part.
struct ClosedShell {
    bounds: Bounds,
    /// Six times the volume that it encloses if it faces as its first triangle, and the sum of what
    /// that was added up from.
    volume: [f64; 2],
    /// Whether its triangles do not all face alike.
    is_mixed: bool,
}

/// The closed parts, and which of them each triangle that stands for one has.
struct ClosedShells {
    all: Vec<ClosedShell>,
    /// One more than the number of the shell; zero where there is none.
    by_root: Vec<u32>,
}

/// For each triangle of each mesh, whether it must turn so that closed shells face outward; several
/// meshes may make one shell.
///
/// What is not closed or has one side only stays as it is, and so does a cavity: a shell that faces
/// inward as a whole, in the box of another one.
#[must_use]
pub fn facing_inward(meshes: &[&Mesh]) -> Vec<Vec<bool>> {
    let (places, triangles) = gathered(meshes);
    let sides = SidesByPlace::of(&triangles, places.len());
    let mut parts =
        TriangleSets { parents: (0..triangles.len() as u32).map(|i| (i, false)).collect() };
    for edge in sides.edges() {
        if let [a, b] = edge {
            parts.unite(a.triangle, b.triangle, a.is_forward == b.is_forward);
        }
    }
    let found: Vec<(u32, bool)> =
        (0..triangles.len() as u32).map(|triangle| parts.root(triangle)).collect();
    let shells = shells(&places, &triangles, &found, &open(&sides, &found));
    let turns = |shell: &ClosedShell| {
        let [volume, added] = shell.volume;
        let is_inward = volume < -VANISHING_RELATIVE * added;
        let is_cavity = || shells.all.iter().any(|other| is_inside(shell.bounds, other.bounds));
        is_inward && (shell.is_mixed || !is_cavity())
    };
    let turned: Vec<bool> = shells.all.iter().map(turns).collect();
    let mut all = found
        .iter()
        .map(|&(root, differs)| shells.of(root).is_some_and(|shell| turned[shell] != differs));
    meshes.iter().map(|mesh| all.by_ref().take(mesh.n_triangles()).collect()).collect()
}

impl Mesh {
    /// The same with some of its triangles turned over, and the normals there with them. Where not all
    /// triangles of a face turn, each is a face.
    #[must_use]
    pub fn with_turned(&self, turns: &[bool]) -> Self {
        let mut is_kept = vec![false; self.n_vertices()];
        let triangles = || self.triangles.iter().zip(turns);
        for (corners, _) in triangles().filter(|(_, turns)| !**turns) {
            corners.iter().for_each(|&corner| is_kept[corner as usize] = true);
        }
        let mut turned = self.clone();
        // Where a vertex has a normal and triangles of both kinds, there are two of it.
        let mut other: HashMap<u32, u32> = HashMap::new();
        for (idx, (&[a, b, c], _)) in triangles().enumerate().filter(|(_, (_, turns))| **turns) {
            turned.triangles[idx] = [a, c, b].map(|corner| {
                let i = corner as usize;
                if self.normals.is_empty() {
                    return corner;
                }
                *other.entry(corner).or_insert_with(|| {
                    if !is_kept[i] {
                        turned.normals[i] = -self.normals[i];
                        return corner;
                    }
                    turned.vertices.push(self.vertices[i]);
                    turned.normals.push(-self.normals[i]);
                    turned.uvs.extend(self.uvs.get(i));
                    turned.colors.extend(self.colors.get(i));
                    turned.vertices.len() as u32 - 1
                })
            });
        }
        if !self.face_sizes.is_empty() {
            turned.face_sizes = self.sizes_when_turned(turns);
        }
        turned
    }

    fn sizes_when_turned(&self, turns: &[bool]) -> Vec<u32> {
        let (mut sizes, mut first) = (Vec::with_capacity(self.face_sizes.len()), 0);
        for &size in &self.face_sizes {
            let run = &turns[first..first + size as usize];
            first += run.len();
            if run.windows(2).all(|pair| pair[0] == pair[1]) {
                sizes.push(size);
            } else {
                sizes.resize(sizes.len() + run.len(), 1);
            }
        }
        sizes
    }
}

/// The places of all vertices, and the triangles of all meshes over these.
fn gathered(meshes: &[&Mesh]) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut places = Vec::with_capacity(meshes.iter().map(|mesh| mesh.n_vertices()).sum());
    meshes.iter().for_each(|mesh| places.extend_from_slice(mesh.vertices()));
    let (places, numbers) = numbered(places);
    let mut triangles = Vec::with_capacity(meshes.iter().map(|mesh| mesh.n_triangles()).sum());
    let mut before = 0;
    for mesh in meshes {
        let numbers = &numbers[before..];
        let of_places = |corners: &[u32; 3]| corners.map(|corner| numbers[corner as usize]);
        triangles.extend(mesh.triangles().iter().map(of_places));
        before += mesh.n_vertices();
    }
    (places, triangles)
}

impl SidesByPlace {
    /// Of the triangles that have three places.
    fn of(triangles: &[[u32; 3]], n_places: usize) -> Self {
        let have_three = |&(_, &[a, b, c]): &(usize, &[u32; 3])| a != b && b != c && c != a;
        let all = || {
            triangles.iter().enumerate().filter(have_three).flat_map(|(triangle, &[a, b, c])| {
                [[a, b], [b, c], [c, a]].map(|[a, b]| {
                    let triangle = triangle as u32;
                    let side = OrientedSide { greater: a.max(b), triangle, is_forward: a < b };
                    (a.min(b) as usize, side)
                })
            })
        };
        let mut starts = vec![0; n_places + 1];
        all().for_each(|(lesser, _)| starts[lesser + 1] += 1);
        for place in 0..n_places {
            starts[place + 1] += starts[place];
        }
        let mut sides = vec![OrientedSide::default(); starts[n_places]];
        let mut next = starts.clone();
        for (lesser, side) in all() {
            sides[next[lesser]] = side;
            next[lesser] += 1;
        }
        starts.windows(2).for_each(|ends| sides[ends[0]..ends[1]].sort_unstable());
        Self { starts, sides }
    }

    /// The sides of each edge, in the order of the edges' places.
    fn edges(&self) -> impl Iterator<Item = &[OrientedSide]> {
        let of_place = |ends: &[usize]| &self.sides[ends[0]..ends[1]];
        let starts = self.starts.windows(2).map(of_place);
        starts.flat_map(|sides| sides.chunk_by(|a, b| a.greater == b.greater))
    }
}

/// For each triangle that stands for a part, whether that has an end somewhere, or one side only.
fn open(sides: &SidesByPlace, found: &[(u32, bool)]) -> Vec<bool> {
    let mut is_open = vec![false; found.len()];
    let passing = |side: &OrientedSide| {
        let (root, differs) = found[side.triangle as usize];
        (root, side.is_forward != differs)
    };
    for edge in sides.edges() {
        if let [a, b] = edge {
            // They are of one part.
            let ((root, way), (_, other)) = (passing(a), passing(b));
            is_open[root as usize] |= way == other;
            continue;
        }
        let mut passing: Vec<(u32, bool)> = edge.iter().map(passing).collect();
        passing.sort_unstable();
        for part in passing.chunk_by(|a, b| a.0 == b.0) {
            let n_forward = part.iter().filter(|(_, is_forward)| *is_forward).count();
            is_open[part[0].0 as usize] |= 2 * n_forward != part.len();
        }
    }
    is_open
}

impl ClosedShells {
    /// The number of the shell for which a triangle stands.
    fn of(&self, root: u32) -> Option<usize> {
        (self.by_root[root as usize] as usize).checked_sub(1)
    }
}

/// The closed parts.
fn shells(
    places: &[DVec3],
    triangles: &[[u32; 3]],
    found: &[(u32, bool)],
    is_open: &[bool],
) -> ClosedShells {
    let mut shells = ClosedShells { all: Vec::new(), by_root: vec![0; triangles.len()] };
    let Some(whole) = Bounds::of(places.iter().copied()) else { return shells };
    let size = whole.diagonal();
    for (corners, &(root, differs)) in triangles.iter().zip(found) {
        if is_open[root as usize] {
            continue;
        }
        // About a corner of the part, which cancels least, and of size one, which cannot overflow.
        let about = places[triangles[root as usize][0] as usize];
        let corners = corners.map(|corner| places[corner as usize]);
        let [a, b, c] = corners.map(|corner| (corner - about) / size);
        let term = a.dot(b.cross(c));
        let bounds = Bounds::of(corners).unwrap_or(Bounds { min: about, max: about });
        let number = shells.of(root).unwrap_or_else(|| {
            shells.all.push(ClosedShell { bounds, volume: [0.0; 2], is_mixed: false });
            shells.by_root[root as usize] = shells.all.len() as u32;
            shells.all.len() - 1
        });
        let shell = &mut shells.all[number];
        shell.bounds = shell.bounds.union(bounds);
        shell.volume[0] += if differs { -term } else { term };
        shell.volume[1] += term.abs();
        shell.is_mixed |= differs;
    }
    shells
}

/// Whether a box is inside of another one.
fn is_inside(inner: Bounds, outer: Bounds) -> bool {
    outer.min.cmplt(inner.min).all() && inner.max.cmplt(outer.max).all()
}

impl TriangleSets {
    /// The triangle that stands for the part of another one, and whether that faces another way;
    /// makes the way there short.
    fn root(&mut self, triangle: u32) -> (u32, bool) {
        let (mut at, mut differs) = (triangle, false);
        while self.parents[at as usize].0 != at {
            let (above, turns) = self.parents[at as usize];
            let (further, turns_further) = self.parents[above as usize];
            // What stands for itself does not differ from itself.
            self.parents[at as usize] = (further, turns ^ turns_further);
            differs ^= turns ^ turns_further;
            at = further;
        }
        (at, differs)
    }

    /// Joins the parts of two triangles.
    fn unite(&mut self, a: u32, b: u32, differ: bool) {
        let ((a, turns_a), (b, turns_b)) = (self.root(a), self.root(b));
        if a != b {
            self.parents[a.max(b) as usize] = (a.min(b), turns_a ^ turns_b ^ differ);
        }
    }
}
