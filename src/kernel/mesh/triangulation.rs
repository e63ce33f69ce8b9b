//! Triangles of a plane region: a constrained Delaunay triangulation of its borders.
//!
//! Among all triangulations with these corners that have the borders as sides its least angles are
//! largest. Its predicates are exact. Chew, *Constrained Delaunay triangulations*, Algorithmica 4
//! (1989); Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric
//! predicates*, DCG 18 (1997).

use std::collections::VecDeque;

use glam::DVec2;
use spade::{
    CdtEdge, ConstrainedDelaunayTriangulation, HasPosition, HierarchyHintGenerator,
    MIN_ALLOWED_VALUE, Point2, Triangulation as _,
    handles::{DirectedEdgeHandle, FixedVertexHandle},
};

use crate::work;

/// A border as a polygon, in the plane.
pub(super) struct BorderPolygon {
    pub(super) places: Vec<DVec2>,
    /// The index of its first vertex.
    pub(super) first: usize,
}

/// A region in triangles.
pub(super) struct RegionTriangles {
    /// Those behind an odd number of borders, in the order of their corners.
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each border how many others are around it.
    pub(super) n_around: Vec<usize>,
}

/// A vertex of the triangulation: where it is, and which of the mesh it is.
struct PlanarVertex {
    place: Point2<f64>,
    index: u32,
}

impl HasPosition for PlanarVertex {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        // The only thing of the triangulation's work that is seen from outside.
        work::count(1);
        self.place
    }
}

type Triangulation =
    ConstrainedDelaunayTriangulation<PlanarVertex, (), (), (), HierarchyHintGenerator<f64>>;

/// The triangles of a region; else the first vertex of a side that crosses or touches another one.
///
/// Vertices are put in one by one in an order that has nothing to do with their places, and so are
/// sides: each changes a few triangles in the mean wherever they lie; in an order by place, vertices on
/// a parabola change all. Guibas, Knuth & Sharir, *Randomized incremental construction of Delaunay and
/// Voronoi diagrams*, Algorithmica 7 (1992); Shewchuk & Brown, *Fast segment insertion and incremental
/// construction of constrained Delaunay triangulations*, Computational Geometry 48 (2015).
pub(super) fn triangles(rings: &[BorderPolygon]) -> Result<RegionTriangles, usize> {
    let ConstrainedNet { net, handles, ends, .. } = ConstrainedNet::of(rings, Repeated::Fault)?;
    let depths = depths(&net);
    let n_around = |ring: &BorderPolygon| {
        let [a, b] = [handles[ring.first], handles[ends[ring.first]]];
        a.zip(b).map_or(0, |(a, b)| n_around(&net, &depths, [a, b]))
    };
    let n_around = rings.iter().map(n_around).collect();
    Ok(RegionTriangles { triangles: inner_triangles(&net, &depths), n_around })
}

/// The triangles of a region with vertices inside: given ones, and such as lie in the middle of triangles
/// that are not fine, until all are or `most` vertices or `n_rounds` rounds are reached. The places of the
/// vertices inside come behind those of the borders. Where borders come to a place more than once they touch.
/// Pairs of vertices inside are sides of borders more, which close.
///
/// # Errors
/// The first vertex of a side that crosses or touches another one.
pub(super) fn triangles_with(
    rings: &[BorderPolygon],
    (mut inside, sides): (Vec<DVec2>, &[[usize; 2]]),
    is_fine: impl Fn([DVec2; 3]) -> bool,
    [n_rounds, most]: [usize; 2],
) -> Result<(Vec<[u32; 3]>, Vec<DVec2>), usize> {
    let mut all = ConstrainedNet::of(rings, Repeated::OneVertex)?;
    let border: Vec<DVec2> = rings.iter().flat_map(|ring| ring.places.iter().copied()).collect();
    let n_border = border.len();
    all.insert_with_sides(&inside, n_border, sides).map_err(|vertex| vertex % n_border.max(1))?;
    let mut n_known = inside.len();
    for round in 0.. {
        for i in mixed(inside.len() - n_known) {
            let index = n_known + i;
            all.insert(inside[index], n_border + index);
        }
        n_known = inside.len();
        let depths = depths(&all.net);
        let triangles = inner_triangles(&all.net, &depths);
        if n_rounds <= round || most < n_border + n_known {
            return Ok((triangles, inside));
        }
        let place = |i: u32| match (i as usize).checked_sub(n_border) {
            Some(i) => inside[i],
            None => border[i as usize],
        };
        let coarse: Vec<DVec2> = triangles
            .iter()
            .map(|corners| corners.map(place))
            .filter(|corners| work::goes_on(1) && !is_fine(*corners))
            .map(|[a, b, c]| (a + b + c) / 3.0)
            .collect();
        if coarse.is_empty() {
            return Ok((triangles, inside));
        }
        inside.extend(coarse);
    }
    unreachable!("rounds end")
}

/// What a place is to which borders come more than once.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Repeated {
    Fault,
    OneVertex,
}

/// What became of a vertex of a triangulation.
enum InsertedVertex {
    New(FixedVertexHandle),
    /// There was one at its place, which is it now.
    Known(FixedVertexHandle),
    /// Its coordinates are no numbers.
    NoPlace,
}

/// A triangulation with the sides of polygons in it.
struct ConstrainedNet {
    net: Triangulation,
    /// For each vertex of the polygons its own; for each where its side ends.
    handles: Vec<Option<FixedVertexHandle>>,
    ends: Vec<usize>,
    /// The power of two by which places are multiplied, so that nothing is rounded.
    exponent: i32,
}

impl ConstrainedNet {
    fn of(rings: &[BorderPolygon], repeated: Repeated) -> Result<Self, usize> {
        let places: Vec<DVec2> =
            rings.iter().flat_map(|ring| ring.places.iter().copied()).collect();
        let size = places.iter().map(|place| place.abs().max_element()).fold(0.0, f64::max);
        let (_, exponent) = libm::frexp(size);
        let ends = |ring: &BorderPolygon| {
            let (n, first) = (ring.places.len(), ring.first);
            (0..n).map(move |i| first + (i + 1) % n)
        };
        let ends: Vec<usize> = rings.iter().flat_map(ends).collect();
        let handles = vec![None; places.len()];
        let mut all = Self { net: Triangulation::new(), handles, ends, exponent: -exponent };
        for index in mixed(places.len()) {
            let vertex = match all.insert(places[index], index) {
                InsertedVertex::New(vertex) => Some(vertex),
                InsertedVertex::Known(vertex) if repeated == Repeated::OneVertex => Some(vertex),
                _ => None,
            };
            all.handles[index] = Some(vertex.ok_or(index)?);
        }
        for from in mixed(all.ends.len()) {
            let (Some(a), Some(b)) = (all.handles[from], all.handles[all.ends[from]]) else {
                return Err(from);
            };
            if all.net.exists_constraint(a, b) || !all.net.can_add_constraint(a, b) {
                return Err(from);
            }
            all.net.add_constraint(a, b);
            // It would be in pieces where a vertex lies on it.
            if !all.net.exists_constraint(a, b) {
                return Err(from);
            }
        }
        Ok(all)
    }

    /// Inserts vertices, numbered from the first on, and sides between them.
    ///
    /// # Errors
    /// The first vertex of a side that crosses or touches another one.
    fn insert_with_sides(
        &mut self,
        places: &[DVec2],
        first: usize,
        sides: &[[usize; 2]],
    ) -> Result<(), usize> {
        let mut handles = vec![None; places.len()];
        for i in mixed(places.len()) {
            if let InsertedVertex::New(vertex) = self.insert(places[i], first + i) {
                handles[i] = Some(vertex);
            }
        }
        for i in mixed(sides.len()) {
            let [from, to] = sides[i];
            let (Some(a), Some(b)) = (handles[from], handles[to]) else { return Err(first + from) };
            if !self.net.can_add_constraint(a, b) {
                return Err(first + from);
            }
            self.net.add_constraint(a, b);
            if !self.net.exists_constraint(a, b) {
                return Err(first + from);
            }
        }
        Ok(())
    }

    /// The vertex at a place.
    fn insert(&mut self, place: DVec2, index: usize) -> InsertedVertex {
        // Numbers so small are no places to the triangulation.
        let number = |x: f64| match libm::ldexp(x, self.exponent) {
            x if x.abs() < MIN_ALLOWED_VALUE => 0.0,
            x => x,
        };
        let place = Point2::new(number(place.x), number(place.y));
        let n_before = self.net.num_vertices();
        match self.net.insert(PlanarVertex { place, index: index as u32 }) {
            Ok(vertex) if n_before < self.net.num_vertices() => InsertedVertex::New(vertex),
            Ok(vertex) => InsertedVertex::Known(vertex),
            Err(_) => InsertedVertex::NoPlace,
        }
    }
}

/// The numbers below `n` in an order that looks random, the same on every run: a shuffle (Fisher &
/// Yates) by the generator of Steele, Lea & Flood, *Fast splittable pseudorandom number generators*,
/// OOPSLA 2014.
fn mixed(n: usize) -> Vec<usize> {
    let mut state = 0_u64;
    let mut below = |most: usize| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) % most as u64) as usize
    };
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        order.swap(i, below(i + 1));
    }
    order
}

/// For each face how many borders are around it: the fewest that any way from the outside crosses.
fn depths(net: &Triangulation) -> Vec<usize> {
    let mut depths: Vec<Option<usize>> = vec![None; net.num_all_faces()];
    // Edges before the faces behind them, those of least depth first.
    let mut todo = VecDeque::new();
    for edge in net.convex_hull() {
        enter(&mut todo, edge.rev(), 0);
    }
    while let Some((edge, depth)) = todo.pop_front() {
        let known = &mut depths[edge.face().fix().index()];
        if edge.is_outer_edge() || known.is_some() {
            continue;
        }
        *known = Some(depth);
        enter(&mut todo, edge.prev().rev(), depth);
        enter(&mut todo, edge.next().rev(), depth);
    }
    depths.into_iter().map(Option::unwrap_or_default).collect()
}

type NetEdge<'a> = DirectedEdgeHandle<'a, PlanarVertex, (), CdtEdge<()>, ()>;

/// Notes the face behind an edge, which is reached from a depth.
fn enter<'a>(todo: &mut VecDeque<(NetEdge<'a>, usize)>, edge: NetEdge<'a>, depth: usize) {
    if edge.is_constraint_edge() {
        todo.push_back((edge, depth + 1));
    } else {
        todo.push_front((edge, depth));
    }
}

/// How many borders are around the one that has a side between two vertices.
fn n_around(net: &Triangulation, depths: &[usize], [a, b]: [FixedVertexHandle; 2]) -> usize {
    let depth = |edge: NetEdge<'_>| match edge.is_outer_edge() {
        true => 0,
        false => depths[edge.face().fix().index()],
    };
    net.get_edge_from_neighbors(a, b).map_or(0, |edge| depth(edge).min(depth(edge.rev())))
}

/// The triangles that are inside, in the order of their corners.
fn inner_triangles(net: &Triangulation, depths: &[usize]) -> Vec<[u32; 3]> {
    let in_order = |[a, b, c]: [u32; 3]| match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    };
    let inside = net.inner_faces().filter(|face| depths[face.fix().index()] % 2 == 1);
    let mut triangles: Vec<[u32; 3]> =
        inside.map(|face| in_order(face.vertices().map(|vertex| vertex.data().index))).collect();
    triangles.sort_unstable();
    triangles
}
