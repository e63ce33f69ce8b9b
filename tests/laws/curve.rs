//! Laws of curves.

use glam::{DMat4, DVec3, DVec4};
use proptest::{collection::vec, prop_assert, prop_assume, proptest};
use virote_kernel::{
    CircleForm, Curve, Frame, GeomError, Interval, KnotVector, NurbsCurve, Side, WeightError,
    make_compatible,
};

use crate::some::{affine_map, are_near, curve, fraction, knots, parameter, point};

/// Whether both curves have the same points at the same parameters.
pub(crate) fn are_same(a: &NurbsCurve, b: &NurbsCurve, tolerance: f64) -> bool {
    (0..=40).all(|i| {
        let f = f64::from(i) / 40.0;
        are_near(a.point_at(parameter(a, f)), b.point_at(parameter(b, f)), tolerance)
    })
}

/// How often numbers change their sign; zeros have none.
fn changes_of_sign(numbers: impl Iterator<Item = f64>) -> usize {
    let signs: Vec<bool> = numbers.filter(|x| *x != 0.0).map(|x| 0.0 < x).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

proptest! {
    #[test]
    fn affine_invariance(curve in curve(), map in affine_map(), f in fraction()) {
        let t = parameter(&curve, f);
        let moved_point = map.transform_point3(curve.point_at(t));
        prop_assert!(are_near(curve.transformed(&map).point_at(t), moved_point, 1e-12));
    }

    #[test]
    fn convex_hull_in_every_coordinate(curve in curve(), f in fraction()) {
        let point = curve.point_at(parameter(&curve, f));
        let points = curve.points();
        let low = points.iter().copied().reduce(DVec3::min).unwrap();
        let high = points.iter().copied().reduce(DVec3::max).unwrap();
        prop_assert!((low - 1e-13).cmple(point).all() && point.cmple(high + 1e-13).all());
    }

    #[test]
    fn every_point_is_in_the_hull_of_the_points_that_act_there(
        curve in curve(), f in fraction(), direction in point(),
    ) {
        let t = parameter(&curve, f);
        let support = curve.knots().support(curve.knots().span_at(t));
        let points = curve.points();
        let heights = points[support].iter().map(|point| point.dot(direction));
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
            (low.min(height), high.max(height))
        });
        let height = curve.point_at(t).dot(direction);
        prop_assert!(low - 1e-11 <= height && height <= high + 1e-11);
    }

    #[test]
    fn no_plane_meets_the_curve_more_often_than_its_polygon(
        curve in curve(), normal in point(), through in point(),
    ) {
        let height = |point: DVec3| (point - through).dot(normal);
        let of_curve = (0..=500).map(|i| height(curve.point_at(parameter(&curve, f64::from(i) / 500.0))));
        let of_polygon = changes_of_sign(curve.points().into_iter().map(height));
        prop_assert!(changes_of_sign(of_curve) <= of_polygon);
    }

    #[test]
    fn a_convex_polygon_makes_a_convex_curve(
        knots in knots(), turns in vec(0.01..1.0, 21), legs in vec(0.1..9.0, 21), f in fraction(),
    ) {
        // All turns to the left, half a turn together.
        let n = knots.n_points();
        let unit = std::f64::consts::PI / turns[..n].iter().sum::<f64>();
        let (mut point, mut angle, mut points) = (DVec3::ZERO, 0.0_f64, Vec::new());
        for (turn, leg) in turns[..n].iter().zip(&legs) {
            points.push(point);
            angle += unit * turn;
            point += leg * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        }
        let curve = NurbsCurve::rational(knots, &points, &vec![1.0; n]).unwrap();
        let derivatives = curve.derivatives_at(parameter(&curve, f), 2);
        let bend = derivatives[1].cross(derivatives[2]).z;
        prop_assert!(-1e-12 * derivatives[1].length() * derivatives[2].length() <= bend);
    }

    #[test]
    fn local_support(curve in curve(), f in fraction(), to in point()) {
        let t = parameter(&curve, f);
        let support = curve.knots().support(curve.knots().span_at(t));
        let elsewhere = |(i, point)| if support.contains(&i) { point } else { to };
        let points: Vec<DVec3> = curve.points().into_iter().enumerate().map(elsewhere).collect();
        let changed =
            NurbsCurve::rational(curve.knots().clone(), &points, &curve.weights()).unwrap();
        prop_assert!(are_near(curve.point_at(t), changed.point_at(t), 1e-14));
    }

    #[test]
    fn clamped_curves_begin_and_end_at_their_end_points(curve in curve()) {
        let clamped = curve.clamped();
        prop_assert!(are_near(clamped.start(), clamped.points()[0], 1e-15));
        prop_assert!(are_near(clamped.end(), clamped.points()[clamped.points().len() - 1], 1e-15));
        prop_assert!(are_near(curve.start(), clamped.start(), 1e-13));
        prop_assert!(are_near(curve.end(), clamped.end(), 1e-13));
    }

    #[test]
    fn end_derivative_of_a_clamped_curve(curve in curve()) {
        // p / (u_{p+1} − u_p) · w₁/w₀ · (P₁ − P₀).
        let curve = curve.clamped();
        let (p, u) = (curve.degree(), curve.knots().as_slice());
        let (points, weights) = (curve.points(), curve.weights());
        let factor = p as f64 / (u[p + 1] - u[p]) * weights[1] / weights[0];
        let derivative = curve.derivatives_at(curve.domain().start(), 1)[1];
        prop_assert!(are_near(derivative, (points[1] - points[0]) * factor, 1e-12));
    }

    #[test]
    fn derivatives_are_the_limits_of_difference_quotients(
        curve in curve(), which in 0..10usize, f in 0.1..0.9, order in 1..=3usize,
    ) {
        let spans: Vec<usize> = curve.knots().spans().collect();
        let span = curve.knots().span_interval(spans[which % spans.len()]);
        let (t, h) = (span.at(f), 1e-5 * span.length());
        let below = |t: f64| curve.derivatives_at(t, order - 1)[order - 1];
        let quotient = (below(t + h) - below(t - h)) / (2.0 * h);
        let derivatives = curve.derivatives_at(t, order + 2);
        let width = span.length();
        let scale: f64 = [order - 1, order, order + 2]
            .map(|k| derivatives[k].length() * libm::pow(width, k as f64))
            .into_iter().fold(1.0, f64::max) / libm::pow(width, order as f64);
        prop_assert!(derivatives[order].distance(quotient) < 1e-8 * scale);
    }

    #[test]
    fn knot_insertion_leaves_the_curve_in_place(curve in curve(), fs in [fraction(), fraction()]) {
        let inside = |f: f64| parameter(&curve, 0.001 + 0.998 * f);
        let refined = curve.insert_knots(&fs.map(inside));
        prop_assume!(refined.is_ok());
        let refined = refined.unwrap();
        prop_assert!(refined.points().len() == curve.points().len() + 2);
        prop_assert!(are_same(&curve, &refined, 1e-12));
    }

    #[test]
    fn degree_elevation_leaves_the_curve_in_place(curve in curve(), more in 1..=3usize) {
        let elevated = curve.elevate_degree(curve.degree() + more).unwrap();
        prop_assert!(elevated.n_segments() == curve.n_segments());
        prop_assert!(are_same(&curve, &elevated, 1e-11));
        for (t, times) in curve.knots().distinct() {
            let domain = curve.domain();
            if domain.start() < t && t < domain.end() {
                prop_assert!(elevated.knots().multiplicity(t) == times + more);
            }
        }
    }

    #[test]
    fn both_parts_of_a_split_stay_in_place(curve in curve(), f in 0.01..0.99, g in fraction()) {
        let at = parameter(&curve, f);
        let [left, right] = curve.split(at).unwrap();
        for part in [left, right] {
            let t = parameter(&part, g);
            prop_assert!(are_near(part.point_at(t), curve.point_at(t), 1e-12)
                || curve.knots().multiplicity(t) == curve.degree() + 1);
        }
    }

    #[test]
    fn trimming_keeps_the_parameter(curve in curve(), f in 0.0..0.45, g in 0.55..1.0, h in fraction()) {
        let part = Interval::new(parameter(&curve, f), parameter(&curve, g)).unwrap();
        let trimmed = curve.trimmed(part).unwrap();
        let t = part.at(h);
        prop_assert!(are_near(trimmed.point_at(t), curve.point_at(t), 1e-12));
        prop_assert!(trimmed.domain() == part);
    }

    #[test]
    fn bezier_pieces_stay_in_place(curve in curve(), f in fraction()) {
        let pieces = curve.decompose();
        prop_assert!(pieces.len() == curve.n_segments());
        for piece in pieces {
            prop_assert!(piece.points().len() == curve.degree() + 1);
            let t = parameter(&piece, 0.01 + 0.98 * f);
            prop_assert!(are_near(piece.point_at(t), curve.point_at(t), 1e-12));
        }
    }

    #[test]
    fn reversal_runs_through_the_same_points(curve in curve(), f in fraction()) {
        let reversed = curve.reversed();
        let (there, back) = (parameter(&curve, f), parameter(&curve, 1.0 - f));
        prop_assert!(are_near(curve.point_at(there), reversed.point_at(back), 1e-11));
        prop_assert!(are_same(&reversed.reversed(), &curve, 1e-11));
    }

    #[test]
    fn reparametrization_keeps_the_points(curve in curve(), start in -5.0..5.0, length in 0.01..9.0) {
        let domain = Interval::new(start, start + length).unwrap();
        let other = curve.reparametrized(domain);
        prop_assert!(other.domain() == domain);
        prop_assert!(are_same(&curve, &other, 1e-11));
    }

    #[test]
    fn compatible_curves_share_their_knots_and_stay_in_place(a in curve(), b in curve()) {
        let both = make_compatible(&[a.clone(), b.clone()]).unwrap();
        prop_assert!(both[0].knots() == both[1].knots());
        prop_assert!(are_same(&a, &both[0], 1e-10));
        prop_assert!(are_same(&b, &both[1], 1e-10));
    }

    #[test]
    fn tangents_are_unit_derivatives(curve in curve(), f in fraction()) {
        let t = parameter(&curve, f);
        let derivative = curve.derivatives_at(t, 1)[1];
        prop_assume!(derivative.length() > 1e-3);
        let tangent = curve.tangent_at(t, Side::Right).unwrap();
        prop_assert!(tangent.distance(derivative / derivative.length()) < 1e-13);
    }
}

#[test]
fn every_form_of_the_circle_is_exact() {
    let (center, normal) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, -2.0, 0.5));
    for form in CircleForm::ALL {
        let circle = NurbsCurve::circle(center, 2.5, DVec3::X, normal, form).unwrap();
        for i in 0..=997 {
            let t = f64::from(i) / 997.0;
            let arm = circle.point_at(t) - center;
            assert!((arm.length() - 2.5).abs() < 1e-14, "{form:?} at {t}");
            assert!(arm.dot(normal).abs() < 1e-14, "{form:?} at {t}");
            let velocity = circle.derivatives_at(t, 1)[1];
            assert!(arm.cross(velocity).dot(normal) > 0.0, "{form:?} turns back at {t}");
            assert!(
                (Curve::from(circle.clone())
                    .local_at(t, Side::Right)
                    .unwrap()
                    .curvature()
                    .unwrap()
                    - 0.4)
                    .abs()
                    < 1e-10,
                "{form:?} at {t}"
            );
        }
        assert!(circle.is_closed(1e-14));
    }
}

#[test]
fn a_weight_of_zero_takes_its_point_away() {
    let knots = KnotVector::bezier(2).unwrap();
    let points = [DVec3::ZERO, DVec3::new(1.0, 5.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
    let curve = NurbsCurve::rational(knots, &points, &[1.0, 0.0, 1.0]).unwrap();
    for i in 0..=20 {
        let point = curve.point_at(f64::from(i) / 20.0);
        assert!(point.y.abs() < 1e-15 && (0.0..=2.0).contains(&point.x));
    }
}

#[test]
fn a_cusp_has_a_tangent_on_each_side() {
    // (t², t³): back along −x, forth along +x.
    let curve = |t: f64| DVec3::new(t * t, t * t * t, 0.0);
    // Bernstein points of the cubic on −1..1.
    let points = [
        curve(-1.0),
        DVec3::new(-1.0 / 3.0, 1.0, 0.0),
        DVec3::new(-1.0 / 3.0, -1.0, 0.0),
        curve(1.0),
    ];
    let cubic = NurbsCurve::bezier(&points).unwrap();
    assert!(cubic.point_at(0.5).length() < 1e-15);
    assert!(cubic.tangent_at(0.5, Side::Right).unwrap().distance(DVec3::X) < 1e-14);
    assert!(cubic.tangent_at(0.5, Side::Left).unwrap().distance(-DVec3::X) < 1e-14);
}

#[test]
fn a_corner_has_a_tangent_on_each_side() {
    let polyline = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::ONE]).unwrap();
    assert_eq!(polyline.tangent_at(1.0, Side::Left), Ok(DVec3::X));
    let up = DVec3::new(0.0, 1.0, 1.0).normalize();
    assert!(polyline.tangent_at(1.0, Side::Right).unwrap().distance(up) < 1e-15);
}

#[test]
fn one_point_is_a_curve_of_degree_zero() {
    let curve = NurbsCurve::bezier(&[DVec3::ONE]).unwrap();
    assert_eq!(curve.degree(), 0);
    assert_eq!(curve.point_at(0.3), DVec3::ONE);
    assert_eq!(curve.derivatives_at(0.3, 2), vec![DVec3::ONE, DVec3::ZERO, DVec3::ZERO]);
    assert_eq!(curve.bounds().size(), DVec3::ZERO);
    assert!(curve.tangent_at(0.3, Side::Right).is_err());
    assert_eq!(curve.elevate_degree(2).unwrap().points(), vec![DVec3::ONE; 3]);
}

#[test]
fn the_projective_image_of_a_curve_has_the_images_of_its_points() {
    let circle = NurbsCurve::arc(Frame::XY, 2.0, 0.5, 4.0).expect("an arc");
    let cubic = NurbsCurve::bezier(&[
        DVec3::new(0.0, 0.0, 1.0),
        DVec3::new(1.0, 3.0, -1.0),
        DVec3::new(4.0, -1.0, 0.5),
        DVec3::new(2.0, 2.0, 2.0),
    ])
    .expect("a curve");
    // Away from the plane that goes to infinity, where 12 + x − 2 y + z is nothing.
    let map = DMat4::from_cols_array(&[
        1.0, 0.2, 0.0, 1.0, -0.3, 2.0, 0.1, -2.0, 0.0, 0.5, 1.5, 1.0, 3.0, -1.0, 0.7, 12.0,
    ]);
    for curve in [circle, cubic] {
        let image = curve.projected(&map).expect("an image");
        for t in curve.domain().steps(50) {
            let expected = map.project_point3(curve.point_at(t));
            assert!(image.point_at(t).distance(expected) < 1e-14, "{t}");
        }
        let beyond = DMat4::from_cols(DVec4::X, DVec4::Y, DVec4::Z, -DVec4::W);
        assert!(matches!(
            curve.projected(&beyond),
            Err(GeomError::Weights(WeightError::BadWeight { index: 0, .. }))
        ));
    }
}
