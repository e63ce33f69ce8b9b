//! Faces of closed meshes that lie on one another, and coordinates in which they do so to the last bit.
//!
//! In a frame that is turned, faces that are meant to coincide are 1e-16 apart, here before and there behind: a boolean
//! takes both for borders, with nothing or a gap between. What coincides to the last bit it decides alike
//! everywhere. A linear map takes the planes of such faces to planes of equal coordinates, which then are made equal;
//! what lies inside of what is the same before and after it. There are three coordinates: it serves three directions of
//! planes, and those of a prism, whose vertical edges become equal in two of them.

use std::collections::HashMap;

use glam::{DMat3, DVec2, DVec3};

use super::Mesh;
use crate::{
    Bounds, GeomError,
    box_tree::BoxTree,
    ceiling::COINCIDENT_DIRECTIONS,
    sorting::sort_by,
    tolerance::{CLEAR_SINE, PARALLEL_SINE},
};

/// Two triangles that cover one another in a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct CoincidentTriangles {
    /// That of the larger one, of length 1.
    normal: DVec3,
    /// Of what they have in common.
    area: f64,
    /// In what they have in common.
    pub(super) at: DVec3,
    /// Whether they face the same way.
    pub(super) faces_alike: bool,
    /// Whether they are in one plane to the last bit.
    is_exact: bool,
}

impl CoincidentTriangles {
    /// Of two triangles, that are no further than rounding from one plane and have more than a line in common.
    fn of(one: [DVec3; 3], other: [DVec3; 3], rounding: f64) -> Option<Self> {
        let crosses = [one, other].map(|[a, b, c]| (b - a).cross(c - a));
        let longest = |[a, b, c]: [DVec3; 3]| a.distance(b).max(b.distance(c)).max(c.distance(a));
        let [one_length, other_length] = crosses.map(DVec3::length);
        if one_length <= rounding * longest(one) || other_length <= rounding * longest(other) {
            return None;
        }
        let (normal, start, rest) = if one_length < other_length {
            (crosses[1] / other_length, other[0], one)
        } else {
            (crosses[0] / one_length, one[0], other)
        };
        if rest.iter().any(|&corner| rounding < (corner - start).dot(normal).abs()) {
            return None;
        }
        let (x, y) = normal.any_orthonormal_pair();
        let flat = |corner: DVec3| DVec2::new((corner - start).dot(x), (corner - start).dot(y));
        let common = common_part(one.map(flat), other.map(flat));
        let twice = |k: usize| {
            let [a, b] = [common[k] - common[0], common[(k + 1) % common.len()] - common[0]];
            a.perp_dot(b)
        };
        let area = 0.5 * (0..common.len()).map(twice).sum::<f64>().abs();
        if area <= rounding * longest(one).min(longest(other)) {
            return None;
        }
        let middle = common.iter().sum::<DVec2>() / common.len() as f64;
        let is_level = |k: usize| {
            let level = one[0][k].to_bits();
            one.iter().chain(&other).all(|corner| corner[k].to_bits() == level)
        };
        let is_same = one.iter().all(|corner| other.contains(corner));
        Some(Self {
            normal,
            area,
            at: start + x * middle.x + y * middle.y,
            faces_alike: 0.0 < crosses[0].dot(crosses[1]),
            is_exact: is_same || (0..3).any(is_level),
        })
    }
}

/// What two triangles in a plane have in common, as a convex polygon. Sutherland and Hodgman, *Reentrant polygon
/// clipping*, CACM 17 (1974).
fn common_part(one: [DVec2; 3], other: [DVec2; 3]) -> Vec<DVec2> {
    let sense = (other[1] - other[0]).perp_dot(other[2] - other[0]).signum();
    let mut left = one.to_vec();
    for k in 0..3 {
        let [from, to] = [other[k], other[(k + 1) % 3]];
        let side = |place: DVec2| sense * (to - from).perp_dot(place - from);
        let mut kept = Vec::with_capacity(left.len() + 1);
        for (at, &place) in left.iter().enumerate() {
            let next = left[(at + 1) % left.len()];
            let [here, there] = [side(place), side(next)];
            if 0.0 <= here {
                kept.push(place);
            }
            if (here < 0.0) != (there < 0.0) {
                kept.push(place + (next - place) * (here / (here - there)));
            }
        }
        left = kept;
        if left.is_empty() {
            break;
        }
    }
    left
}

/// The pairs of triangles, of one mesh each, that coincide but for rounding.
pub(super) fn coincident_triangles(
    one: &Mesh,
    other: &Mesh,
    rounding: f64,
) -> Result<Vec<CoincidentTriangles>, GeomError> {
    let (Some(one_bounds), Some(other_bounds)) = (one.bounds(), other.bounds()) else {
        return Ok(Vec::new());
    };
    GeomError::go_on(one.n_triangles() + other.n_triangles())?;
    let around = |corners: &[DVec3; 3]| {
        Bounds { min: corners[0], max: corners[0] }.with(corners[1]).with(corners[2])
    };
    let beside = |mesh: &Mesh, bounds: Bounds| -> Vec<[DVec3; 3]> {
        mesh.corners().filter(|corners| around(corners).is_near(bounds, rounding)).collect()
    };
    let [mine, theirs] = [beside(one, other_bounds), beside(other, one_bounds)];
    let tree = BoxTree::new(theirs.iter().map(around).collect());
    let mut found = Vec::new();
    for &corners in &mine {
        let near = tree.near(around(&corners), rounding);
        GeomError::go_on(near.len())?;
        found.extend(
            near.into_iter()
                .filter_map(|other| CoincidentTriangles::of(corners, theirs[other], rounding)),
        );
    }
    Ok(found)
}

/// Coordinates in which faces of two meshes coincide to the last bit.
pub(super) struct CoincidentFrame {
    back: DMat3,
    /// Where vertices were, by the bits of their coordinates.
    places: HashMap<[u64; 3], DVec3>,
}

impl CoincidentFrame {
    /// The frame for triangles that coincide, with both meshes in it; none where all of them coincide to the last bit.
    pub(super) fn of(
        triangles: &[CoincidentTriangles],
        meshes: [&Mesh; 2],
        rounding: f64,
    ) -> Option<(Self, [Mesh; 2])> {
        if triangles.iter().all(|pair| pair.is_exact) {
            return None;
        }
        let map = map_to_axes(&directions(triangles));
        let places: Vec<DVec3> =
            meshes.iter().flat_map(|mesh| mesh.vertices.iter().copied()).collect();
        let mut moved: Vec<DVec3> = places.iter().map(|&place| map * place).collect();
        for axis in 0..3 {
            make_equal(&mut moved, axis, rounding);
        }
        let named = places.iter().zip(&moved).map(|(&place, moved)| (bits(*moved), place));
        let frame = Self { back: map.inverse(), places: named.collect() };
        let mut moved = moved.into_iter();
        let meshes = meshes.map(|mesh| Mesh {
            vertices: moved.by_ref().take(mesh.n_vertices()).collect(),
            triangles: mesh.triangles.clone(),
            ..Mesh::default()
        });
        Some((frame, meshes))
    }

    /// A mesh of the frame where the given ones were: vertices of theirs are as they were.
    pub(super) fn without(&self, mesh: Mesh) -> Mesh {
        let place = |place: &DVec3| {
            self.places.get(&bits(*place)).copied().unwrap_or_else(|| self.back * *place)
        };
        Mesh { vertices: mesh.vertices.iter().map(place).collect(), ..mesh }
    }
}

fn bits(place: DVec3) -> [u64; 3] {
    place.to_array().map(|x| (x + 0.0).to_bits())
}

/// The directions across planes in which triangles coincide, the one of the largest area first.
fn directions(triangles: &[CoincidentTriangles]) -> Vec<DVec3> {
    let mut found: Vec<(DVec3, f64)> = Vec::new();
    for pair in triangles {
        match found.iter().position(|(normal, _)| is_parallel(*normal, pair.normal)) {
            Some(known) => found[known].1 += pair.area,
            None if found.len() < COINCIDENT_DIRECTIONS => found.push((pair.normal, pair.area)),
            None => {}
        }
    }
    sort_by(&mut found, |a, b| b.1.total_cmp(&a.1));
    found.into_iter().map(|(normal, _)| normal).collect()
}

fn is_parallel(one: DVec3, other: DVec3) -> bool {
    one.cross(other).length() <= PARALLEL_SINE
}

/// A map, which turns nothing inside out, whose coordinates are measured across planes of these directions.
fn map_to_axes(directions: &[DVec3]) -> DMat3 {
    let first = directions[0];
    let is_clear = |other: &&DVec3| CLEAR_SINE < first.cross(**other).length();
    let Some(&second) = directions.iter().find(is_clear) else {
        let (x, y) = first.any_orthonormal_pair();
        return of_rows([x, y, first]);
    };
    let across = first.cross(second).normalize();
    let third = directions.iter().find(|other| CLEAR_SINE < other.dot(across).abs()).copied();
    let is_enough = directions.len() <= 2 + usize::from(third.is_some());
    // All planes of a prism are along its axis or across it.
    let is_axis = |axis: &DVec3| {
        let is_fit =
            |other: &DVec3| is_parallel(*axis, *other) || axis.dot(*other).abs() <= PARALLEL_SINE;
        directions.iter().all(is_fit)
    };
    let axis = [across, first, second].into_iter().find(|axis| !is_enough && is_axis(axis));
    match axis {
        Some(axis) => {
            let wall = if is_parallel(axis, first) { second } else { first };
            of_rows([wall, axis.cross(wall), axis])
        }
        None => of_rows([first, second, third.unwrap_or(across)]),
    }
}

fn of_rows([x, y, z]: [DVec3; 3]) -> DMat3 {
    let z = if x.cross(y).dot(z) < 0.0 { -z } else { z };
    DMat3::from_cols(x, y, z).transpose()
}

/// Makes coordinates that differ by rounding one.
fn make_equal(places: &mut [DVec3], axis: usize, rounding: f64) {
    let mut order: Vec<usize> = (0..places.len()).collect();
    sort_by(&mut order, |&a, &b| places[a][axis].total_cmp(&places[b][axis]));
    let mut level = f64::NEG_INFINITY;
    for place in order {
        let value = places[place][axis];
        if rounding < value - level {
            level = value;
        }
        places[place][axis] = level + 0.0;
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::{CoincidentTriangles, is_parallel, map_to_axes};

    #[test]
    fn what_triangles_have_in_common_is_measured() {
        let [a, b, c] = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
        let turn = DQuat::from_rotation_x(0.3) * DQuat::from_rotation_y(1.1);
        let of = |other: [DVec3; 3]| {
            let [one, other] = [[a, b, c], other].map(|corners| corners.map(|place| turn * place));
            CoincidentTriangles::of(one, other, 1e-12)
        };
        // A square of side 1 at the corner, cut in halves, and what lies beyond the longest side.
        let half = of([DVec3::X, DVec3::ZERO, DVec3::Y]).unwrap();
        assert!((half.area - 0.5).abs() < 1e-12 && !half.faces_alike, "{half:?}");
        let shifted = of([a, b, c].map(|place| place + DVec3::new(2.0, 0.0, 0.0))).unwrap();
        assert!((shifted.area - 2.0).abs() < 1e-12 && shifted.faces_alike, "{shifted:?}");
        // Beside it, above it, and at an angle.
        assert!(of([b, DVec3::new(4.0, 4.0, 0.0), c]).is_none());
        assert!(of([a, b, c].map(|place| place + DVec3::Z * 1e-9)).is_none());
        assert!(of([a, b, DVec3::new(0.0, 4.0, 1e-6)]).is_none());
    }

    #[test]
    fn planes_have_coordinates_of_their_own() {
        let turn = DQuat::from_rotation_x(0.7) * DQuat::from_rotation_z(0.4);
        let wall = |angle: f64| turn * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        let floor = turn * DVec3::Z;
        for (directions, n_expected) in [
            (vec![floor], 1),
            (vec![wall(0.0), floor], 2),
            (vec![wall(0.0), wall(1.0), floor], 3),
            (vec![floor, wall(0.0), wall(1.0), wall(2.0), wall(3.0)], 2),
            (vec![wall(0.0), wall(1.0), wall(2.0)], 1),
        ] {
            let map = map_to_axes(&directions);
            assert!(0.1 < map.determinant(), "{map}");
            let axes = [0, 1, 2].map(|k| map.row(k));
            let has_own =
                |direction: &&DVec3| axes.iter().any(|&axis| is_parallel(axis, **direction));
            assert_eq!(directions.iter().filter(has_own).count(), n_expected);
        }
    }
}
