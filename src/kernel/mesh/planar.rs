//! Meshes of plane regions within closed curves: `triangulation` finds the triangles.

use glam::{DVec2, DVec3};

use super::{
    Mesh,
    triangulation::{BorderPolygon, RegionTriangles, triangles},
};
use crate::{
    Frame, GeomError, PictureError as Error,
    frame::{norm, unit},
};

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
    GeomError::go_on(rings.iter().map(|ring| ring.places.len()).sum())?;
    let RegionTriangles { triangles, n_around } =
        triangles(&rings).map_err(|side| crossing(&rings, &polygons, side))?;
    check_nesting(&rings, &n_around)?;
    let vertices: Vec<DVec3> = polygons.into_iter().flatten().collect();
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

/// With the side from the last point to the first.
fn perimeter(points: &[DVec3]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(point, next)| point.distance(*next)).sum()
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

/// Where the side from a vertex, which meets another one, does so.
fn crossing(rings: &[BorderPolygon], polygons: &[Vec<DVec3>], vertex: usize) -> Error {
    let side = |ring: usize, index: usize| {
        let places = &rings[ring].places;
        PolygonSide { ring, index, ends: [places[index], places[(index + 1) % places.len()]] }
    };
    let ring = rings.iter().rposition(|ring| ring.first <= vertex).unwrap_or(0);
    let own = side(ring, vertex - rings[ring].first);
    let n = rings[ring].places.len();
    let is_next =
        |a: &PolygonSide, b: &PolygonSide| a.ring == b.ring && (a.index + 1) % n == b.index;
    let meets = |other: &PolygonSide| {
        if is_next(&own, other) {
            turns_back(&own, other)
        } else if is_next(other, &own) {
            turns_back(other, &own)
        } else {
            (other.ring, other.index) != (own.ring, own.index) && cross(&own, other)
        }
    };
    let sides = |ring: usize| (0..rings[ring].places.len()).map(move |index| side(ring, index));
    let other = (0..rings.len()).flat_map(sides).find(meets);
    let points = &polygons[ring];
    let end = points[(own.index + 1) % points.len()];
    let (from, of) = (points[own.index], rings.len());
    match other {
        Some(other) => Error::Crossing {
            index: ring.min(other.ring),
            other: ring.max(other.ring),
            of,
            point: from.lerp(end, share(&own, &other)),
        },
        None => Error::Crossing { index: ring, other: ring, of, point: from },
    }
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

/// # Errors
/// [`Error::Outside`], [`Error::HoleInHole`].
fn check_nesting(rings: &[BorderPolygon], n_around: &[usize]) -> Result<(), GeomError> {
    let Some(index) = (1..rings.len()).find(|&index| n_around[index] != 1) else { return Ok(()) };
    let place = rings[index].places[0];
    let is_around = |&other: &usize| other != index && is_within(place, &rings[other]);
    match (1..rings.len()).find(is_around) {
        Some(other) if 1 < n_around[index] => Err(Error::HoleInHole { index, other }.into()),
        _ => Err(Error::Outside { index }.into()),
    }
}
