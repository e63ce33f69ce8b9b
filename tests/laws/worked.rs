//! Worked examples: I. Linkeová, *Curves and surfaces for computer graphics*; J. Vukašinović and
//! J. Duhovnik, *Advanced CAD Modeling*; and the messages that a person reads.

use glam::DVec3;
use virote_kernel::{GeomError, Grid, Interval, KnotError, KnotVector, NurbsCurve, WeightError};

fn plane(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

#[track_caller]
fn check_near(got: DVec3, expected: [f64; 2]) {
    let expected = DVec3::new(expected[0], expected[1], 0.0);
    assert!(got.distance(expected) < 1e-12, "{got} instead of {expected}");
}

#[track_caller]
fn check_bezier(polygon: &[[f64; 2]], at: &[(f64, [f64; 2], [f64; 2])]) {
    let curve = NurbsCurve::bezier(&plane(polygon)).unwrap();
    for &(t, point, derivative) in at {
        let derivatives = curve.derivatives_at(t, 1);
        check_near(derivatives[0], point);
        check_near(derivatives[1], derivative);
    }
}

#[test]
fn example_2_3_a_bezier_curve() {
    check_bezier(
        &[[2.0, 0.0], [4.0, 1.0], [3.0, 2.0]],
        &[
            (0.0, [2.0, 0.0], [4.0, 2.0]),
            (0.25, [2.8125, 0.5], [2.5, 2.0]),
            (0.5, [3.25, 1.0], [1.0, 2.0]),
            (0.75, [3.3125, 1.5], [-0.5, 2.0]),
            (1.0, [3.0, 2.0], [-2.0, 2.0]),
        ],
    );
}

#[test]
fn example_2_4_a_bezier_cubic() {
    check_bezier(
        &[[2.0, 3.0], [4.0, 2.0], [0.0, 0.0], [-1.0, 1.0]],
        &[
            (0.0, [2.0, 3.0], [6.0, -3.0]),
            (0.25, [2.515625, 2.125], [-1.3125, -3.75]),
            (0.5, [1.625, 1.25], [-5.25, -3.0]),
            (0.75, [0.171875, 0.75], [-5.8125, -0.75]),
            (1.0, [-1.0, 1.0], [-3.0, 3.0]),
        ],
    );
}

#[test]
fn example_2_7_a_bezier_curve_of_degree_six() {
    check_bezier(
        &[[0.0, 2.0], [7.0, 9.0], [17.0, 9.0], [20.0, 4.0], [16.0, 0.0], [10.0, 0.0], [6.0, 4.0]],
        &[
            (0.0, [0.0, 2.0], [42.0, 42.0]),
            (0.5, [15.671875, 4.296875], [2.4375, -14.8125]),
            (1.0, [6.0, 4.0], [-24.0, 24.0]),
        ],
    );
}

#[track_caller]
fn check_clamped(polygon: &[[f64; 2]], pieces: &[[[f64; 2]; 4]]) {
    let n_segments = polygon.len() - 3;
    let knots = KnotVector::uniform_clamped(3, polygon.len(), n_segments as f64).unwrap();
    let curve = NurbsCurve::polynomial(knots, &plane(polygon)).unwrap();
    assert_eq!(curve.n_segments(), n_segments);
    for (piece, expected) in curve.decompose().iter().zip(pieces) {
        for (&point, &expected) in piece.points().iter().zip(expected) {
            check_near(point, expected);
        }
    }
}

#[test]
fn exercise_2_26_a_a_clamped_cubic_as_bezier_cubics() {
    check_clamped(
        &[[1.0, 1.0], [3.0, 1.0], [5.0, 7.0], [7.0, 1.0], [9.0, 4.0]],
        &[
            [[1.0, 1.0], [3.0, 1.0], [4.0, 4.0], [5.0, 4.0]],
            [[5.0, 4.0], [6.0, 4.0], [7.0, 1.0], [9.0, 4.0]],
        ],
    );
}

#[test]
fn exercise_2_26_b_a_clamped_cubic_as_bezier_cubics() {
    check_clamped(
        &[[4.0, 1.0], [1.0, 3.0], [1.0, 7.0], [7.0, 7.0], [7.0, 3.0], [10.0, 1.0]],
        &[
            [[4.0, 1.0], [1.0, 3.0], [1.0, 5.0], [2.0, 6.0]],
            [[2.0, 6.0], [3.0, 7.0], [5.0, 7.0], [6.0, 6.0]],
            [[6.0, 6.0], [7.0, 5.0], [7.0, 3.0], [10.0, 1.0]],
        ],
    );
}

#[test]
fn exercise_2_26_c_a_clamped_cubic_as_bezier_cubics() {
    check_clamped(
        &[[3.0, 1.0], [1.0, 3.0], [3.0, 7.0], [6.0, 1.0], [9.0, 7.0], [7.0, 7.0], [6.0, 5.0]],
        &[
            [[3.0, 1.0], [1.0, 3.0], [2.0, 5.0], [3.0, 5.0]],
            [[3.0, 5.0], [4.0, 5.0], [5.0, 3.0], [6.0, 3.0]],
            [[6.0, 3.0], [7.0, 3.0], [8.0, 5.0], [8.0, 6.0]],
            [[8.0, 6.0], [8.0, 7.0], [7.0, 7.0], [6.0, 5.0]],
        ],
    );
}

#[test]
fn exercise_2_26_d_a_clamped_cubic_as_bezier_cubics() {
    check_clamped(
        &[
            [4.0, 5.0],
            [3.0, 7.0],
            [1.0, 7.0],
            [4.0, 1.0],
            [7.0, 7.0],
            [10.0, 1.0],
            [8.0, 1.0],
            [7.0, 3.0],
        ],
        &[
            [[4.0, 5.0], [3.0, 7.0], [2.0, 7.0], [2.0, 6.0]],
            [[2.0, 6.0], [2.0, 5.0], [3.0, 3.0], [4.0, 3.0]],
            [[4.0, 3.0], [5.0, 3.0], [6.0, 5.0], [7.0, 5.0]],
            [[7.0, 5.0], [8.0, 5.0], [9.0, 3.0], [9.0, 2.0]],
            [[9.0, 2.0], [9.0, 1.0], [8.0, 1.0], [7.0, 3.0]],
        ],
    );
}

#[test]
fn example_1_19_the_basis_of_seven_points() {
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 4.0, 4.0];
    let knots = KnotVector::for_points(3, 7, knots).unwrap();
    let expected = [
        (0.0, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        (0.5, [0.125, 0.59375, 0.2604166666666667, 0.020833333333333332, 0.0, 0.0, 0.0]),
        (1.0, [0.0, 0.25, 0.5833333333333334, 0.16666666666666666, 0.0, 0.0, 0.0]),
        (1.5, [0.0, 0.03125, 0.46875, 0.4791666666666667, 0.020833333333333332, 0.0, 0.0]),
        (2.0, [0.0, 0.0, 0.16666666666666666, 0.6666666666666666, 0.16666666666666666, 0.0, 0.0]),
        (3.5, [0.0, 0.0, 0.0, 0.020833333333333332, 0.2604166666666667, 0.59375, 0.125]),
        (4.0, [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    ];
    for (t, expected) in expected {
        let span = knots.span_at(t);
        let mut values = [0.0; 4];
        knots.basis_at(span, t, &mut values);
        for (i, expected) in expected.into_iter().enumerate() {
            let got = if knots.support(span).contains(&i) { values[i + 3 - span] } else { 0.0 };
            assert!((got - expected).abs() < 1e-15, "N{i}({t}) = {got} instead of {expected}");
        }
    }
}

#[track_caller]
fn check_message(error: &GeomError, expected: &str) {
    assert_eq!(error.to_string(), expected);
}

#[test]
fn errors_say_what_was_expected_and_what_was_found() {
    let points = plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
    let knots = |knots: &[f64]| KnotVector::for_points(2, 3, knots.to_vec()).unwrap_err();
    check_message(
        &knots(&[0.0, 0.0, 0.0, 1.0, 1.0]),
        "3 control points of degree 2 need 6 knots, got 5",
    );
    check_message(
        &knots(&[0.0, 0.0, 0.0, 0.5, 0.2, 1.0]),
        "knot 4 is 0.2, below the 0.5 before it; knots never decrease",
    );
    check_message(
        &Grid::from_rows(vec![vec![0; 4], vec![0; 4], vec![0; 3]]).unwrap_err(),
        "row 2 has 3 points, row 0 has 4; every row needs the same number",
    );
    check_message(
        &Interval::UNIT.clamp_inside(1.5).unwrap_err(),
        "parameter 1.5 is outside the domain 0..1",
    );
    let bezier = KnotVector::bezier(2).unwrap();
    let weights =
        |weights: [f64; 3]| NurbsCurve::rational(bezier.clone(), &points, &weights).unwrap_err();
    check_message(&weights([1.0, -2.0, 1.0]), "weight 1 is -2; weights are not negative");
    check_message(
        &weights([1.0, 1.0, 0.0]),
        "weight 2 is 0; the first and the last weight are positive",
    );
}

#[test]
fn weights_that_vanish_together_are_refused() {
    let knots = KnotVector::uniform_clamped(1, 3, 2.0).unwrap();
    let points = plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
    assert_eq!(
        NurbsCurve::rational(knots, &points, &[1.0, 0.0, 1.0]),
        Err(GeomError::Weights(WeightError::VanishingWeights { parameter: 1.0 }))
    );
}

#[test]
fn knots_too_close_to_tell_apart_are_one() {
    let almost = 0.5 + 1e-14;
    let knots = KnotVector::new(1, vec![0.0, 0.0, 0.5, almost, 1.0, 1.0]).unwrap();
    assert_eq!(knots.multiplicity(0.5), 2);
    let broken = KnotVector::new(1, vec![0.0, 0.0, 0.5, almost, almost, 1.0, 1.0]);
    assert_eq!(
        broken,
        Err(GeomError::Knots(KnotError::KnotMultiplicity {
            index: 2,
            knot: 0.5,
            times: 3,
            most: 2
        }))
    );
}
