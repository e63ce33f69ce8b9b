//! Laws of length and extent.

use std::f64::consts::PI;

use glam::DVec3;
use proptest::{prop_assert, proptest};
use virote_kernel::{Bounds, CircleForm, Interval, KnotVector, NurbsCurve};

use crate::some::{affine_map, curve, sphere, surface};

/// Parameters close together in every span.
fn fine(knots: &KnotVector) -> Vec<f64> {
    knots.spans().flat_map(|span| knots.span_interval(span).steps(100)).collect()
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(64))]

    #[test]
    fn bounds_of_a_curve_hold_it_and_are_touched(curve in curve()) {
        let bounds = curve.bounds();
        let samples: Vec<DVec3> =
            curve.decompose().iter().flat_map(|piece| piece.sample(4001)).collect();
        prop_assert!(samples.iter().all(|&point| bounds.contains(point, 1e-12)));
        let touched = Bounds::of(samples).unwrap();
        let slack = 1e-3 * (1.0 + bounds.diagonal());
        prop_assert!((touched.min - bounds.min).max_element() < slack);
        prop_assert!((bounds.max - touched.max).max_element() < slack);
    }

    #[test]
    fn bounds_of_a_surface_hold_it_and_are_touched(s in surface()) {
        let bounds = s.bounds();
        let samples = s.points_on_grid(&fine(s.knots_u()), &fine(s.knots_v()));
        prop_assert!(samples.iter().all(|&point| bounds.contains(point, 1e-12)));
        let touched = Bounds::of(samples.iter().copied()).unwrap();
        let slack = 2e-2 * (1.0 + bounds.diagonal());
        prop_assert!((touched.min - bounds.min).max_element() < slack);
        prop_assert!((bounds.max - touched.max).max_element() < slack);
    }

    #[test]
    fn length_adds_up(curve in curve(), f in 0.1..0.9) {
        let domain = curve.domain();
        let middle = domain.at(f);
        let left = curve.length(Interval::new(domain.start(), middle).unwrap());
        let right = curve.length(Interval::new(middle, domain.end()).unwrap());
        let whole = curve.length(domain);
        prop_assert!((left + right - whole).abs() < 1e-11 * whole, "{left} + {right} != {whole}");
    }

    #[test]
    fn length_is_that_of_a_fine_polygon(curve in curve()) {
        let whole = curve.length(curve.domain());
        let polygon: f64 = curve.decompose().iter().map(|piece| {
            piece.sample(4001).windows(2).map(|leg| leg[0].distance(leg[1])).sum::<f64>()
        }).sum();
        prop_assert!(polygon <= whole * (1.0 + 1e-11));
        prop_assert!(whole - polygon < 1e-4 * whole);
    }
}

#[test]
fn the_length_of_a_circle_is_two_pi_r() {
    for form in CircleForm::ALL {
        let circle = NurbsCurve::circle(DVec3::ONE, 3.0, DVec3::X, DVec3::ONE, form).unwrap();
        let length = circle.length(circle.domain());
        assert!((length / (6.0 * PI) - 1.0).abs() < 1e-13, "{form:?}: {length}");
    }
}

#[test]
fn the_length_of_a_cusp_is_its_closed_form() {
    // (t², t³) on −1..1: ∫ |t|·√(4 + 9t²) = 2·(13^(3/2) − 8)/27.
    let third = 1.0 / 3.0;
    let points = [[1.0, -1.0], [-third, 1.0], [-third, -1.0], [1.0, 1.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    let cusp = NurbsCurve::bezier(&points).unwrap();
    let expected = 2.0 * (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
    assert!((cusp.length(cusp.domain()) - expected).abs() < 1e-12);
}

#[test]
fn the_box_of_a_tilted_circle_is_its_closed_form() {
    // In direction e a circle about n reaches r·√(1 − (n·e)²).
    let normal = DVec3::new(1.0, 2.0, -3.0).normalize();
    for form in CircleForm::ALL {
        let circle = NurbsCurve::circle(DVec3::ONE, 2.0, DVec3::X, normal, form).unwrap();
        let reach = normal.to_array().map(|n| 2.0 * (1.0 - n * n).sqrt());
        let bounds = circle.bounds();
        assert!(bounds.max.distance(DVec3::ONE + DVec3::from(reach)) < 1e-14, "{form:?}");
        assert!(bounds.min.distance(DVec3::ONE - DVec3::from(reach)) < 1e-14, "{form:?}");
    }
}

#[test]
fn the_box_of_a_sphere_is_a_cube() {
    let bounds = sphere(DVec3::ONE, 2.0).bounds();
    assert!(bounds.min.distance(DVec3::splat(-1.0)) < 1e-14);
    assert!(bounds.max.distance(DVec3::splat(3.0)) < 1e-14);
}

#[test]
fn the_box_of_an_ellipsoid_askew_is_its_closed_form() {
    use proptest::{
        strategy::{Strategy, ValueTree},
        test_runner::TestRunner,
    };
    // The image of the unit sphere reaches |row of the matrix| along each axis.
    let mut runner = TestRunner::deterministic();
    for _ in 0..5 {
        let map = affine_map().new_tree(&mut runner).unwrap().current();
        let bounds = sphere(DVec3::ZERO, 1.0).transformed(&map).bounds();
        let rows = map.matrix3.transpose();
        let reach = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
        assert!(bounds.max.distance(map.translation + reach) < 1e-12);
        assert!(bounds.min.distance(map.translation - reach) < 1e-12);
    }
}
