//! Laws of plane sections: they are complete, and where the plane is.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use proptest::{prop_assert, prop_assert_eq, prop_assume, proptest};
use virote_kernel::{
    Axis, CircleForm, Frame, Grid, KnotVector, LevelSet, NurbsCurve, NurbsSurface, Tolerance,
};

use crate::some::{fraction, point};

const TOLERANCE: f64 = 1e-6;

fn plane(origin: DVec3, normal: DVec3) -> Frame {
    Frame::from_normal(origin, normal, None).unwrap()
}

fn at_height(z: f64) -> Frame {
    plane(DVec3::Z * z, DVec3::Z)
}

fn cut(surface: &NurbsSurface, plane: Frame) -> LevelSet {
    let section = surface.section(plane, Tolerance::DEFAULT).unwrap();
    for curve in &section.curves {
        for p in curve.sample(60) {
            assert!((p - plane.origin()).dot(plane.z()).abs() <= TOLERANCE, "{p} is off the plane");
            assert!(surface.closest(p).distance <= TOLERANCE, "{p} is off the surface");
        }
    }
    section
}

/// Lines that are closed, and others.
fn counts(section: &LevelSet) -> [usize; 2] {
    let n_closed = section.curves.iter().filter(|curve| curve.is_closed(TOLERANCE)).count();
    [n_closed, section.curves.len() - n_closed]
}

fn length(curve: &NurbsCurve) -> f64 {
    curve.length(curve.domain())
}

fn sphere(radius: f64) -> NurbsSurface {
    NurbsSurface::sphere(at_height(0.0), radius).unwrap()
}

/// A torus whose top is not at a knot: its tube has three pieces.
fn torus_of_thirds() -> NurbsSurface {
    let form = CircleForm::SevenTriangle;
    let tube = NurbsCurve::circle(DVec3::X * 3.0, 1.0, DVec3::X, -DVec3::Y, form).unwrap();
    NurbsSurface::revolved(&tube, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), TAU).unwrap()
}

fn paraboloid() -> NurbsSurface {
    // x² + y² over −1..1 twice.
    let square = [1.0, -1.0, 1.0];
    let points = Grid::from_fn(3, 3, |i, j| {
        DVec3::new(i as f64 - 1.0, j as f64 - 1.0, square[i] + square[j])
    });
    NurbsSurface::bezier(&points).unwrap()
}

proptest! {
    #[test]
    fn a_plane_cuts_a_sphere_in_a_circle(normal in point(), depth in -1.2..1.2f64) {
        prop_assume!(0.1 < normal.length() && 1e-3 < (depth.abs() - 1.0).abs());
        let plane = plane(normal.normalize() * (5.0 * depth), normal);
        let section = cut(&sphere(5.0), plane);
        if depth.abs() < 1.0 {
            prop_assert_eq!(counts(&section), [1, 0]);
            let around = TAU * 5.0 * (1.0 - depth * depth).sqrt();
            prop_assert!((length(&section.curves[0]) - around).abs() <= 1e-4);
        } else {
            prop_assert_eq!(section.curves.len(), 0);
        }
    }

    #[test]
    fn contours_of_the_saddle_are_hyperbolas(level in -0.9..0.9f64) {
        prop_assume!(1e-3 < level.abs());
        let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
            .map(|(x, y): (f64, f64)| DVec3::new(x, y, x * y));
        let saddle = NurbsSurface::bilinear(corners[0], corners[1], corners[2], corners[3]).unwrap();
        let section = cut(&saddle, at_height(level));
        prop_assert_eq!(counts(&section), [0, 2]);
        for p in section.curves.iter().flat_map(|curve| curve.sample(40)) {
            prop_assert!((p.x * p.y - level).abs() <= 2.0 * TOLERANCE);
        }
    }

    #[test]
    fn small_circles_near_a_pole_are_found(f in fraction()) {
        let radius = 0.0045 * (0.1 + f);
        let section = cut(&sphere(1.0), at_height((1.0 - radius * radius).sqrt()));
        prop_assert_eq!(counts(&section), [1, 0]);
        for p in section.curves[0].sample(40) {
            prop_assert!((p.truncate().length() - radius).abs() <= TOLERANCE);
        }
    }
}

#[test]
fn a_circle_beside_the_pole_of_a_spline_sphere_is_found() {
    // A polynomial spline near the unit sphere; the circle has radius 0.0045.
    let rings = 48;
    let grid = Grid::from_fn(2 * rings + 1, rings + 1, |i, j| {
        let (sin_u, cos_u) = libm::sincos(PI * i as f64 / rings as f64);
        let (sin_v, cos_v) = libm::sincos(PI * j as f64 / rings as f64);
        DVec3::new(cos_u * sin_v, sin_u * sin_v, -cos_v)
    });
    let clamped = |n: usize| {
        let inner = (1..n - 3).map(|i| i as f64 / (n - 3) as f64);
        KnotVector::new(3, [0.0; 4].into_iter().chain(inner).chain([1.0; 4]).collect()).unwrap()
    };
    let surface =
        NurbsSurface::polynomial(clamped(2 * rings + 1), clamped(rings + 1), &grid).unwrap();
    let section = cut(&surface, at_height(0.999_99));
    assert_eq!(counts(&section), [1, 0]);
    let top = section.curves[0].sample(40);
    assert!(top.iter().all(|p| p.truncate().length() < 0.03));
}

#[test]
fn a_bump_between_samples_gives_its_loop() {
    let points = Grid::from_fn(40, 40, |i, j| {
        DVec3::new(i as f64, j as f64, if (i, j) == (21, 17) { 3.0 } else { 0.0 })
    });
    let knots = || {
        let inner = (1..37).map(f64::from);
        let all = [0.0; 4].into_iter().chain(inner).chain([37.0; 4]).collect();
        KnotVector::new(3, all).unwrap()
    };
    let bump = NurbsSurface::polynomial(knots(), knots(), &points).unwrap();
    // The top is 3·(2/3)² = 4/3.
    let section = cut(&bump, at_height(1.3));
    assert_eq!(counts(&section), [1, 0]);
    assert!(
        section.curves[0].sample(40).iter().all(|p| p.distance(DVec3::new(21.0, 17.0, 1.3)) < 0.2)
    );
    assert_eq!(cut(&bump, at_height(1.34)).curves.len(), 0);
}

#[test]
fn a_plane_tangent_to_a_torus_touches_its_top_circle() {
    let at_knots = NurbsSurface::torus(at_height(0.0), 3.0, 1.0).unwrap();
    for torus in [at_knots, torus_of_thirds()] {
        let section = cut(&torus, at_height(1.0));
        assert_eq!(counts(&section), [1, 0]);
        assert!((length(&section.curves[0]) - 3.0 * TAU).abs() <= 1e-4);
    }
}

#[test]
fn a_plane_tangent_to_a_torus_inside_cuts_a_figure_eight() {
    let at_knots = NurbsSurface::torus(at_height(0.0), 3.0, 1.0).unwrap();
    for torus in [at_knots, torus_of_thirds()] {
        for angle in [0.0_f64, 0.4] {
            let normal = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
            let section = cut(&torus, plane(normal * 2.0, normal));
            assert_eq!(counts(&section), [2, 0]);
            let middle = normal * 2.0;
            assert!(section.curves.iter().all(|curve| curve.start().distance(middle) <= TOLERANCE));
            assert_eq!(section.touches.len(), 0);
        }
    }
}

#[test]
fn a_plane_through_both_poles_cuts_one_circle() {
    for angle in [0.0_f64, 0.3] {
        let section = cut(
            &sphere(2.0),
            plane(DVec3::ZERO, DVec3::new(libm::sin(angle), libm::cos(angle), 0.0)),
        );
        assert_eq!(counts(&section), [1, 0]);
        assert!((length(&section.curves[0]) - 2.0 * TAU).abs() <= 1e-4);
    }
}

#[test]
fn a_plane_that_touches_in_one_point_has_no_line() {
    for (surface, z) in [(paraboloid(), 0.0), (sphere(1.0), 1.0)] {
        let section = cut(&surface, at_height(z));
        assert_eq!(section.curves.len(), 0);
        assert_eq!(section.touches.len(), 1);
        assert!(section.touches[0].distance(DVec3::Z * z) <= TOLERANCE);
    }
}

#[test]
fn four_branches_leave_a_saddle() {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
        .map(|(x, y): (f64, f64)| DVec3::new(x, y, x * y));
    let saddle = NurbsSurface::bilinear(corners[0], corners[1], corners[2], corners[3]).unwrap();
    let section = cut(&saddle, at_height(0.0));
    assert_eq!(counts(&section), [0, 4]);
    assert!(section.curves.iter().all(|curve| (length(curve) - 1.0).abs() <= 4.0 * TOLERANCE));
}

#[test]
fn a_patch_in_the_plane_is_told_by_its_border() {
    let flat =
        NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y).unwrap();
    let section = cut(&flat, at_height(0.0));
    assert_eq!(counts(&section), [1, 0]);
    assert!((length(&section.curves[0]) - 4.0).abs() <= 1e-9);
}

#[test]
fn a_plane_along_an_isocurve_finds_it() {
    let flat =
        NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y).unwrap();
    for x in [0.0, 0.5, 1.0] {
        let section = cut(&flat, plane(DVec3::X * x, DVec3::X));
        assert_eq!(counts(&section), [0, 1]);
        assert!((length(&section.curves[0]) - 1.0).abs() <= 1e-9);
    }
}
