//! What is asked of all of a function's curve, against the same curve as a NURBS: a Bézier curve
//! behind the interface of a function answers like itself.

use std::sync::Arc;

use glam::DVec3;
use proptest::prelude::*;
use virote_kernel::{
    Curve, CurveFunction, FunctionFailure, Interval, NurbsCurve, ParametricCurve, Tolerance,
};

/// A NURBS of which only points and derivatives are told.
#[derive(Debug)]
struct Hidden(NurbsCurve);

impl CurveFunction for Hidden {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        Ok(self.0.derivatives_at(t, order))
    }
}

fn hidden(curve: &NurbsCurve) -> Curve {
    ParametricCurve::new(curve.domain(), Arc::new(Hidden(curve.clone()))).unwrap().into()
}

fn bezier(points: &[(f64, f64)]) -> NurbsCurve {
    let points: Vec<DVec3> = points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    NurbsCurve::bezier(&points).unwrap()
}

fn plane_points() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((-9.0..9.0, -9.0..9.0), 3..7)
}

#[track_caller]
fn check_alike(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?} for {expected:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-7, "{found:?} for {expected:?}");
    }
}

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_function_is_as_long_and_as_large_as_the_spline(points in plane_points()) {
        let spline = bezier(&points);
        let function = hidden(&spline);
        let length = spline.length(spline.domain());
        prop_assert!((function.length(spline.domain()).unwrap() - length).abs() < 1e-11 * length);
        let (a, b) = (function.bounds().unwrap(), spline.bounds());
        prop_assert!(a.min.distance(b.min) < 1e-11 && a.max.distance(b.max) < 1e-11);
        let half = function.parameter_at_length(0.5 * length).unwrap();
        prop_assert!((half - spline.parameter_at_length(0.5 * length).unwrap()).abs() < 1e-9);
    }

    #[test]
    fn a_function_bends_and_turns_where_the_spline_does(points in plane_points()) {
        let spline = bezier(&points);
        let function = hidden(&spline);
        check_alike(&function.inflections(TOLERANCE).unwrap(), &spline.inflections(TOLERANCE));
        check_alike(
            &function.extrema(DVec3::Y, TOLERANCE).unwrap(),
            &spline.extrema(DVec3::Y, TOLERANCE),
        );
        prop_assert!(function.corners(TOLERANCE).unwrap().is_empty());
    }

    #[test]
    fn a_function_is_as_near_as_the_spline(points in plane_points(), x in -9.0..9.0, y in -9.0..9.0) {
        let (spline, p) = (bezier(&points), DVec3::new(x, y, 1.0));
        let (a, b) = (hidden(&spline).closest(p, 1e-9).unwrap(), spline.closest(p, 1e-9));
        prop_assert!((a.distance - b.distance).abs() < 1e-11);
    }

    #[test]
    fn edits_of_a_function_keep_its_points(points in plane_points(), at in 0.2..0.8) {
        let function = hidden(&bezier(&points));
        let [left, right] = function.split(at).unwrap();
        let backwards = function.reversed().unwrap();
        let slow = function.reparametrized(Interval::new(2.0, 6.0).unwrap()).unwrap();
        for t in [0.0, 0.1, 0.2, at, 0.9, 1.0] {
            let point = function.point_at(t).unwrap();
            let part = if t <= at { &left } else { &right };
            prop_assert_eq!(part.point_at(t).unwrap(), point);
            prop_assert!(backwards.point_at(1.0 - t).unwrap().distance(point) < 1e-12);
            prop_assert!(slow.point_at(2.0 + 4.0 * t).unwrap().distance(point) < 1e-12);
        }
        let whole = function.reversed().unwrap().reversed().unwrap();
        prop_assert_eq!(whole.end(), function.end());
    }
}

#[test]
fn what_goes_on_beyond_the_domain_keeps_its_length() {
    let parabola = hidden(&bezier(&[(0.0, 0.0), (1.0, 0.0), (2.0, 2.0)]));
    let longer = parabola.extended(3.0).unwrap();
    let grown = longer.length(longer.domain()).unwrap();
    let before = parabola.length(parabola.domain()).unwrap();
    assert!((grown - before - 3.0).abs() < 1e-11);
    let longer = parabola.extended_at_start(3.0).unwrap();
    assert!((longer.length(longer.domain()).unwrap() - before - 3.0).abs() < 1e-11);
    assert!(longer.domain().start() < 0.0);
}
