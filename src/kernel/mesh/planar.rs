//! Meshes of plane regions within closed curves.
//!
//! A constrained Delaunay triangulation of the borders: among all triangulations with these corners
//! that have the borders as sides its least angles are largest. Its predicates are exact.
//! Chew, *Constrained Delaunay triangulations*, Algorithmica 4 (1989); Shewchuk, *Adaptive precision
//! floating-point arithmetic and fast robust geometric predicates*, DCG 18 (1997).

use glam::{DVec2, DVec3};
use spade::{
    ConstrainedDelaunayTriangulation, HasPosition, MIN_ALLOWED_VALUE, Point2, Triangulation as _,
};

use super::Mesh;
use crate::{
    Frame, GeomError, PictureError as Error,
    frame::{norm, unit},
};

/// A border as a polygon, in the plane.
pub(super) struct BorderPolygon {
    pub(super) places: Vec<DVec2>,
    /// The index of its first vertex.
    pub(super) first: usize,
}

/// The mesh of the region within the first of the polygons and outside of the others, whose last
/// points are followed by their first; the first runs counter-clockwise seen from the side of the
/// normals. Every triangle has its corners on the borders.
///
/// # Errors
/// [`Error::NoArea`], [`Error::OffPlane`] beyond `distance`, [`Error::Crossing`],
/// [`Error::Outside`], [`Error::HoleInHole`].
pub fn planar_mesh(polygons: &[Vec<DVec3>], distance: f64) -> Result<Mesh, GeomError> {
    let of = polygons.len();
    let polygons: Vec<Vec<DVec3>> = polygons.iter().map(|points| without_repeats(points)).collect();
    let Some(outer) = polygons.first() else { return Ok(Mesh::default()) };
    let normal = unit(area_vector(outer))
        .filter(|_| distance * perimeter(outer) < 2.0 * norm(area_vector(outer)));
    let normal = normal.ok_or(Error::NoArea { index: 0, of })?;
    let center = outer.iter().copied().sum::<DVec3>() / outer.len() as f64;
    let frame = Frame::from_normal(center, normal, None)?;
    let mut rings: Vec<BorderPolygon> = Vec::new();
    for (index, points) in polygons.iter().enumerate() {
        let by = points.iter().map(|&p| (p - center).dot(normal).abs()).fold(0.0, f64::max);
        if distance < by {
            return Err(Error::OffPlane { index, of, by }.into());
        }
        if points.len() < 3 {
            return Err(Error::NoArea { index, of }.into());
        }
        let place =
            |&p: &DVec3| DVec2::new((p - center).dot(frame.x()), (p - center).dot(frame.y()));
        let first = rings.last().map_or(0, |ring| ring.first + ring.places.len());
        rings.push(BorderPolygon { places: points.iter().map(place).collect(), first });
    }
    check_crossings(&rings, &polygons)?;
    check_nesting(&rings)?;
    let vertices: Vec<DVec3> = polygons.into_iter().flatten().collect();
    let triangles = triangles(&rings).map_err(|vertex| {
        let index = rings.iter().rposition(|ring| ring.first <= vertex).unwrap_or(0);
        Error::Crossing { index, other: index, of, point: vertices[vertex] }
    })?;
    let normals = vec![frame.z(); vertices.len()];
    Mesh::new(vertices, normals, Vec::new(), triangles)
}

fn without_repeats(points: &[DVec3]) -> Vec<DVec3> {
    let mut points = points.to_vec();
    points.dedup();
    while 1 < points.len() && points.first() == points.last() {
        points.pop();
    }
    points
}

/// The normal of a polygon, as long as the area is large (Newell).
fn area_vector(points: &[DVec3]) -> DVec3 {
    let Some(&about) = points.first() else { return DVec3::ZERO };
    let pairs = points.windows(2).map(|pair| (pair[0] - about).cross(pair[1] - about));
    0.5 * pairs.sum::<DVec3>()
}

fn perimeter(points: &[DVec3]) -> f64 {
    points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// Twice the area of a triangle, positive where it runs counter-clockwise.
pub(super) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// A side of a ring.
#[derive(Clone, Copy)]
struct PolygonSide {
    ring: usize,
    index: usize,
    ends: [DVec2; 2],
}

/// # Errors
/// [`Error::Crossing`].
pub(super) fn check_crossings(
    rings: &[BorderPolygon],
    polygons: &[Vec<DVec3>],
) -> Result<(), GeomError> {
    let mut sides: Vec<PolygonSide> = Vec::new();
    for (ring, BorderPolygon { places, .. }) in rings.iter().enumerate() {
        let end = |i: usize| places[(i + 1) % places.len()];
        sides.extend((0..places.len()).map(|index| PolygonSide {
            ring,
            index,
            ends: [places[index], end(index)],
        }));
    }
    let left = |side: &PolygonSide| side.ends[0].x.min(side.ends[1].x);
    let right = |side: &PolygonSide| side.ends[0].x.max(side.ends[1].x);
    sides.sort_by(|a, b| left(a).total_cmp(&left(b)));
    let mut open: Vec<PolygonSide> = Vec::new();
    for side in sides {
        open.retain(|other| left(&side) <= right(other));
        for other in &open {
            let n = rings[side.ring].places.len();
            let is_next =
                |a: &PolygonSide, b: &PolygonSide| a.ring == b.ring && (a.index + 1) % n == b.index;
            let meets = if is_next(&side, other) {
                turns_back(&side, other)
            } else if is_next(other, &side) {
                turns_back(other, &side)
            } else {
                cross(&side, other)
            };
            if meets {
                let (index, other_index) = (side.ring.min(other.ring), side.ring.max(other.ring));
                let points = &polygons[side.ring];
                let end = points[(side.index + 1) % points.len()];
                let point = points[side.index].lerp(end, share(&side, other));
                let of = rings.len();
                return Err(Error::Crossing { index, other: other_index, of, point }.into());
            }
        }
        open.push(side);
    }
    Ok(())
}

/// Whether a side runs back along the one before it.
fn turns_back(side: &PolygonSide, next: &PolygonSide) -> bool {
    let [a, b] = side.ends;
    let [_, c] = next.ends;
    turn(a, b, c).abs() <= 0.0 && (b - a).dot(c - b) < 0.0
}

/// Whether two sides have a point in common.
fn cross(one: &PolygonSide, other: &PolygonSide) -> bool {
    let ([a, b], [c, d]) = (one.ends, other.ends);
    let is_apart = |i: usize| a[i].max(b[i]) < c[i].min(d[i]) || c[i].max(d[i]) < a[i].min(b[i]);
    let (on_c, on_d) = (turn(a, b, c), turn(a, b, d));
    let (on_a, on_b) = (turn(c, d, a), turn(c, d, b));
    let parts = |x: f64, y: f64| x <= 0.0 && 0.0 <= y || y <= 0.0 && 0.0 <= x;
    !is_apart(0) && !is_apart(1) && parts(on_c, on_d) && parts(on_a, on_b)
}

/// How far along a side another one crosses it.
fn share(side: &PolygonSide, other: &PolygonSide) -> f64 {
    let ([a, b], [c, d]) = (side.ends, other.ends);
    let (on_a, on_b) = (turn(c, d, a), turn(c, d, b));
    let share = on_a / (on_a - on_b);
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 }
}

/// Whether a place is inside a ring, by how often a ray to the right crosses it.
fn is_within(place: DVec2, ring: &BorderPolygon) -> bool {
    let n = ring.places.len();
    let crosses = |i: usize| {
        let (a, b) = (ring.places[i], ring.places[(i + 1) % n]);
        (a.y <= place.y) != (b.y <= place.y)
            && place.x < a.x + (b.x - a.x) * ((place.y - a.y) / (b.y - a.y))
    };
    (0..n).filter(|&i| crosses(i)).count() % 2 == 1
}

fn check_nesting(rings: &[BorderPolygon]) -> Result<(), GeomError> {
    for (index, hole) in rings.iter().enumerate().skip(1) {
        if !is_within(hole.places[0], &rings[0]) {
            return Err(Error::Outside { index }.into());
        }
        let others = rings.iter().enumerate().skip(1);
        let around =
            others.filter(|(i, _)| *i != index).find(|(_, other)| is_within(hole.places[0], other));
        if let Some((other, _)) = around {
            return Err(Error::HoleInHole { index, other }.into());
        }
    }
    Ok(())
}

/// A vertex of the triangulation: where it is, and which of the mesh it is.
struct PlanarVertex {
    place: Point2<f64>,
    index: u32,
}

impl HasPosition for PlanarVertex {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.place
    }
}

type Triangulation = ConstrainedDelaunayTriangulation<PlanarVertex>;

/// The triangles of the region, no least angle of which could be larger with the same corners; else a
/// vertex at which sides cross by rounding.
pub(super) fn triangles(rings: &[BorderPolygon]) -> Result<Vec<[u32; 3]>, usize> {
    let places = || rings.iter().flat_map(|ring| ring.places.iter());
    let size = places().map(|place| place.abs().max_element()).fold(0.0, f64::max);
    // Numbers so small are no places to the triangulation.
    let number = |x: f64| if x.abs() < MIN_ALLOWED_VALUE { 0.0 } else { x };
    let corner = |(index, place): (usize, &DVec2)| {
        let DVec2 { x, y } = *place / size;
        PlanarVertex { place: Point2::new(number(x), number(y)), index: index as u32 }
    };
    let side =
        |ring: &BorderPolygon, i: usize| [i, (i + 1) % ring.places.len()].map(|i| ring.first + i);
    let sides = rings.iter().flat_map(|ring| (0..ring.places.len()).map(move |i| side(ring, i)));
    let mut crossed: Option<usize> = None;
    let loaded = Triangulation::try_bulk_load_cdt(
        places().enumerate().map(corner).collect(),
        sides.collect(),
        |conflict| crossed = crossed.or(Some(conflict[0])),
    );
    match (loaded, crossed) {
        (Ok(net), None) => Ok(inner_triangles(&net)),
        (Ok(net), Some(at)) => {
            let vertex = net.vertices().nth(at);
            Err(vertex.map_or(0, |vertex| vertex.data().index as usize))
        }
        (Err(_), _) => Err(0),
    }
}

/// The triangles that are inside: those behind an odd number of sides.
fn inner_triangles(net: &Triangulation) -> Vec<[u32; 3]> {
    let mut is_inside: Vec<Option<bool>> = vec![None; net.num_all_faces()];
    let mut todo: Vec<_> = net.convex_hull().map(|edge| (edge.rev(), false)).collect();
    while let Some((edge, is_before_inside)) = todo.pop() {
        let known = &mut is_inside[edge.face().fix().index()];
        if edge.is_outer_edge() || known.is_some() {
            continue;
        }
        let is_here = is_before_inside != edge.is_constraint_edge();
        *known = Some(is_here);
        todo.extend([edge.prev(), edge.next()].map(|other| (other.rev(), is_here)));
    }
    net.inner_faces()
        .filter(|face| is_inside[face.fix().index()] == Some(true))
        .map(|face| face.vertices().map(|vertex| vertex.data().index))
        .collect()
}
