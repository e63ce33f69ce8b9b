//! How the triangles of a mesh hang together.
//!
//! Vertices at one place count as one. Each triangle has three sides, directed as it is; sides
//! between the same two places are an edge. Around a vertex, the corners of triangles that share an
//! edge there are one fan, and in a manifold there is one fan at each vertex.

use glam::{DAffine3, DVec3};

use super::{Mesh, weld::welded};
use crate::{
    Bounds, Tolerance,
    scale::needed_scale,
    tolerance::{LAST_BIT, VANISHING_RELATIVE},
};

/// Triangles over places, with their edges.
///
/// A square of two triangles has one boundary, of four edges:
///
/// ```
/// use virote_kernel::{Tolerance, glam::DVec3, polygon_mesh};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let square = polygon_mesh(vec![o, x, x + y, y], &[vec![0, 1, 2, 3]], 4)?;
/// let topology = square.topology(Tolerance::DEFAULT);
/// assert_eq!(topology.boundary().len(), 4);
/// assert_eq!(topology.boundary_lines().len(), 1);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Topology {
    /// Of each triangle that has three places its corners, welded.
    triangles: Vec<[u32; 3]>,
    /// How many others there are: corners at one place, or on one line.
    n_degenerate: usize,
    /// How many places the triangles have.
    n_vertices: usize,
    /// Sides, sorted by their edge.
    sides: Vec<TriangleSide>,
    /// Where the sides of each edge begin, and the end.
    edges: Vec<u32>,
    /// Sides without a neighbour, as they are directed.
    boundary: Vec<[u32; 2]>,
    /// The fan of each corner: corner k of triangle t at 3t + k.
    fans: Vec<u32>,
    /// The side of each of `boundary`.
    boundary_sides: Vec<u32>,
}

/// A side of a triangle under its edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct TriangleSide {
    edge: [u32; 2],
    /// Three times the triangle, and the corner that it begins at.
    number: u32,
}

/// What [`Mesh::check`] finds.
///
/// Euler's formula: V − E + F is 2 of what has no hole, here 4 − 6 + 4.
///
/// ```
/// use virote_kernel::{Tolerance, glam::DVec3, polygon_mesh};
///
/// let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
/// let found = polygon_mesh(vertices, &faces, 4)?.check(Tolerance::DEFAULT);
/// assert!(found.is_closed && found.is_manifold && found.is_oriented);
/// assert_eq!((found.euler, found.boundaries, found.components), (2, 0, 1));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshCheck {
    /// Every edge has two triangles or more.
    pub is_closed: bool,
    /// No edge has more than two, and around each vertex they are one fan.
    pub is_manifold: bool,
    /// Neighbours face alike.
    pub is_oriented: bool,
    /// Triangles without area.
    pub degenerate: usize,
    /// V − E + F.
    pub euler: i64,
    /// Loops of edges with one triangle.
    pub boundaries: usize,
    /// Parts that share no vertex.
    pub components: usize,
    /// Places, edges, triangles with area.
    pub counts: [usize; 3],
}

impl Mesh {
    /// How its triangles hang together; vertices within the tolerance are one.
    #[must_use]
    pub fn topology(&self, tolerance: Tolerance) -> Topology {
        let bounds = self.bounds();
        if let Some(scale) = needed_scale(bounds.map_or(0.0, Bounds::magnitude)) {
            let plain = self.transformed(&DAffine3::from_scale(DVec3::splat(scale.recip())));
            return plain.topology(tolerance.with_distance(tolerance.distance / scale));
        }
        let magnitude = bounds.map_or(0.0, Bounds::magnitude);
        let first = welded(&self.vertices, weld_distance(bounds, tolerance));
        let rounding = VANISHING_RELATIVE * magnitude;
        let has_area = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|i| self.vertices[i as usize]);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let [x, y, z] = corners;
            x != y && y != z && z != x && rounding * longest < (b - a).cross(c - a).length()
        };
        let welded = self.triangles.iter().map(|corners| corners.map(|i| first[i as usize]));
        Topology::new(welded.filter(has_area).collect(), self.n_triangles(), self.n_vertices())
    }

    /// Whether it is closed, manifold and oriented, and its Euler number.
    #[must_use]
    pub fn check(&self, tolerance: Tolerance) -> MeshCheck {
        self.topology(tolerance).check()
    }
}

/// Up to which distance vertices in a box are one.
pub(super) fn weld_distance(bounds: Option<Bounds>, tolerance: Tolerance) -> f64 {
    let size = bounds.map_or(0.0, Bounds::diagonal);
    let magnitude = bounds.map_or(0.0, Bounds::magnitude);
    tolerance.distance_for(size).max(4.0 * LAST_BIT * magnitude)
}

impl Topology {
    fn new(triangles: Vec<[u32; 3]>, n_all: usize, n_places: usize) -> Self {
        let mut sides: Vec<TriangleSide> = Vec::with_capacity(3 * triangles.len());
        for (t, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                sides.push(TriangleSide { edge: [a.min(b), a.max(b)], number: (3 * t + k) as u32 });
            }
        }
        sides.sort_unstable();
        let mut edges: Vec<u32> = Vec::with_capacity(sides.len() / 2 + 1);
        for (i, side) in sides.iter().enumerate() {
            if i == 0 || sides[i - 1].edge != side.edge {
                edges.push(i as u32);
            }
        }
        edges.push(sides.len() as u32);
        let mut is_used = vec![false; n_places];
        triangles.iter().flatten().for_each(|&corner| is_used[corner as usize] = true);
        let mut topology = Self {
            n_degenerate: n_all - triangles.len(),
            n_vertices: is_used.into_iter().filter(|used| *used).count(),
            fans: Vec::new(),
            boundary: Vec::new(),
            boundary_sides: Vec::new(),
            triangles,
            sides,
            edges,
        };
        topology.fans = topology.find_fans();
        let alone = topology.each_edge().filter(|sides| sides.len() == 1);
        topology.boundary_sides = alone.map(|sides| sides[0].number).collect();
        let directed = topology.boundary_sides.iter().map(|&number| topology.ends(number));
        topology.boundary = directed.collect();
        topology
    }

    /// The sides of each edge.
    fn each_edge(&self) -> impl Iterator<Item = &[TriangleSide]> {
        self.edges.windows(2).map(|ends| &self.sides[ends[0] as usize..ends[1] as usize])
    }

    /// Each edge with its triangles.
    pub(super) fn edges_with_triangles(&self) -> impl Iterator<Item = ([u32; 2], Vec<&[u32; 3]>)> {
        let triangle = |side: &TriangleSide| &self.triangles[side.number as usize / 3];
        self.each_edge().map(move |sides| (sides[0].edge, sides.iter().map(triangle).collect()))
    }

    /// From where to where a side goes.
    fn ends(&self, number: u32) -> [u32; 2] {
        let corners = self.triangles[number as usize / 3];
        let k = number as usize % 3;
        [corners[k], corners[(k + 1) % 3]]
    }

    /// The corner of a side's triangle that is at one of its ends, numbered as fans are.
    fn corner_at(&self, number: u32, vertex: u32) -> u32 {
        if self.ends(number)[0] == vertex { number } else { next_corner(number) }
    }

    fn find_fans(&self) -> Vec<u32> {
        let mut fans: Vec<u32> = (0..3 * self.triangles.len() as u32).collect();
        for sides in self.each_edge() {
            if let [one, other] = sides {
                for vertex in one.edge {
                    let corners = [one, other].map(|side| self.corner_at(side.number, vertex));
                    unite(&mut fans, corners);
                }
            }
        }
        (0..fans.len() as u32).map(|corner| root(&mut fans, corner)).collect()
    }

    /// The sides that have no neighbour, from where to where their triangles run along them.
    #[must_use]
    pub fn boundary(&self) -> &[[u32; 2]] {
        &self.boundary
    }

    /// An edge whose triangles do not face alike.
    #[must_use]
    pub fn turned_edge(&self) -> Option<[u32; 2]> {
        self.each_edge().find_map(|sides| {
            let forward = sides.iter().filter(|side| self.ends(side.number) == side.edge).count();
            (2 * forward != sides.len() && 1 < sides.len()).then(|| sides[0].edge)
        })
    }

    /// A vertex around which the triangles are not one fan, or from which an edge of more than two goes.
    #[must_use]
    pub fn pinched_vertex(&self) -> Option<u32> {
        if let Some(sides) = self.each_edge().find(|sides| 2 < sides.len()) {
            return Some(sides[0].edge[0]);
        }
        let mut fan_at = std::collections::HashMap::new();
        let corners = self.triangles.iter().flatten().zip(&self.fans);
        corners.into_iter().find_map(|(&vertex, &fan)| {
            (*fan_at.entry(vertex).or_insert(fan) != fan).then_some(vertex)
        })
    }

    /// The triangles that have three places, welded.
    pub(super) fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The boundary as lines of vertices, where triangles face alike with the mesh to their left. A
    /// line ends in the vertex that it began with, unless it runs from where more than two triangles
    /// have a side to another such place. Two that touch in a vertex are two.
    #[must_use]
    pub fn boundary_lines(&self) -> Vec<Vec<u32>> {
        // Each side of the boundary under both of its fans.
        let fan_at = |side: usize, vertex: u32| {
            self.fans[self.corner_at(self.boundary_sides[side], vertex) as usize]
        };
        let n = self.boundary.len();
        let mut by_fan: Vec<(u32, u32)> = Vec::with_capacity(2 * n);
        for (side, ends) in self.boundary.iter().enumerate() {
            by_fan.extend(ends.map(|vertex| (fan_at(side, vertex), side as u32)));
        }
        by_fan.sort_unstable();
        let beside = |side: usize, vertex: u32| {
            let fan = fan_at(side, vertex);
            let first = by_fan.partition_point(|&(other, _)| other < fan);
            let all = by_fan[first..].iter().take_while(move |&&(other, _)| other == fan);
            all.map(|&(_, side)| side as usize).filter(move |&other| other != side)
        };
        let is_end =
            |&(side, end): &(usize, usize)| beside(side, self.boundary[side][end]).next().is_none();
        let starts = [0, 1].map(|end| (0..n).map(move |side| (side, end)).filter(is_end));
        let anywhere = (0..n).map(|side| (side, 0));

        let mut is_done = vec![false; n];
        let mut lines = Vec::new();
        for (start, end) in starts.into_iter().flatten().chain(anywhere) {
            if is_done[start] {
                continue;
            }
            let mut from = self.boundary[start][end];
            let (mut next, mut vertices) = (Some(start), vec![from]);
            while let Some(side) = next {
                is_done[side] = true;
                let [a, b] = self.boundary[side];
                from = if a == from { b } else { a };
                vertices.push(from);
                next = beside(side, from).find(|&other| !is_done[other]);
            }
            lines.push(vertices);
        }
        lines
    }

    /// Whether it is closed, manifold and oriented, and its Euler number.
    #[must_use]
    pub fn check(&self) -> MeshCheck {
        let (n_edges, n_triangles) = (self.edges.len() - 1, self.triangles.len());
        let counts = [self.n_vertices, n_edges, n_triangles];
        MeshCheck {
            is_closed: self.boundary.is_empty(),
            is_manifold: self.each_edge().all(|sides| sides.len() <= 2) && self.has_one_fan_each(),
            is_oriented: self.turned_edge().is_none(),
            degenerate: self.n_degenerate,
            euler: self.n_vertices as i64 - n_edges as i64 + n_triangles as i64,
            boundaries: self.boundary_lines().len(),
            components: self.n_components(),
            counts,
        }
    }

    fn has_one_fan_each(&self) -> bool {
        let is_root = |corner: &usize| self.fans[*corner] == *corner as u32;
        (0..self.fans.len()).filter(is_root).count() == self.n_vertices
    }

    /// For each vertex the one that stands for the part that it belongs to.
    pub(super) fn parts(&self) -> Vec<u32> {
        let n = self.triangles.iter().flatten().max().map_or(0, |&most| most + 1);
        let mut parts: Vec<u32> = (0..n).collect();
        for &[a, b, c] in &self.triangles {
            unite(&mut parts, [a, b]);
            unite(&mut parts, [b, c]);
        }
        (0..n).map(|vertex| root(&mut parts, vertex)).collect()
    }

    fn n_components(&self) -> usize {
        let parts = self.parts();
        let mut is_root = vec![false; parts.len()];
        for &corner in self.triangles.iter().flatten() {
            is_root[parts[corner as usize] as usize] = true;
        }
        is_root.into_iter().filter(|is_root| *is_root).count()
    }
}

fn next_corner(number: u32) -> u32 {
    if number % 3 == 2 { number - 2 } else { number + 1 }
}

/// The one that stands for the set of an element; halves the way there.
fn root(parents: &mut [u32], mut element: u32) -> u32 {
    while parents[element as usize] != element {
        let above = parents[parents[element as usize] as usize];
        parents[element as usize] = above;
        element = above;
    }
    element
}

/// Makes one set of those of two elements; the lesser root stands for it.
fn unite(parents: &mut [u32], elements: [u32; 2]) {
    let [a, b] = elements.map(|element| root(parents, element));
    parents[a.max(b) as usize] = a.min(b);
}
