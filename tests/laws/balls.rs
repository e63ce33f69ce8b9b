//! Meshes of spheres and of parts of them, by closed forms.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DAffine3, DVec3};
use virote_kernel::{Axis, Direction, Frame, Mesh, NurbsCurve, NurbsSurface, tessellate};

use crate::some::sphere;

const MOST: usize = 1_000_000;

/// The part between two latitudes and so far around, with the centre at the origin.
fn part(radius: f64, [south, north]: [f64; 2], turn: f64) -> NurbsSurface {
    let meridian = Frame::from_axes(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap();
    let arc = NurbsCurve::arc(meridian, radius, south, north - south).unwrap();
    NurbsSurface::revolved(&arc, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), turn).unwrap()
}

/// How near a triangle comes to the origin.
fn nearest([a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let foot = normal * (normal.dot(a) / normal.length_squared());
    let is_beside = |(a, b): (DVec3, DVec3)| (b - a).cross(foot - a).dot(normal) < 0.0;
    if ![(a, b), (b, c), (c, a)].into_iter().any(is_beside) {
        return foot.length();
    }
    let to_side = |(a, b): (DVec3, DVec3)| {
        let leg = b - a;
        (a + leg * (-a.dot(leg) / leg.length_squared()).clamp(0.0, 1.0)).length()
    };
    to_side((a, b)).min(to_side((b, c))).min(to_side((c, a)))
}

/// The angle that a triangle covers, seen from the origin; positive if that sees its back. Van Oosterom & Strackee (1983).
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let [x, y, z] = [a, b, c].map(DVec3::length);
    let below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
    2.0 * libm::atan2(a.dot(b.cross(c)), below)
}

/// Checks that every triangle is within the tolerance and faces the side of the surface, and that all together cover as
/// much of the sphere as the surface does.
#[track_caller]
fn check(surface: &NurbsSurface, radius: f64, tolerance: f64, covered: f64) -> Mesh {
    let mesh = tessellate(surface, tolerance, MOST).unwrap();
    for corners in mesh.corners() {
        assert!(radius - nearest(corners) <= tolerance * (1.0 + 1e-9), "{corners:?}");
        assert!(corners.iter().all(|corner| (corner.length() - radius).abs() < 1e-12 * radius));
    }
    for (triangle, [a, b, c]) in mesh.triangles().iter().zip(mesh.corners()) {
        let facing = (b - a).cross(c - a);
        let normals = triangle.iter().map(|&i| mesh.normals()[i as usize]);
        assert!(normals.into_iter().all(|normal| 0.0 < facing.dot(normal)));
    }
    for ((place, uv), normal) in mesh.vertices().iter().zip(mesh.uvs()).zip(mesh.normals()) {
        assert!(surface.point_at(uv.x, uv.y).distance(*place) < 1e-9 * radius);
        assert!(normal.cross(*place).length() < 1e-9 * radius);
    }
    let sum: f64 = mesh.corners().map(solid_angle).sum();
    assert!((sum.abs() - covered).abs() <= 0.02 * covered, "{sum} for {covered}");
    mesh
}

#[test]
fn a_sphere_takes_hardly_more_triangles_than_equilateral_ones_would() {
    for (radius, tolerance) in [(10.0, 1e-2), (1.0, 1e-3), (1.0, 1e-2), (3.0, 2e-2)] {
        let mesh = check(&sphere(DVec3::ZERO, radius), radius, tolerance, 4.0 * PI);
        // Equilateral triangles in circles of the radius that the tolerance leaves.
        let square = tolerance * (2.0 * radius - tolerance);
        let equilateral = 4.0 * PI * radius * radius / (0.75 * 3.0_f64.sqrt() * square);
        assert!((mesh.n_triangles() as f64) < 1.4 * equilateral, "{}", mesh.n_triangles());
        for [a, b, c] in mesh.corners() {
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let height = (b - a).cross(c - a).length() / longest;
            assert!(0.05 * longest < height, "{a} {b} {c}");
        }
        let sum: f64 = mesh.corners().map(solid_angle).sum();
        assert!((sum - 4.0 * PI).abs() < 1e-9, "{sum}");
    }
}

#[test]
fn parts_of_spheres_keep_the_tolerance() {
    for latitudes in [[-FRAC_PI_2, 0.0], [0.3, FRAC_PI_2], [-0.7, 1.2], [1.0, 1.4], [-0.1, 0.1]] {
        for turn in [TAU, PI, 1.0, 0.2] {
            let covered = turn * (libm::sin(latitudes[1]) - libm::sin(latitudes[0]));
            for tolerance in [2e-2, 1e-3] {
                check(&part(2.0, latitudes, turn), 2.0, tolerance, covered);
            }
        }
    }
}

#[test]
fn it_does_not_matter_how_the_parameters_of_a_sphere_run() {
    let half = part(1.0, [-FRAC_PI_2, 0.4], 5.0);
    let covered = 5.0 * (libm::sin(0.4) + 1.0);
    let mirror = half.transformed(&DAffine3::from_scale(DVec3::new(1.0, -1.0, 1.0)));
    let turned = half.transformed(&DAffine3::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 2.0));
    let [back_u, back_v] = [Direction::U, Direction::V].map(|along| half.reversed(along));
    for surface in [&half, &half.swapped(), &back_u, &back_v, &mirror, &turned] {
        check(surface, 1.0, 1e-3, covered);
    }
}
