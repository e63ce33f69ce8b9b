//! Laws of offsets of surfaces.

use glam::DVec3;
use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{
    CircleForm, ConstructionError, Direction, GeomError, Grid, Interval, KnotVector, LocalError,
    NurbsCurve, NurbsSurface, Surface,
};

use crate::some::sphere;

/// Gently waved surfaces over a square, rational or not, with knots.
fn waved() -> impl Strategy<Value = NurbsSurface> {
    (vec(-0.6..0.6, 30), vec(0.5..2.0, 30)).prop_map(|(heights, weights)| {
        let knots_u = KnotVector::new(3, vec![0.0, 0.0, 0.0, 0.0, 0.4, 0.7, 1.0, 1.0, 1.0, 1.0]);
        let knots_v = KnotVector::new(2, vec![0.0, 0.0, 0.0, 0.5, 0.8, 1.0, 1.0, 1.0]);
        let points = Grid::from_fn(6, 5, |i, j| {
            DVec3::new(2.0 * i as f64, 2.0 * j as f64, heights[5 * i + j])
        });
        let weights = Grid::new(6, 5, weights).unwrap();
        NurbsSurface::rational(knots_u.unwrap(), knots_v.unwrap(), &points, &weights).unwrap()
    })
}

/// The largest distance from the true offset at many places that no method looked at.
fn measured(s: &NurbsSurface, offset: &NurbsSurface, distance: f64) -> f64 {
    let mut most: f64 = 0.0;
    for u in s.domain_u().steps(61) {
        for v in s.domain_v().steps(53) {
            let Ok(normal) = s.normal_at(u, v) else { continue };
            let true_point = s.point_at(u, v) + normal * distance;
            most = most.max(offset.point_at(u, v).distance(true_point));
        }
    }
    most
}

proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(12))]

    #[test]
    fn an_offset_of_a_surface_is_within_its_tolerance(s in waved(), distance in -1.0..1.0) {
        let tolerance = 1e-4;
        let offset = Surface::from(s.clone()).offset(distance, tolerance).unwrap();
        prop_assert!(offset.deviation <= tolerance);
        let found = measured(&s, &offset.surface, distance);
        prop_assert!(found <= tolerance, "{found}");
    }
}

#[test]
fn spheres_cylinders_cones_and_planes_have_exact_offsets() {
    let ball = sphere(DVec3::new(1.0, 2.0, 3.0), 5.0);
    let offset = Surface::from(ball.clone()).offset(1.5, 1e-6).unwrap();
    assert!(offset.is_exact && offset.surface.knots_u() == ball.knots_u());
    for u in Interval::UNIT.steps(40) {
        for v in Interval::UNIT.steps(40) {
            let radius = offset.surface.point_at(u, v).distance(DVec3::new(1.0, 2.0, 3.0));
            assert!((radius - 6.5).abs() < 1e-12, "{radius} at ({u}, {v})");
        }
    }
    let circle = |radius: f64, z: f64| {
        NurbsCurve::circle(DVec3::Z * z, radius, DVec3::X, DVec3::Z, CircleForm::NinePoint)
    };
    let (low, high) = (circle(2.0, 0.0).unwrap(), circle(1.0, 3.0).unwrap());
    let cone: Surface = NurbsSurface::ruled(&low, &high).unwrap().into();
    let offset = cone.offset(0.5, 1e-6).unwrap();
    assert!(offset.is_exact && offset.turn.is_none());
    let plane: Surface =
        NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0))
            .unwrap()
            .into();
    let lifted = plane.offset(2.0, 1e-6).unwrap();
    assert!(lifted.is_exact && (lifted.surface.point_at(0.3, 0.4).z - 2.0).abs() < 1e-15);
}

#[test]
fn an_offset_beyond_the_radius_tells_where_it_turns_back() {
    // z = x² / 2 bends with radius 1 along x = 0, towards +z.
    let points = Grid::from_fn(3, 2, |i, j| {
        let x = i as f64 - 1.0;
        DVec3::new(x, j as f64, if i == 1 { -0.5 } else { 0.5 })
    });
    let trough: Surface = NurbsSurface::bezier(&points).unwrap().into();
    let inside = trough.offset(0.9, 1e-6).unwrap();
    assert!(inside.turn.is_none());
    let beyond = trough.offset(1.25, 1e-6).unwrap();
    let turn = beyond.turn.unwrap();
    assert!((turn.radius - 1.0).abs() < 1e-9 && (turn.at[0] - 0.5).abs() < 1e-4, "{turn:?}");
    let outside = trough.offset(-1.25, 1e-6).unwrap();
    assert!(outside.turn.is_none());
}

#[test]
fn creases_and_places_without_a_normal_are_refused() {
    let points =
        Grid::from_fn(3, 2, |i, j| DVec3::new(i as f64, j as f64, if i == 1 { 1.0 } else { 0.0 }));
    let knots = |degree, knots: &[f64]| KnotVector::new(degree, knots.to_vec()).unwrap();
    let roof = NurbsSurface::polynomial(
        knots(1, &[0.0, 0.0, 0.5, 1.0, 1.0]),
        knots(1, &[0.0, 0.0, 1.0, 1.0]),
        &points,
    );
    match Surface::from(roof.unwrap()).offset(1.0, 1e-6) {
        // The normals of the two halves are at right angles.
        Err(GeomError::Construction(ConstructionError::Crease { along: "u", parameter, gap })) => {
            assert!((parameter - 0.5).abs() < 1e-15);
            assert!((gap - std::f64::consts::SQRT_2).abs() < 1e-12);
        }
        other => panic!("{other:?}"),
    }
    // (t², t³, v) has a cuspidal edge at t = 0, where the normal leaps.
    let row = [(1.0, -1.0), (-1.0 / 3.0, 1.0), (-1.0 / 3.0, -1.0), (1.0, 1.0)];
    let cusp = Grid::from_fn(4, 2, |i, j| DVec3::new(row[i].0, row[i].1, j as f64));
    let cusp = Surface::from(NurbsSurface::bezier(&cusp).unwrap());
    match cusp.offset(0.1, 1e-6) {
        Err(GeomError::Local(LocalError::NoNormal { u, .. })) => assert!((u - 0.5).abs() < 1e-12),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_tip_of_a_cone_opens_into_an_arc() {
    let rim = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let cone = Grid::from_fn(3, 2, |i, j| match j {
        0 => DVec3::new(rim[i].0, rim[i].1, 0.0),
        _ => DVec3::Z,
    });
    let cone = NurbsSurface::bezier(&cone).unwrap();
    let offset = Surface::from(cone.clone()).offset(0.1, 1e-6).unwrap();
    assert!(measured(&cone, &offset.surface, 0.1) <= 1e-6);
    for u in Interval::UNIT.steps(8) {
        assert!((offset.surface.point_at(u, 1.0).distance(DVec3::Z) - 0.1).abs() <= 1e-6);
    }
}

#[test]
fn an_offset_of_an_offset_back_is_the_surface() {
    let points =
        Grid::from_fn(4, 4, |i, j| DVec3::new(i as f64, j as f64, 0.1 * ((i * j) % 3) as f64));
    let s = NurbsSurface::bezier(&points).unwrap();
    let there = Surface::from(s.clone()).offset(0.25, 1e-7).unwrap();
    let back = Surface::from(there.surface).offset(-0.25, 1e-7).unwrap().surface;
    for u in Interval::UNIT.steps(20) {
        for v in Interval::UNIT.steps(20) {
            assert!(back.point_at(u, v).distance(s.point_at(u, v)) < 1e-5);
        }
    }
    assert_eq!(back.domain(Direction::U), s.domain(Direction::U));
}
