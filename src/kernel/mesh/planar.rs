//! Meshes of plane regions within closed curves.
//!
//! Holes are joined to the outer border by bridges, and ears are cut off what remains.
//! Eberly, *Triangulation by ear clipping* (2002); O'Rourke, *Computational Geometry in C*, ch. 1.

use glam::{DVec2, DVec3};

use super::Mesh;
use crate::kernel::{
    Frame, GeomError, PictureError as Error,
    frame::{norm, unit},
};

/// A border as a polygon, in the plane.
struct Ring {
    places: Vec<DVec2>,
    /// The index of its first vertex.
    first: usize,
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
    let mut rings: Vec<Ring> = Vec::new();
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
        rings.push(Ring { places: points.iter().map(place).collect(), first });
    }
    check_crossings(&rings, &polygons)?;
    check_nesting(&rings)?;
    let places: Vec<DVec2> = rings.iter().flat_map(|ring| ring.places.iter().copied()).collect();
    let triangles = triangles(&places, joined(&rings, &places));
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

fn perimeter(points: &[DVec3]) -> f64 {
    points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// Twice the area of a triangle, positive where it runs counter-clockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// A side of a ring.
#[derive(Clone, Copy)]
struct Side {
    ring: usize,
    index: usize,
    ends: [DVec2; 2],
}

fn check_crossings(rings: &[Ring], polygons: &[Vec<DVec3>]) -> Result<(), GeomError> {
    let mut sides: Vec<Side> = Vec::new();
    for (ring, Ring { places, .. }) in rings.iter().enumerate() {
        let end = |i: usize| places[(i + 1) % places.len()];
        sides.extend((0..places.len()).map(|index| Side {
            ring,
            index,
            ends: [places[index], end(index)],
        }));
    }
    let left = |side: &Side| side.ends[0].x.min(side.ends[1].x);
    let right = |side: &Side| side.ends[0].x.max(side.ends[1].x);
    sides.sort_by(|a, b| left(a).total_cmp(&left(b)));
    let mut open: Vec<Side> = Vec::new();
    for side in sides {
        open.retain(|other| left(&side) <= right(other));
        for other in &open {
            let n = rings[side.ring].places.len();
            let is_next = |a: &Side, b: &Side| a.ring == b.ring && (a.index + 1) % n == b.index;
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
fn turns_back(side: &Side, next: &Side) -> bool {
    let [a, b] = side.ends;
    let [_, c] = next.ends;
    turn(a, b, c).abs() <= 0.0 && (b - a).dot(c - b) < 0.0
}

/// Whether two sides have a point in common.
fn cross(one: &Side, other: &Side) -> bool {
    let ([a, b], [c, d]) = (one.ends, other.ends);
    let is_apart = |i: usize| a[i].max(b[i]) < c[i].min(d[i]) || c[i].max(d[i]) < a[i].min(b[i]);
    let (on_c, on_d) = (turn(a, b, c), turn(a, b, d));
    let (on_a, on_b) = (turn(c, d, a), turn(c, d, b));
    let parts = |x: f64, y: f64| x <= 0.0 && 0.0 <= y || y <= 0.0 && 0.0 <= x;
    !is_apart(0) && !is_apart(1) && parts(on_c, on_d) && parts(on_a, on_b)
}

/// How far along a side another one crosses it.
fn share(side: &Side, other: &Side) -> f64 {
    let ([a, b], [c, d]) = (side.ends, other.ends);
    let (on_a, on_b) = (turn(c, d, a), turn(c, d, b));
    let share = on_a / (on_a - on_b);
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 }
}

/// Whether a place is inside a ring, by how often a ray to the right crosses it.
fn is_within(place: DVec2, ring: &Ring) -> bool {
    let n = ring.places.len();
    let crosses = |i: usize| {
        let (a, b) = (ring.places[i], ring.places[(i + 1) % n]);
        (a.y <= place.y) != (b.y <= place.y)
            && place.x < a.x + (b.x - a.x) * ((place.y - a.y) / (b.y - a.y))
    };
    (0..n).filter(|&i| crosses(i)).count() % 2 == 1
}

fn check_nesting(rings: &[Ring]) -> Result<(), GeomError> {
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

/// One polygon around the region, by vertices: the holes run the other way, each joined to what is to its
/// right by a bridge there and back.
fn joined(rings: &[Ring], places: &[DVec2]) -> Vec<usize> {
    let order = |ring: &Ring, is_left: bool| -> Vec<usize> {
        let n = ring.places.len();
        let area: f64 = (0..n).map(|i| ring.places[i].perp_dot(ring.places[(i + 1) % n])).sum();
        let around = (0..n).map(|i| ring.first + i);
        if (0.0 < area) == is_left { around.collect() } else { around.rev().collect() }
    };
    let mut polygon = order(&rings[0], true);
    let mut holes: Vec<Vec<usize>> = rings[1..].iter().map(|ring| order(ring, false)).collect();
    let rightmost = |hole: &[usize]| {
        (0..hole.len())
            .max_by(|&i, &k| places[hole[i]].x.total_cmp(&places[hole[k]].x))
            .unwrap_or(0)
    };
    holes.sort_by(|a, b| {
        let [x, y] = [a, b].map(|hole| places[hole[rightmost(hole)]].x);
        y.total_cmp(&x)
    });
    for mut hole in holes {
        let start = rightmost(&hole);
        hole.rotate_left(start);
        let at = bridge(&polygon, places, places[hole[0]]);
        let back = [hole[0], polygon[at]];
        let there = hole.into_iter().chain(back);
        polygon.splice(at + 1..at + 1, there.collect::<Vec<_>>());
    }
    polygon
}

/// The corner of a polygon that is seen from a place inside, to the right of it.
fn bridge(polygon: &[usize], places: &[DVec2], from: DVec2) -> usize {
    let n = polygon.len();
    let corner = |i: usize| places[polygon[i % n]];
    // The nearest side to the right, and its end that is further to the right.
    let mut nearest: Option<(f64, usize)> = None;
    for i in 0..n {
        let (a, b) = (corner(i), corner(i + 1));
        // The region is to the left of a side that rises on the right.
        if a.y <= from.y && from.y < b.y || a.y <= from.y && from.y <= b.y && a.y < b.y {
            let x = a.x + (b.x - a.x) * ((from.y - a.y) / (b.y - a.y));
            if from.x <= x && nearest.is_none_or(|(least, _)| x < least) {
                nearest = Some((x, if a.x < b.x { (i + 1) % n } else { i }));
            }
        }
    }
    let Some((x, end)) = nearest else { return 0 };
    // Corners within the triangle to that end may hide it: the one at the least angle is seen.
    let (hit, tip) = (DVec2::new(x, from.y), corner(end));
    let triangle = if tip.y < from.y { [from, tip, hit] } else { [from, hit, tip] };
    let slope = |p: DVec2| ((p.y - from.y).abs() / (p.x - from.x), p.x);
    let hides = |&i: &usize| {
        let (p, last, next) = (corner(i), corner(i + n - 1), corner(i + 1));
        from.x < p.x && p != tip && is_in(triangle, p) && turn(last, p, next) <= 0.0
    };
    let seen = (0..n).filter(hides).min_by(|&i, &k| {
        let (a, b) = (slope(corner(i)), slope(corner(k)));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    seen.unwrap_or(end)
}

fn is_in([a, b, c]: [DVec2; 3], p: DVec2) -> bool {
    0.0 <= turn(a, b, p) && 0.0 <= turn(b, c, p) && 0.0 <= turn(c, a, p)
}

/// Cuts ears off a polygon until nothing is left.
fn triangles(places: &[DVec2], mut polygon: Vec<usize>) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(polygon.len());
    let mut start = 0;
    while 3 <= polygon.len() {
        let n = polygon.len();
        let corners = |i: usize| [(i + n - 1) % n, i % n, (i + 1) % n].map(|k| polygon[k]);
        let size = |i: usize| {
            let [a, b, c] = corners(i).map(|k| places[k]);
            turn(a, b, c)
        };
        let is_ear = |i: &usize| {
            let [a, b, c] = corners(*i).map(|k| places[k]);
            let is_corner = |p: DVec2| p == a || p == b || p == c;
            0.0 < turn(a, b, c)
                && !polygon.iter().any(|&k| !is_corner(places[k]) && is_in([a, b, c], places[k]))
        };
        let ear = (start..start + n).map(|i| i % n).find(is_ear);
        // Without one rounding has the say: the fullest corner goes.
        let fullest = || (0..n).max_by(|&i, &k| size(i).total_cmp(&size(k)));
        let Some(at) = ear.or_else(fullest) else { break };
        if 0.0 < size(at) {
            triangles.push(corners(at).map(|k| k as u32));
        }
        polygon.remove(at);
        // Every other corner in turn, so that triangles do not all end in one.
        start = at + 1;
    }
    triangles
}
