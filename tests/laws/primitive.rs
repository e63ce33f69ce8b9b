//! Laws of surfaces that turn, swing and slide, and of the round primitives made of them.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DAffine3, DQuat, DVec2, DVec3};
use proptest::{prelude::Strategy, prop_assert, prop_assume, proptest};
use virote_kernel::{
    Axis, AxisContact, CircleForm, ConstructionError, Frame, GeomError, NurbsCurve, NurbsSurface,
};

use crate::some::{affine_map, are_near, curve, fraction, point};

/// A frame somewhere, its normal in any direction.
fn frame() -> impl Strategy<Value = Frame> {
    (point(), point()).prop_filter_map("a normal", |(origin, normal)| {
        (0.1 < normal.length()).then(|| Frame::from_normal(origin, normal, None).ok()).flatten()
    })
}

fn axis() -> impl Strategy<Value = (Axis, DVec3, DVec3)> {
    frame().prop_map(|frame| {
        (Axis::new(frame.origin(), frame.z()).unwrap(), frame.origin(), frame.z())
    })
}

/// Height along an axis, and distance from it.
fn height_and_radius(p: DVec3, foot: DVec3, direction: DVec3) -> (f64, f64) {
    let height = (p - foot).dot(direction);
    (height, (p - foot - direction * height).length())
}

proptest! {
    #[test]
    fn turning_keeps_height_and_distance(
        profile in curve(), (axis, foot, direction) in axis(), turns in -1.0..1.0f64,
        f in fraction(), g in fraction(),
    ) {
        prop_assume!(turns.abs() > 1e-3);
        let surface = NurbsSurface::revolved(&profile, axis, turns * TAU).unwrap();
        let v = profile.domain().at(g);
        let (start, turned) = (profile.point_at(v), surface.point_at(f, v));
        let (before, after) = (height_and_radius(start, foot, direction), height_and_radius(turned, foot, direction));
        let size = 1.0 + start.length() + foot.length();
        prop_assert!((before.0 - after.0).abs() < 1e-13 * size);
        prop_assert!((before.1 - after.1).abs() < 1e-13 * size);
        prop_assert!(are_near(surface.point_at(0.0, v), start, 1e-13));
        // The far edge is turned by the whole angle.
        let by = DQuat::from_axis_angle(direction, turns * TAU);
        let end = foot + by * (start - foot);
        prop_assert!(are_near(surface.point_at(1.0, v), end, 1e-12));
        let n_pieces = surface.n_patches()[0];
        prop_assert!(n_pieces == (turns.abs() * 4.0).ceil() as usize);
    }

    #[test]
    fn a_profile_swung_around_a_circle_is_turned(
        profile in curve(), scale in 0.1..5.0, f in fraction(), g in fraction(),
    ) {
        let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
        let profile = profile.transformed(&flat);
        let circle = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
        let swung = NurbsSurface::swung(&profile, &circle, scale).unwrap();
        let wide = profile.transformed(&DAffine3::from_scale(DVec3::new(scale, 1.0, 1.0)));
        let turned = NurbsSurface::revolved(&wide, Axis::new(DVec3::ZERO, DVec3::Z).unwrap(), TAU).unwrap();
        let t = profile.domain().at(f);
        prop_assert!(are_near(swung.point_at(t, g), turned.point_at(g, t), 1e-13));
    }

    #[test]
    fn a_swung_surface_is_its_formula(
        profile in curve(), trajectory in curve(), scale in -5.0..5.0, f in fraction(), g in fraction(),
    ) {
        let surface = NurbsSurface::swung(&profile, &trajectory, scale).unwrap();
        let (u, v) = (profile.domain().at(f), trajectory.domain().at(g));
        let (p, t) = (profile.point_at(u), trajectory.point_at(v));
        let formula = DVec3::new(scale * p.x * t.x, scale * p.x * t.y, p.z);
        prop_assert!(are_near(surface.point_at(u, v), formula, 1e-12));
    }

    #[test]
    fn an_extruded_curve_slides_along_its_vector(
        c in curve(), vector in point(), map in affine_map(), f in fraction(), g in fraction(),
    ) {
        let surface = NurbsSurface::extruded(&c, vector).unwrap();
        let u = c.domain().at(f);
        prop_assert!(are_near(surface.point_at(u, g), c.point_at(u) + vector * g, 1e-12));
        let moved = NurbsSurface::extruded(&c.transformed(&map), map.transform_vector3(vector)).unwrap();
        prop_assert!(are_near(moved.point_at(u, g), map.transform_point3(surface.point_at(u, g)), 1e-12));
    }

    #[test]
    fn the_points_of_round_primitives_satisfy_their_equations(
        frame in frame(), r in 0.1..10.0, s in 0.0..10.0, h in 0.1..10.0, u in fraction(), v in fraction(),
    ) {
        let local = |surface: &NurbsSurface| frame.from_space().transform_point3(surface.point_at(u, v));
        // Rounding of coordinates of this size.
        let rounding = 1e-14 * (1.0 + frame.origin().length() + r + s + h);

        let ball = local(&NurbsSurface::sphere(frame, r).unwrap());
        prop_assert!((ball.length() - r).abs() < rounding);
        let wall = local(&NurbsSurface::cone(frame, [r; 2], h).unwrap());
        prop_assert!((wall.truncate().length() - r).abs() < rounding);
        prop_assert!((wall.z - h * v).abs() < rounding);
        let cone = local(&NurbsSurface::cone(frame, [r, s], h).unwrap());
        prop_assert!((cone.truncate().length() - (r + (s - r) * v)).abs() < rounding);
        prop_assert!((cone.z - h * v).abs() < rounding);
        let ring = local(&NurbsSurface::torus(frame, s + r, r).unwrap());
        let from_tube = DVec2::new(ring.truncate().length() - (s + r), ring.z).length();
        prop_assert!((from_tube - r).abs() < rounding);
    }

    #[test]
    fn round_primitives_look_outward(
        frame in frame(), r in 0.1..10.0, s in 0.0..10.0, u in fraction(), v in fraction(),
    ) {
        let up = frame.from_space();
        let outward = |surface: &NurbsSurface| {
            (up.transform_point3(surface.point_at(u, v)), up.transform_vector3(surface.normal_at(u, v).unwrap()))
        };
        let (p, n) = outward(&NurbsSurface::sphere(frame, r).unwrap());
        prop_assert!(n.distance(p / r) < 1e-11);
        let (p, n) = outward(&NurbsSurface::cone(frame, [r; 2], s + 1.0).unwrap());
        prop_assert!(n.distance((p / r).with_z(0.0)) < 1e-11);
        let (p, n) = outward(&NurbsSurface::cone(frame, [r, 0.0], s + 1.0).unwrap());
        prop_assert!(0.0 < n.z && (1.0 <= v || 0.0 < n.dot(p.with_z(0.0))));
        let (_, n) = outward(&NurbsSurface::cone(frame, [r, 0.0], 0.0).unwrap());
        prop_assert!(n.distance(DVec3::Z) < 1e-11);
        let (p, n) = outward(&NurbsSurface::torus(frame, s + 1.5 * r, r).unwrap());
        let middle = p.with_z(0.0).normalize() * (s + 1.5 * r);
        prop_assert!(n.distance((p - middle) / r) < 1e-10);
    }
}

#[test]
fn a_crossing_of_the_axis_is_told_and_a_pole_is_none() {
    let z = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    let contacts = |points: &[DVec3]| z.contacts(&NurbsCurve::polyline(points).unwrap(), 1e-6);
    let at = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    // From x = −1 to 3 on one unit of parameter: at a quarter.
    let found = contacts(&[at(-1.0, 0.0), at(3.0, 1.0)]).unwrap();
    let [AxisContact::Place { parameter, is_crossing: true }] = found[..] else {
        panic!("{found:?}")
    };
    assert!((parameter - 0.25).abs() < 1e-12);
    // A polygon that touches with its corner.
    let found = contacts(&[at(1.0, 0.0), at(0.0, 1.0), at(1.0, 2.0)]).unwrap();
    assert!(matches!(found[..], [AxisContact::Place { is_crossing: false, .. }]), "{found:?}");
    // Poles at both ends, and a curve that stays away.
    assert_eq!(contacts(&[at(0.0, 0.0), at(1.0, 1.0), at(0.0, 2.0)]), Ok(vec![]));
    assert_eq!(contacts(&[at(1.0, 0.0), at(2.0, 1.0)]), Ok(vec![]));
    // A side along the axis.
    let found = contacts(&[at(1.0, 0.0), at(0.0, 0.0), at(0.0, 3.0), at(1.0, 3.0)]).unwrap();
    let [AxisContact::Stretch { start, end }] = found[..] else { panic!("{found:?}") };
    assert!((start - 1.0).abs() < 1e-5 && (end - 2.0).abs() < 1e-5);
    assert_eq!(
        contacts(&[at(0.0, 0.0), at(0.0, 3.0)]),
        Err(GeomError::Construction(ConstructionError::OnAxis))
    );
    // Askew, at a distance: a hyperboloid.
    assert_eq!(contacts(&[DVec3::new(-1.0, 1.0, 0.0), DVec3::new(1.0, 1.0, 1.0)]), Ok(vec![]));
}

#[test]
fn poles_are_points_and_seams_close_to_the_bit() {
    let frame =
        Frame::from_normal(DVec3::new(3.0, -2.0, 7.0), DVec3::new(1.0, 2.0, 2.0), None).unwrap();
    let sphere = NurbsSurface::sphere(frame, 2.5).unwrap();
    for i in 0..=40 {
        let t = f64::from(i) / 40.0;
        assert!(sphere.point_at(t, 0.0).distance(frame.point(DVec3::Z * -2.5)) < 1e-14);
        assert!(sphere.point_at(t, 1.0).distance(frame.point(DVec3::Z * 2.5)) < 1e-14);
        assert_eq!(sphere.point_at(0.0, t), sphere.point_at(1.0, t));
    }
    let quarter = NurbsSurface::revolved(
        &NurbsCurve::line(DVec3::X, DVec3::new(1.0, 0.0, 2.0)).unwrap(),
        Axis::new(DVec3::ZERO, DVec3::Z).unwrap(),
        FRAC_PI_2,
    );
    assert_eq!(quarter.unwrap().point_at(1.0, 1.0), DVec3::new(0.0, 1.0, 2.0));
}
