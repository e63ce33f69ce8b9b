//! How far a place is from a mesh, and from a polyline.

use glam::DVec3;

use super::Mesh;

impl Mesh {
    /// The distance of a place from the nearest triangle, in time linear in their number; none of a
    /// mesh without triangles.
    ///
    /// Over the plane of a triangle if the foot of the perpendicular is inside, else to its sides.
    #[must_use]
    pub fn distance_to(&self, place: DVec3) -> Option<f64> {
        self.corners().map(|corners| to_triangle(place, corners)).reduce(f64::min)
    }
}

/// The distance of a place from the nearest leg of a polyline; none without points.
#[must_use]
pub fn distance_to_polyline(place: DVec3, points: &[DVec3]) -> Option<f64> {
    let legs = points.windows(2).map(|leg| to_leg(place, leg[0], leg[1]));
    legs.chain(points.first().map(|first| first.distance(place))).reduce(f64::min)
}

fn to_leg(place: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let t = (place - a).dot(along) / along.length_squared();
    // A leg without length is its beginning.
    if t.is_nan() { a.distance(place) } else { (a + t.clamp(0.0, 1.0) * along).distance(place) }
}

pub(super) fn to_triangle(place: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let is_inside = |from: DVec3, to: DVec3| 0.0 <= normal.dot((to - from).cross(place - from));
    if 0.0 < normal.length_squared() && is_inside(a, b) && is_inside(b, c) && is_inside(c, a) {
        return (place - a).dot(normal.normalize()).abs();
    }
    to_leg(place, a, b).min(to_leg(place, b, c)).min(to_leg(place, c, a))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Mesh, distance_to_polyline};

    #[track_caller]
    fn check(place: [f64; 3], expected: f64) {
        // The half of a square of side 4 in the plane z = 0.
        let corners = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
        let mesh = Mesh::new(corners.to_vec(), Vec::new(), Vec::new(), vec![[0, 1, 2]]);
        let distance = mesh.ok().and_then(|mesh| mesh.distance_to(place.into()));
        assert!(distance.is_some_and(|found| (found - expected).abs() < 1e-12), "{distance:?}");
    }

    #[test]
    fn over_a_triangle_the_distance_is_that_of_its_plane() {
        check([1.0, 1.0, -3.0], 3.0);
    }

    #[test]
    fn beside_a_triangle_the_distance_is_that_of_a_side_or_corner() {
        check([2.0, -3.0, 4.0], 5.0);
        check([4.0, 4.0, 0.0], 8.0_f64.sqrt());
        check([-3.0, -4.0, 12.0], 13.0);
    }

    #[test]
    fn a_polyline_of_one_place_is_a_point() {
        let corner = DVec3::new(3.0, 4.0, 0.0);
        assert_eq!(distance_to_polyline(corner, &[DVec3::ZERO]), Some(5.0));
        assert_eq!(distance_to_polyline(corner, &[DVec3::ZERO, DVec3::ZERO]), Some(5.0));
        assert_eq!(distance_to_polyline(corner, &[DVec3::ZERO, DVec3::X * 9.0]), Some(4.0));
        assert_eq!(distance_to_polyline(corner, &[]), None);
    }
}
