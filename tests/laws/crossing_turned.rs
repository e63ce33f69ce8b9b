//! Curves of quadrics and tori whose lengths are known, with poles, seams and contacts on them, turned
//! in every way: what is found must not depend on where parameters run.

use std::{f64::consts::TAU, sync::Arc};

use glam::{DAffine3, DQuat, DVec3};
use virote_kernel::{
    Axis, Frame, KnotVector, LevelSet, NurbsCurve, NurbsSurface, Surface, Tolerance,
};

use crate::some::sphere;

/// Orientations of each family: 12, or as many as `VIROTE_ORIENTATIONS` says.
pub(crate) fn orientations() -> u64 {
    let asked = std::env::var("VIROTE_ORIENTATIONS").ok();
    asked.map_or(12, |asked| asked.parse().expect("a number of orientations"))
}

/// Numbers between 0 and 1 without a pattern: the multiples of irrational numbers, less their integers.
pub(crate) fn fractions(n: u64) -> [f64; 4] {
    [2f64, 3.0, 5.0, 7.0].map(|prime| (prime.sqrt() * (n + 1) as f64).fract())
}

/// The n-th rotation: uniform over all of them (Shoemake, *Uniform random rotations*, Graphics Gems III).
pub(crate) fn turn(n: u64) -> DAffine3 {
    let [a, b, c, _] = fractions(n);
    let ((s1, c1), (s2, c2)) = (libm::sincos(TAU * b), libm::sincos(TAU * c));
    let (low, high) = ((1.0 - a).sqrt(), a.sqrt());
    DAffine3::from_quat(DQuat::from_xyzw(low * s1, low * c1, high * s2, high * c2))
}

fn cylinder(base: DVec3, radius: f64, height: f64) -> NurbsSurface {
    let foot = base + DVec3::X * radius;
    let side = NurbsCurve::line(foot, foot + DVec3::Z * height).unwrap();
    NurbsSurface::revolved(&side, Axis::new(base, DVec3::Z).unwrap(), TAU).unwrap()
}

fn torus(major: f64, minor: f64) -> NurbsSurface {
    let s = 0.5f64.sqrt();
    let knots = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    let corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let points: Vec<DVec3> = corners
        .iter()
        .map(|&(x, z)| DVec3::new(major + minor * f64::from(x), 0.0, minor * f64::from(z)))
        .collect();
    let weights = [1.0, s, 1.0, s, 1.0, s, 1.0, s, 1.0];
    let tube = NurbsCurve::rational(KnotVector::new(2, knots).unwrap(), &points, &weights).unwrap();
    NurbsSurface::revolved(&tube, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), TAU).unwrap()
}

fn total(found: &LevelSet) -> f64 {
    found.curves.iter().map(|curve| curve.length(curve.domain())).sum()
}

/// What both share in each orientation, at full length.
#[track_caller]
fn check(name: &str, surfaces: [&NurbsSurface; 2], length: f64) {
    for n in 0..orientations() {
        let [a, b] = surfaces.map(|s| Surface::Nurbs(Arc::new(s.transformed(&turn(n)))));
        for [first, second] in [[&a, &b], [&b, &a]] {
            let found = first.intersections(second, Tolerance::DEFAULT);
            assert!(found.is_ok(), "{name}, orientation {n}: {found:?}");
            let found = found.unwrap();
            let far = (total(&found) / length - 1.0).abs();
            assert!(far < 2e-6, "{name}, orientation {n}: {} for {length}", total(&found));
        }
    }
}

/// The complete elliptic integral of the second kind, E(m), by arithmetic and geometric means.
/// Abramowitz & Stegun, *Handbook of Mathematical Functions*, §17.6.
fn elliptic(m: f64) -> f64 {
    let (mut a, mut g, mut sum, mut power) = (1.0, (1.0 - m).sqrt(), 0.5 * m, 1.0);
    for _ in 0..30 {
        let c = 0.5 * (a - g);
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
        sum += power * c * c;
        power *= 2.0;
    }
    0.5 * std::f64::consts::PI / a * (1.0 - sum)
}

/// The perimeter of an ellipse.
fn ellipse(major: f64, minor: f64) -> f64 {
    4.0 * major * elliptic(1.0 - (minor / major) * (minor / major))
}

/// Of a sphere and a cylinder through its poles: cos φ = k cos λ on the sphere, k = R / 2r < 1, by the
/// longitude φ from the plane of the two axes and the latitude λ. What is periodic and analytic is summed
/// by the trapezium rule.
fn through_both_poles(sphere: f64, cylinder: f64) -> f64 {
    let k = sphere / (2.0 * cylinder);
    let speed = |latitude: f64| {
        let (s, c) = libm::sincos(latitude);
        (1.0 + c * k * s * c * k * s / (1.0 - k * c * k * c)).sqrt()
    };
    let n = 4000;
    let whole: f64 = (0..n).map(|i| speed(TAU * f64::from(i) / f64::from(n))).sum();
    sphere * TAU * whole / f64::from(n)
}

#[test]
fn a_curve_through_the_pole_of_a_sphere_that_crosses_itself_is_told_in_every_orientation() {
    let viviani = 8.0 * 2f64.sqrt() * elliptic(0.5);
    let cylinder = cylinder(DVec3::new(1.0, 0.0, -4.0), 1.0, 8.0);
    check("Viviani's curve", [&sphere(DVec3::ZERO, 2.0), &cylinder], viviani);
}

#[test]
fn loops_through_both_poles_of_a_sphere_are_told_once_in_every_orientation() {
    for radius in [1.2, 1.4, 3.0] {
        let cylinder = cylinder(DVec3::new(radius, 0.0, -8.0), radius, 16.0);
        let length = through_both_poles(2.0, radius);
        check("both poles", [&sphere(DVec3::ZERO, 2.0), &cylinder], length);
    }
}

#[test]
fn cylinders_of_one_radius_cross_in_two_ellipses_in_every_orientation() {
    let upright = cylinder(DVec3::new(0.0, 0.0, -6.0), 1.0, 12.0);
    for angle in [1.0f64, 0.5 * std::f64::consts::PI] {
        let lying = upright.transformed(&DAffine3::from_rotation_x(angle));
        let length =
            ellipse(1.0 / libm::sin(0.5 * angle), 1.0) + ellipse(1.0 / libm::cos(0.5 * angle), 1.0);
        check("two ellipses", [&upright, &lying], length);
    }
}

#[test]
fn planes_that_touch_a_torus_twice_cut_circles_of_its_major_radius() {
    for n in 0..2 * orientations() {
        let [a, b, c, _] = fractions(n);
        let minor = 0.3 + a;
        let major = minor * (1.1 + 2.0 * b);
        let steep = libm::asin(minor / major);
        let across = DVec3::new(-libm::cos(TAU * c), -libm::sin(TAU * c), 0.0);
        let normal = across * libm::sin(steep) + DVec3::Z * libm::cos(steep);
        for turn in [DAffine3::IDENTITY, turn(n)] {
            let plane =
                Frame::from_normal(DVec3::ZERO, turn.transform_vector3(normal), None).unwrap();
            let found =
                torus(major, minor).transformed(&turn).section(plane, Tolerance::DEFAULT).unwrap();
            let wanted = 2.0 * TAU * major;
            assert!((total(&found) / wanted - 1.0).abs() < 2e-6, "{n}: {}", total(&found));
        }
    }
}

#[test]
fn a_plane_that_touches_a_cone_along_a_ruling_tells_it_up_to_the_tip() {
    for n in 0..orientations() {
        let [a, b, c, _] = fractions(n);
        let (radius, height, around) = (0.5 + a, 1.0 + b, TAU * c);
        let foot = DVec3::new(radius, 0.0, height);
        let side = NurbsCurve::line(DVec3::ZERO, foot).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        let cone = NurbsSurface::revolved(&side, axis, TAU).unwrap();
        let normal = DVec3::new(height * libm::cos(around), height * libm::sin(around), -radius);
        let turn = turn(n);
        let plane = Frame::from_normal(DVec3::ZERO, turn.transform_vector3(normal), None).unwrap();
        let found = cone.transformed(&turn).section(plane, Tolerance::DEFAULT).unwrap();
        assert_eq!(found.curves.len(), 1, "{n}");
        assert!((total(&found) / foot.length() - 1.0).abs() < 2e-6, "{n}: {}", total(&found));
    }
}

/// On the ruling at φ of a cone of 45° about z the sphere about (1, 0, 1/2) through the tip is met at
/// r = √2 (cos φ + 1/2), from the tip to the tip.
#[test]
fn a_loop_through_the_tip_of_a_cone_is_told_in_every_orientation() {
    let side = NurbsCurve::line(DVec3::ZERO, DVec3::new(3.0, 0.0, 3.0)).unwrap();
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    let cone = NurbsSurface::revolved(&side, axis, TAU).unwrap();
    let center = DVec3::new(1.0, 0.0, 0.5);
    let speed = |around: f64| {
        let (s, c) = libm::sincos(around);
        (2.0 * s * s + (c + 0.5) * (c + 0.5)).sqrt()
    };
    // Simpson's rule.
    let (n, end) = (2000, TAU / 3.0);
    let step = 2.0 * end / f64::from(n);
    let weight = |i: i32| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    let sum: f64 = (0..=n).map(|i| weight(i) * speed(f64::from(i) * step - end)).sum();
    check("the tip", [&cone, &sphere(center, center.length())], sum * step / 3.0);
}

/// The circle passes through the poles of the sphere.
#[test]
fn a_ball_that_touches_a_tube_along_a_circle_tells_all_of_it() {
    for n in 0..orientations() {
        let [a, b, c, _] = fractions(n);
        let minor = 0.3 + a;
        let major = minor * (1.1 + 2.0 * b);
        let (sin, cos) = libm::sincos(TAU * c);
        let ball = sphere(DVec3::new(major * cos, major * sin, 0.0), minor);
        let [a, b] = [torus(major, minor), ball]
            .map(|surface| Surface::Nurbs(Arc::new(surface.transformed(&turn(n)))));
        let found = a.intersections(&b, Tolerance::DEFAULT).expect("a circle");
        assert!((total(&found) / (TAU * minor) - 1.0).abs() < 2e-6, "{n}: {}", total(&found));
    }
}

/// The two curves that a sphere about the origin, turned about an axis, shares with a cylinder, each once.
#[track_caller]
fn check_whole(turned: DAffine3, ball: f64, tube: &NurbsSurface, lengths: &[f64]) {
    let ball = Surface::from(sphere(DVec3::ZERO, ball).transformed(&turned));
    let found = ball.intersections(&Surface::from(tube.clone()), Tolerance::DEFAULT).unwrap();
    assert_eq!(found.curves.len(), lengths.len(), "{found:?}");
    for (curve, length) in found.curves.iter().zip(lengths) {
        let far = curve.length(curve.domain()) / length - 1.0;
        assert!(far.abs() < 2e-6, "{far:e} of {length}");
    }
}

#[test]
fn a_circle_that_touches_the_seam_of_a_sphere_is_whole_at_every_size() {
    let axis = DVec3::new(1.0, 1.0, 0.0).normalize();
    let turned = DAffine3::from_axis_angle(axis, std::f64::consts::FRAC_PI_4);
    for n in 0..24 {
        let radius = 1.0 + 0.37 * f64::from(n);
        let tube = cylinder(DVec3::Z * (-4.0 * radius), radius, 8.0 * radius);
        check_whole(turned, 2.0 * radius, &tube, &[TAU * radius; 2]);
    }
}

#[test]
fn a_curve_that_crosses_itself_on_a_seam_is_told_wherever_the_poles_are() {
    for degrees in [15.0_f64, 45.0, 60.0, 75.0] {
        let turned = DAffine3::from_axis_angle(DVec3::X, degrees.to_radians());
        let tube = cylinder(DVec3::new(1.0, 0.0, -3.0), 1.0, 6.0);
        let half = 4.0 * 2f64.sqrt() * elliptic(0.5);
        check_whole(turned, 2.0, &tube, &[half; 2]);
    }
}

#[test]
fn a_plane_that_touches_a_thin_torus_twice_leaves_no_crumbs() {
    for n in 0..12 {
        let around = TAU / 12.0 * f64::from(n) + 0.1;
        for (major, minor) in [(10.0, 1.0), (14.0, 1.4), (5.0, 4.0)] {
            let (sine, cosine) = (minor / major, f64::sqrt(1.0 - minor * minor / major / major));
            let (s, c) = libm::sincos(around);
            let plane =
                Frame::from_normal(DVec3::ZERO, DVec3::new(sine * c, sine * s, cosine), None);
            let torus = Surface::from(torus(major, minor));
            let found = torus.section(plane.unwrap(), Tolerance::DEFAULT).unwrap();
            assert!((total(&found) / (2.0 * TAU * major) - 1.0).abs() < 2e-6, "{major}, {n}");
            let shortest = found.curves.iter().map(|curve| curve.length(curve.domain()));
            assert!(minor < shortest.fold(f64::INFINITY, f64::min), "{major}, {n}: {found:?}");
        }
    }
}
