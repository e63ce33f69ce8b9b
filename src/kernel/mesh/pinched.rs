//! Borders of parts of surfaces as polygons that come to one another: where a part is thinner than the distance
//! within which places are one, both of its sides have the same vertices there.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::{Mesh, arc_places::BorderVertex};
use crate::{Bounds, box_tree::BoxTree};

/// A vertex by the bits of its coordinates and parameters.
type VertexBits = [u64; 5];

fn point_bits(point: DVec3) -> [u64; 3] {
    point.to_array().map(f64::to_bits)
}

fn bits(BorderVertex { parameters, point }: &BorderVertex) -> VertexBits {
    let [x, y, z] = point_bits(*point);
    [x, y, z, parameters.x.to_bits(), parameters.y.to_bits()]
}

/// Gives vertices at one point one place of parameters, where `is_one` holds of two: no seam is between these.
///
/// Vertices along an edge that is a point, neighbours of which are no further apart than `weld`, keep theirs.
pub(super) fn with_common_places(
    loops: &mut [Vec<BorderVertex>],
    weld: f64,
    is_one: impl Fn([DVec2; 2], DVec3) -> bool,
) {
    let mut known: BTreeMap<[u64; 3], Vec<DVec2>> = BTreeMap::new();
    for polygon in loops {
        let points: Vec<DVec3> = polygon.iter().map(|vertex| vertex.point).collect();
        let n = points.len();
        for (i, vertex) in polygon.iter_mut().enumerate() {
            let beside = [points[(i + 1) % n], points[(i + n - 1) % n]];
            if beside.iter().any(|next| points[i].distance(*next) <= weld) {
                continue;
            }
            let own = vertex.parameters;
            let places = known.entry(point_bits(points[i])).or_default();
            match places.iter().find(|&&place| is_one([place, own], vertex.point)) {
                Some(&place) => vertex.parameters = place,
                None => places.push(own),
            }
        }
    }
}

/// Polygons without the legs that are gone along once in each sense, none of which comes to a vertex twice.
pub(super) fn without_folds(loops: Vec<Vec<BorderVertex>>) -> Vec<Vec<BorderVertex>> {
    let mut numbers: BTreeMap<VertexBits, usize> = BTreeMap::new();
    let mut vertices: Vec<BorderVertex> = Vec::new();
    let mut legs: Vec<[usize; 2]> = Vec::new();
    for polygon in &loops {
        let mut number = |vertex: &BorderVertex| {
            *numbers.entry(bits(vertex)).or_insert_with(|| {
                vertices.push(*vertex);
                vertices.len() - 1
            })
        };
        let of_polygon: Vec<usize> = polygon.iter().map(&mut number).collect();
        let n = of_polygon.len();
        legs.extend((0..n).map(|i| [of_polygon[i], of_polygon[(i + 1) % n]]));
    }
    if vertices.len() == legs.len() {
        return loops;
    }
    let mut is_left: Vec<bool> = vec![true; legs.len()];
    let mut open: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
    for (i, &[from, to]) in legs.iter().enumerate() {
        let back = open.get_mut(&[to, from]).and_then(Vec::pop);
        match back {
            Some(back) => [i, back].iter().for_each(|&leg| is_left[leg] = false),
            None if from == to => is_left[i] = false,
            None => open.entry([from, to]).or_default().push(i),
        }
    }
    let mut exits: Vec<Vec<usize>> = vec![Vec::new(); vertices.len()];
    for (&[from, to], _) in legs.iter().zip(&is_left).filter(|(_, is_left)| **is_left).rev() {
        exits[from].push(to);
    }
    let mut rings = Vec::new();
    let mut place_on_way: Vec<Option<usize>> = vec![None; vertices.len()];
    for start in 0..vertices.len() {
        let mut way = vec![start];
        place_on_way[start] = Some(0);
        while let Some(next) = way.last().and_then(|&at| exits[at].pop()) {
            if let Some(first) = place_on_way[next] {
                let ring = way.split_off(first);
                ring.iter().for_each(|&vertex| place_on_way[vertex] = None);
                rings.push(ring.into_iter().map(|vertex| vertices[vertex]).collect());
            }
            place_on_way[next] = Some(way.len());
            way.push(next);
        }
        way.iter().for_each(|&vertex| place_on_way[vertex] = None);
    }
    rings
}

/// Takes away triangles of neighbouring meshes that lie on one another, with the same corners and facing apart: where
/// borders of both run along one another, and vertices on them hardly leave a line. `width` is what such triangles
/// are narrower than.
pub(crate) fn drop_opposite_triangles(meshes: &mut [Mesh], width: f64) {
    let mut of_corners: BTreeMap<[[u64; 3]; 3], Vec<(usize, usize, bool)>> = BTreeMap::new();
    for (number, mesh) in meshes.iter().enumerate() {
        for (triangle, corners) in mesh.corners().enumerate() {
            if width <= height(corners) {
                continue;
            }
            let mut keys = corners.map(point_bits);
            // Whether the sorted corners are in the sense of the triangle.
            let is_even = [(0, 1), (1, 2), (0, 2)]
                .iter()
                .filter(|&&(i, k)| keys[k] < keys[i])
                .count()
                .is_multiple_of(2);
            keys.sort_unstable();
            of_corners.entry(keys).or_default().push((number, triangle, is_even));
        }
    }
    let mut dropped: Vec<Vec<usize>> = vec![Vec::new(); meshes.len()];
    for found in of_corners.into_values() {
        let (even, odd): (Vec<_>, Vec<_>) = found.into_iter().partition(|&(.., is_even)| is_even);
        for (one, other) in even.into_iter().zip(odd) {
            [one, other].iter().for_each(|&(number, triangle, _)| dropped[number].push(triangle));
        }
    }
    for (mesh, mut dropped) in meshes.iter_mut().zip(dropped) {
        dropped.sort_unstable();
        let mut number = 0;
        mesh.triangles.retain(|_| {
            number += 1;
            dropped.binary_search(&(number - 1)).is_err()
        });
    }
}

/// The least height of a triangle.
fn height([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    (b - a).cross(c - a).length() / longest
}

/// The pairs of sides of polygons, numbered through, that meet other than in a vertex of both.
pub(super) fn crossing_sides(polygons: &[Vec<DVec2>]) -> Vec<[usize; 2]> {
    let sides: Vec<[DVec2; 2]> = polygons
        .iter()
        .flat_map(|places| (0..places.len()).map(|i| [places[i], places[(i + 1) % places.len()]]))
        .collect();
    let flat = |place: DVec2| place.extend(0.0);
    let boxes: Vec<Bounds> =
        sides.iter().map(|&[a, b]| Bounds { min: flat(a.min(b)), max: flat(a.max(b)) }).collect();
    let tree = BoxTree::new(boxes.clone());
    let mut pairs = Vec::new();
    for (i, bounds) in boxes.into_iter().enumerate() {
        let later = tree.near(bounds, 0.0).into_iter().filter(|&k| i < k);
        pairs.extend(later.filter(|&k| do_cross(sides[i], sides[k])).map(|k| [i, k]));
    }
    pairs
}

/// Whether two sides without a common end have a point in common.
fn do_cross([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    if [a, b].iter().any(|end| *end == c || *end == d) {
        return false;
    }
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}
