//! Laws of collapsed edges: what has a direction there, although a derivative vanishes.

use glam::DVec3;
use virote_kernel::{
    Axis, Curve, Direction, Frame, Grid, KnotVector, NurbsCurve, NurbsSurface, Surface, Tolerance,
};

use crate::some::sphere;

/// A quarter turn about z of the parabola through three points of a half plane.
fn quarter(profile: [[f64; 2]; 3]) -> NurbsSurface {
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let around = [[1.0, 0.0, 1.0], [1.0, 1.0, s], [0.0, 1.0, 1.0]];
    let point = |i: usize, j: usize| {
        let ([x, y, _], [rho, z]) = (around[i], profile[j]);
        DVec3::new(rho * x, rho * y, z)
    };
    let knots = || KnotVector::bezier(2).unwrap();
    let weights = Grid::from_fn(3, 3, |i, _| around[i][2]);
    NurbsSurface::rational(knots(), knots(), &Grid::from_fn(3, 3, point), &weights).unwrap()
}

/// The direction around z at a place: that of the circle through it.
fn around(point: DVec3) -> DVec3 {
    DVec3::Z.cross(point).normalize()
}

/// At both collapsed or open ends of v the direction of Su is that inside of the domain, whichever
/// parameter runs around and whichever way it does.
#[track_caller]
fn turns_as_inside(surface: &NurbsSurface) {
    let (us, ends) = (surface.domain_u(), surface.domain_v());
    for f in [0.0, 0.2, 0.5, 0.9, 1.0] {
        for v in [ends.start(), ends.end()] {
            let inside = around(surface.point_at(us.at(f), ends.at(0.5)));
            let near = |found: DVec3, expected: DVec3| {
                assert!(found.distance(expected) < 1e-9, "{found} at {f}, {v}, not {expected}");
            };
            let given = Surface::from(surface.clone());
            near(given.tangent_u_at(us.at(f), v).unwrap(), inside);
            let swapped = Surface::from(surface.swapped());
            near(swapped.tangent_v_at(v, us.at(f)).unwrap(), inside);
            let turned = Surface::from(surface.reversed(Direction::U));
            near(turned.tangent_u_at(us.at(1.0 - f), v).unwrap(), -inside);
            // Upside down the pole is at the other end.
            let upside_down = Surface::from(surface.reversed(Direction::V));
            let other = ends.start() + (ends.end() - v);
            near(upside_down.tangent_u_at(us.at(f), other).unwrap(), inside);
        }
    }
}

#[test]
fn a_sphere_turns_at_its_poles_as_at_its_equator() {
    turns_as_inside(&sphere(DVec3::ZERO, 2.0));
    turns_as_inside(&sphere(DVec3::new(0.0, 0.0, 50.0), 0.5));
}

#[test]
fn a_cone_turns_at_its_tip_as_at_its_base() {
    turns_as_inside(&quarter([[0.0, 0.0], [1.0, 0.5], [2.0, 1.0]]));
}

/// The radius grows with the square of v, so that Su has no first derivative by v either.
#[test]
fn a_cusp_turns_at_its_tip_as_at_its_base() {
    turns_as_inside(&quarter([[0.0, 0.0], [0.0, 0.5], [1.0, 1.0]]));
}

#[test]
fn a_tangent_plane_at_a_pole_has_its_first_axis_around() {
    let surface = Surface::from(sphere(DVec3::ZERO, 1.0));
    for (f, x) in [(0.0, DVec3::Y), (0.25, -DVec3::X), (0.5, -DVec3::Y)] {
        for (v, z) in [(0.0, -DVec3::Z), (1.0, DVec3::Z)] {
            let plane = surface.tangent_plane_at(f, v).unwrap();
            assert!(plane.x().distance(x) < 1e-12, "{} at {f}, {v}", plane.x());
            assert!(plane.z().distance(z) < 1e-12, "{} at {f}, {v}", plane.z());
            assert!(plane.origin().distance(z) < 1e-12);
        }
    }
}

/// Where a whole patch is one line there is no direction across it.
#[test]
fn what_is_collapsed_everywhere_has_no_direction() {
    let knots = || KnotVector::bezier(2).unwrap();
    let point = |_: usize, j: usize| DVec3::Z * j as f64;
    let line = NurbsSurface::polynomial(knots(), knots(), &Grid::from_fn(3, 3, point)).unwrap();
    let line = Surface::from(line);
    assert!(line.tangent_u_at(0.3, 0.0).is_err() && line.tangent_u_at(0.3, 0.5).is_err());
    assert!(line.tangent_v_at(0.3, 0.0).unwrap().distance(DVec3::Z) < 1e-15);
}

/// A line along the axis meets a surface of revolution at its poles, wherever it begins and ends.
#[test]
fn a_line_through_poles_meets_them() {
    let revolved = |points: &[DVec3]| {
        let profile = NurbsCurve::polyline(points).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        NurbsSurface::revolved(&profile, axis, std::f64::consts::TAU).unwrap()
    };
    let disc = revolved(&[DVec3::Z, DVec3::new(1.0, 0.0, 1.0)]);
    let cone = revolved(&[DVec3::Z, DVec3::new(1.0, 0.0, 0.0)]);
    let ball = NurbsSurface::sphere(Frame::XY, 1.7).unwrap();
    let cases = [(disc, vec![1.0]), (cone, vec![1.0]), (ball, vec![-1.7, 1.7])];
    for (surface, poles) in cases {
        for scale in [1e-3, 1.0, 1e3] {
            for turn in [0.0, 0.3, 2.0] {
                let map = glam::DAffine3::from_scale_rotation_translation(
                    DVec3::splat(scale),
                    glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 0.5).normalize(), turn),
                    DVec3::new(3.0, -1.0, 2.0) * (turn * scale),
                );
                let placed = Surface::from(surface.clone()).transformed(&map).unwrap();
                for k in 0..40 {
                    let [start, end] = [-2.1 - 0.13 * f64::from(k % 5), 1.9 + 0.37 * f64::from(k)];
                    let ends = [start, end].map(|z| map.transform_point3(DVec3::Z * z));
                    let line = Curve::from(NurbsCurve::line(ends[0], ends[1]).unwrap());
                    let found = placed.piercings(&line, Tolerance::DEFAULT).unwrap();
                    let what = format!("{poles:?} at {scale}, {turn}, {start}..{end}: {found:?}");
                    assert_eq!(found.len(), poles.len(), "{what}");
                    for (place, &z) in found.iter().zip(&poles) {
                        let pole = map.transform_point3(DVec3::Z * z);
                        let on = placed.point_at(place.uv[0], place.uv[1]).unwrap();
                        let t = (z - start) / (end - start);
                        assert!((place.t - t).abs() < 1e-11, "{what}, {t}");
                        assert!(place.point.distance(pole) < 1e-11 * scale, "{what}");
                        assert!(on.distance(pole) < 1e-11 * scale, "{what}");
                    }
                }
            }
        }
    }
}
