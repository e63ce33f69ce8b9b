//! Laws of the constructions of curves, and of the conversions between their forms.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DAffine3, DVec3};
use proptest::{collection::vec, prop_assert, prop_assume, proptest};
use virote_kernel::{
    CircleForm, ConicKind, Curve, Frame, GeomError, InputError, Interval, KnotVector, NurbsCurve,
    Side,
};

use crate::some::{affine_map, are_near, curve, fraction, parameter, point};

/// Whether both curves have the same points, relative to `size`, at the same parameters.
fn are_same(a: &NurbsCurve, b: &NurbsCurve, tolerance: f64) -> bool {
    (0..=60).all(|i| {
        let f = f64::from(i) / 60.0;
        are_near(a.point_at(parameter(a, f)), b.point_at(parameter(b, f)), tolerance)
    })
}

/// Whether making and moving commute.
fn is_affine(
    points: &[DVec3],
    map: &DAffine3,
    make: impl Fn(&[DVec3]) -> Result<NurbsCurve, GeomError>,
) -> bool {
    let moved: Vec<DVec3> = points.iter().map(|&point| map.transform_point3(point)).collect();
    are_same(&make(points).unwrap().transformed(map), &make(&moved).unwrap(), 1e-12)
}

/// Derivatives at an inner knot from both sides.
fn sides(curve: &NurbsCurve, t: f64, order: usize) -> [Vec<DVec3>; 2] {
    [Side::Left, Side::Right].map(|side| curve.derivatives_beside(t, side, order))
}

proptest! {
    #[test]
    fn affine_invariance_of_every_construction(
        points in vec(point(), 4..=7), map in affine_map(), bias in 0.2..4.0, tension in 0.0..9.0,
    ) {
        for is_closed in [false, true] {
            prop_assert!(is_affine(&points, &map, |p| NurbsCurve::uniform(3, p, is_closed)));
            prop_assert!(is_affine(&points, &map, |p| NurbsCurve::beta_spline(p, bias, tension, is_closed)));
        }
        prop_assert!(is_affine(&points, &map, NurbsCurve::bezier));
        prop_assert!(is_affine(&points, &map, NurbsCurve::polyline));
        // Tangents are differences of points.
        let hermite = |p: &[DVec3]| {
            let tangents: Vec<DVec3> = p.iter().map(|&q| (q - p[0]) * 2.0).collect();
            NurbsCurve::hermite(p, &tangents)
        };
        prop_assert!(is_affine(&points, &map, hermite));
        // So are all coefficients but the first.
        let power_form = |p: &[DVec3]| {
            let rest = p[1..].iter().map(|&q| q - p[0]);
            let coefficients: Vec<DVec3> = [p[0]].into_iter().chain(rest).collect();
            NurbsCurve::power_form(&coefficients, Interval::new(-1.0, 2.0)?)
        };
        prop_assert!(is_affine(&points, &map, power_form));
    }

    #[test]
    fn hermite_curves_take_their_points_and_tangents(data in vec((point(), point()), 2..=6)) {
        let (points, tangents): (Vec<DVec3>, Vec<DVec3>) = data.into_iter().unzip();
        let curve = NurbsCurve::hermite(&points, &tangents).unwrap();
        prop_assert!(curve.n_segments() == points.len() - 1);
        for (i, (&point, &tangent)) in points.iter().zip(&tangents).enumerate() {
            for derivatives in sides(&curve, i as f64, 1) {
                prop_assert!(are_near(derivatives[0], point, 1e-14));
                prop_assert!(are_near(derivatives[1], tangent, 1e-13));
            }
        }
    }

    #[test]
    fn the_ends_of_a_coons_cubic_divide_by_thirds(points in vec(point(), 4)) {
        let curve = NurbsCurve::uniform(3, &points, false).unwrap();
        let middle = 0.5 * (points[0] + points[2]);
        prop_assert!(are_near(curve.start(), points[1].lerp(middle, 1.0 / 3.0), 1e-14));
        let derivative = curve.derivatives_at(0.0, 1)[1];
        prop_assert!(are_near(derivative, 0.5 * (points[2] - points[0]), 1e-13));
    }

    #[test]
    fn the_seam_of_a_periodic_spline_is_as_smooth_as_its_joints(
        points in vec(point(), 3..=8), degree in 1..=5usize,
    ) {
        let curve = NurbsCurve::uniform(degree, &points, true).unwrap();
        let (start, end) = (curve.domain().start(), curve.domain().end());
        prop_assert!(curve.n_segments() == points.len());
        let before = curve.derivatives_beside(end, Side::Left, degree - 1);
        let after = curve.derivatives_beside(start, Side::Right, degree - 1);
        for (before, after) in before.iter().zip(&after) {
            prop_assert!(are_near(*before, *after, 1e-12));
        }
    }

    #[test]
    fn splines_are_smooth_at_simple_knots(points in vec(point(), 7..=9), degree in 1..=5usize) {
        // A polynomial of degree p with one knot more is C^(p − 1) there, and no smoother.
        let curve = NurbsCurve::uniform(degree, &points, false).unwrap();
        let [left, right] = sides(&curve, 1.0, degree);
        for k in 0..degree {
            prop_assert!(are_near(left[k], right[k], 1e-12));
        }
        prop_assert!(!are_near(left[degree], right[degree], 1e-9));
    }

    #[test]
    fn a_coons_segment_lies_in_the_hull_of_its_four_points(
        points in vec(point(), 4..=8), f in fraction(), bias in 0.1..5.0, tension in 0.0..9.0,
    ) {
        let coons = NurbsCurve::uniform(3, &points, false).unwrap();
        let beta = NurbsCurve::beta_spline(&points, bias, tension, false).unwrap();
        for curve in [coons, beta] {
            let t = parameter(&curve, f);
            let first = (t as usize).min(points.len() - 4);
            let near = points[first..first + 4].iter().copied();
            let (low, high) = (near.clone().reduce(DVec3::min), near.reduce(DVec3::max));
            let at = curve.point_at(t);
            prop_assert!((low.unwrap() - 1e-13).cmple(at).all());
            prop_assert!(at.cmple(high.unwrap() + 1e-13).all());
        }
    }

    #[test]
    fn a_point_of_a_coons_spline_moves_four_segments_at_most(
        points in vec(point(), 9), which in 0..9usize, to in point(), f in fraction(),
    ) {
        let mut changed = points.clone();
        changed[which] = to;
        let [before, after] =
            [points, changed].map(|points| NurbsCurve::uniform(3, &points, false).unwrap());
        let t = parameter(&before, f);
        if !(which as f64 - 3.0..=which as f64 + 1.0).contains(&t) {
            prop_assert!(before.point_at(t) == after.point_at(t));
        }
    }

    #[test]
    fn collinear_points_make_a_straight_curve(
        a in point(), along in point(), places in vec(0.0..1.0, 4..=7), f in fraction(),
    ) {
        prop_assume!(along.length() > 0.1);
        let points: Vec<DVec3> = places.iter().map(|&place| a + along * place).collect();
        for curve in [
            NurbsCurve::bezier(&points).unwrap(),
            NurbsCurve::uniform(3, &points, true).unwrap(),
            NurbsCurve::beta_spline(&points, 2.0, 3.0, false).unwrap(),
        ] {
            let arm = curve.point_at(parameter(&curve, f)) - a;
            prop_assert!(arm.cross(along).length() < 1e-12 * (1.0 + a.length()) * along.length());
            prop_assert!((-1e-12..=1.0 + 1e-12).contains(&(arm.dot(along) / along.length_squared())));
        }
    }

    #[test]
    fn no_plane_meets_a_curve_more_often_than_its_polygon(
        points in vec(point(), 4..=8), normal in point(), offset in -5.0..5.0, is_bezier in 0..2,
    ) {
        let curve = match is_bezier {
            0 => NurbsCurve::bezier(&points).unwrap(),
            _ => NurbsCurve::uniform(3, &points, false).unwrap(),
        };
        let crossings = |points: &[DVec3]| {
            let sides: Vec<bool> = points.iter().map(|p| offset < p.dot(normal)).collect();
            sides.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        prop_assert!(crossings(&curve.sample(400)) <= crossings(&points));
    }

    #[test]
    fn a_bezier_curve_is_a_spline_with_knots_at_its_ends_only(points in vec(point(), 2..=8)) {
        let degree = points.len() - 1;
        let knots = KnotVector::uniform_clamped(degree, points.len(), 1.0).unwrap();
        let spline = NurbsCurve::polynomial(knots, &points).unwrap();
        prop_assert!(spline == NurbsCurve::bezier(&points).unwrap());
    }

    #[test]
    fn a_growing_weight_pulls_the_curve_to_its_point(points in vec(point(), 4), f in 0.1..0.9) {
        let distance = |weight: f64| {
            let knots = KnotVector::bezier(3).unwrap();
            let weights = [1.0, weight, 1.0, 1.0];
            let curve = NurbsCurve::rational(knots, &points, &weights).unwrap();
            curve.point_at(f).distance(points[1])
        };
        prop_assert!(distance(1e3) <= distance(1.0) + 1e-12);
        prop_assert!(distance(1e9) < 1e-5);
    }

    #[test]
    fn beta_splines_turn_without_a_bend(
        points in vec(point(), 5..=7), bias in 0.2..4.0, tension in 0.0..9.0,
    ) {
        let curve = NurbsCurve::beta_spline(&points, bias, tension, false).unwrap();
        let [before, after] = sides(&curve, 1.0, 2);
        prop_assert!(are_near(before[1] * bias, after[1], 1e-11));
        // Beta constraint: Q″ = β₁² P″ + β₂ P′.
        let bent = before[2] * (bias * bias) + before[1] * tension;
        prop_assert!(are_near(bent, after[2], 1e-10));
    }

    #[test]
    fn beta_splines_without_bias_and_tension_are_coons_splines(points in vec(point(), 4..=7)) {
        for is_closed in [false, true] {
            let beta = NurbsCurve::beta_spline(&points, 1.0, 0.0, is_closed).unwrap();
            prop_assert!(are_same(&beta, &NurbsCurve::uniform(3, &points, is_closed).unwrap(), 1e-13));
        }
    }

    #[test]
    fn conversions_round_trip(points in vec(point(), 4..=7), is_closed in 0..2) {
        let coons = NurbsCurve::uniform(3, &points, is_closed == 1).unwrap();
        let clamped = coons.without_needless_knots();
        let [at, along] = clamped.to_hermite().unwrap();
        let hermite = NurbsCurve::hermite(&at, &along).unwrap();
        for other in [&clamped, &hermite, &hermite.without_needless_knots()] {
            prop_assert!(are_same(&coons, other, 1e-12));
            let back = other.to_coons().unwrap();
            prop_assert!(back.knots() == coons.knots());
            for (got, expected) in back.points().into_iter().zip(coons.points()) {
                prop_assert!(are_near(got, expected, 1e-12));
            }
        }
        let [at_again, along_again] = hermite.to_hermite().unwrap();
        prop_assert!(at.iter().zip(at_again).all(|(a, b)| are_near(*a, b, 1e-12)));
        prop_assert!(along.iter().zip(along_again).all(|(a, b)| are_near(*a, b, 1e-12)));
    }

    #[test]
    fn needless_knots_go_and_needed_ones_stay(curve in curve(), fs in [0.01..0.99, 0.01..0.99]) {
        let added = curve.insert_knots(&fs.map(|f| parameter(&curve, f)));
        prop_assume!(added.is_ok());
        let cleared = added.unwrap().without_needless_knots();
        prop_assert!(are_same(&curve, &cleared, 1e-10));
        // At higher degrees rounding of the insertion may be more than a needless knot is allowed.
        if curve.degree() <= 3 && !curve.is_rational() {
            prop_assert!(cleared.points().len() <= curve.clamped().points().len());
        }
    }

    #[test]
    fn power_coefficients_and_back(
        coefficients in vec(point(), 1..=6), start in -2.0..2.0, length in 0.5..3.0,
    ) {
        let domain = Interval::new(start, start + length).unwrap();
        let curve = NurbsCurve::power_form(&coefficients, domain).unwrap();
        let t = domain.at(0.3);
        let horner = coefficients.iter().rev().fold(DVec3::ZERO, |sum, &c| sum * t + c);
        prop_assert!(are_near(curve.point_at(t), horner, 1e-12));
        let back = curve.power_coefficients().unwrap();
        // The shift back to powers of t multiplies rounding by the fifth power of the distance.
        let scale = 1e-12 * libm::pow((2.0 + start.abs()) / length, 5.0);
        prop_assert!(back.iter().zip(&coefficients).all(|(a, b)| are_near(*a, *b, scale)));
    }

    #[test]
    fn the_hodograph_is_the_derivative(curve in curve(), f in fraction()) {
        let hodograph = curve.hodograph().unwrap();
        let t = parameter(&curve, f);
        prop_assert!(hodograph.domain() == curve.domain());
        let expected = curve.derivatives_at(t, 1)[1];
        let size = hodograph.points().iter().map(|p| p.length()).fold(1.0, f64::max);
        prop_assert!(hodograph.point_at(t).distance(expected) < 1e-10 * size);
    }

    #[test]
    fn other_weights_leave_the_points(
        curve in curve(), values in vec(0.2..4.0, 4), degree in 1..=3usize, f in fraction(),
    ) {
        let points: Vec<DVec3> = values.iter().map(|&x| DVec3::new(x, 0.0, 0.0)).collect();
        let factor = NurbsCurve::uniform(degree, &points, false).unwrap().clamped();
        let factor = factor.reparametrized(curve.domain());
        let other = curve.reweighted(&factor).unwrap();
        let t = parameter(&curve, f);
        prop_assert!(are_near(other.point_at(t), curve.point_at(t), 1e-10));
        let weight = curve.homogeneous_at(t).w * factor.point_at(t).x;
        prop_assert!((other.homogeneous_at(t).w - weight).abs() < 1e-11 * weight);
        prop_assert!(other.degree() == curve.degree() + degree);
    }

    #[test]
    fn basis_functions_sum_to_one_and_blend_the_points(curve in curve(), f in fraction()) {
        let t = parameter(&curve, f);
        let values = curve.basis_at(t);
        prop_assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        prop_assert!(values.iter().all(|&value| 0.0 <= value));
        let blend = values.iter().zip(curve.points()).map(|(&n, point)| point * n).sum();
        prop_assert!(are_near(curve.point_at(t), blend, 1e-13));
    }

    #[test]
    fn corner_cutting_ends_at_the_curve(points in vec(point(), 1..=7), f in fraction()) {
        let curve = NurbsCurve::bezier(&points).unwrap();
        let levels = curve.de_casteljau(f).unwrap();
        prop_assert!(levels.len() == points.len());
        prop_assert!(levels[0] == points);
        prop_assert!(are_near(levels[points.len() - 1][0], curve.point_at(f), 1e-13));
    }

    #[test]
    fn arcs_are_exact(
        radius in 0.01..1e4, from in -7.0..7.0, sweep in 0.001..1.0, f in fraction(),
    ) {
        let sweep = sweep * TAU;
        let arc = NurbsCurve::arc(Frame::XY, radius, from, sweep).unwrap();
        prop_assert!((arc.point_at(f).length() / radius - 1.0).abs() < 1e-15);
        let end = DVec3::new(libm::cos(from + sweep), libm::sin(from + sweep), 0.0);
        prop_assert!(are_near(arc.end() / radius, end, 1e-14));
        prop_assert!((arc.length(arc.domain()) / (radius * sweep) - 1.0).abs() < 1e-12);
        prop_assert!(arc.n_segments() == (sweep / FRAC_PI_2).ceil() as usize);
    }

    #[test]
    fn arcs_go_through_their_three_points(a in point(), b in point(), c in point()) {
        let sine = (b - a).cross(c - a).length() / ((b - a).length() * (c - a).length());
        prop_assume!(0.01 < sine && 0.1 < (c - b).length());
        let arc = NurbsCurve::arc_through([a, b, c], 1e-6).unwrap();
        prop_assert!(arc.start() == a && arc.end() == c);
        let shape = Curve::from(arc.clone()).local_at(0.4, Side::Right).unwrap();
        let (curvature, center) =
            (shape.curvature().unwrap(), shape.center_of_curvature().unwrap());
        for place in [a, b, c] {
            prop_assert!((place.distance(center) * curvature - 1.0).abs() < 1e-9);
        }
        // It meets b on its way: no sample is farther from it than half a step.
        let step = arc.length(arc.domain()) / 400.0;
        let nearest = arc.sample(801).into_iter().map(|p| p.distance(b)).fold(f64::MAX, f64::min);
        prop_assert!(nearest < step);
    }

    #[test]
    fn helices_keep_the_tolerance(
        radius in 0.1..1e3, pitch in -50.0..50.0, turns in 0.1..6.0, digits in 2..9, f in fraction(),
    ) {
        let distance = libm::pow(10.0, -f64::from(digits));
        let helix = NurbsCurve::helix(Frame::XY, radius, pitch, turns, distance).unwrap();
        let angle = turns * TAU * f;
        let exact = DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), pitch * turns * f);
        prop_assert!(helix.point_at(f).distance(exact) < distance);
        prop_assert!(helix.start() == DVec3::new(radius, 0.0, 0.0));
        for (t, times) in helix.knots().distinct() {
            prop_assert!(times == 3 || t <= 0.0 || 1.0 <= t);
        }
    }

    #[test]
    fn the_middle_weight_tells_the_conic(points in vec(point(), 3), weight in 0.01f64..4.0) {
        prop_assume!(0.1 < (points[1] - points[0]).cross(points[2] - points[0]).length());
        prop_assume!(1e-6 < (weight - 1.0).abs());
        let knots = KnotVector::bezier(2).unwrap();
        let of = |weights: [f64; 3]| {
            let curve = NurbsCurve::rational(knots.clone(), &points, &weights).unwrap();
            curve.conic_kind().unwrap()
        };
        let kind = if weight < 1.0 { ConicKind::Ellipse } else { ConicKind::Hyperbola };
        prop_assert!(of([1.0, weight, 1.0]) == kind);
        prop_assert!(of([0.25, weight, 4.0]) == kind);
        prop_assert!(of([weight, 1.0, 1.0 / weight]) == ConicKind::Parabola);
    }
}

#[test]
fn every_form_of_the_circle_is_exact_to_the_last_bits() {
    for form in CircleForm::ALL {
        let circle = NurbsCurve::circle(DVec3::ZERO, 2.5, DVec3::X, DVec3::Z, form).unwrap();
        for i in 0..=5000 {
            let t = f64::from(i) / 5000.0;
            let error = circle.point_at(t).length() / 2.5 - 1.0;
            assert!(error.abs() < 1e-15, "{form:?} at {t}: {error:e}");
        }
        let kind = if circle.degree() == 2 { Some(ConicKind::Ellipse) } else { None };
        assert_eq!(circle.conic_kind().ok(), kind);
    }
}

#[test]
fn an_arc_is_refused_where_two_of_its_points_are_one() {
    let [a, b, c] =
        [DVec3::new(3.0, 1.0, 2.0), DVec3::new(5.0, 5.0, 1.0), DVec3::new(8.0, 1.0, 0.0)];
    for (points, expected) in [([a, a, c], [0, 1]), ([a, b, b], [1, 2]), ([a, b, a], [0, 2])] {
        let [first, second] = expected;
        let error = GeomError::Input(InputError::CoincidentPoints { first, second });
        assert_eq!(NurbsCurve::arc_through(points, 1e-6).map(|_| ()), Err(error));
    }
    // Points on both sides of the origin are apart.
    let arc = NurbsCurve::arc_through([a, b, -a], 1e-6).unwrap();
    assert!(arc.start().distance(a) < 1e-12 && arc.end().distance(-a) < 1e-12);
}
