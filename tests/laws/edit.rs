//! Laws of edits: exact ones leave a curve where it was, others tell how far it moved.

use glam::{DAffine3, DVec3};
use proptest::{collection::vec, prelude::Strategy, prop_assert, prop_assume, proptest};
use virote_kernel::{
    CircleForm, Curve, FitError, GeomError, Interval, JointError, KnotError, KnotVector,
    NurbsCurve, Side, Tolerance, join,
};

use crate::{
    curve::are_same,
    some::{affine_map, are_near, curve, fraction, parameter},
};

/// The largest distance at equal parameters among many, looked at more closely around the farthest:
/// weights that differ twentyfold make peaks that lie between samples.
fn sampled_distance(a: &NurbsCurve, b: &NurbsCurve) -> f64 {
    let distance = |fraction: f64| {
        let t = parameter(a, fraction);
        a.point_at(t).distance(b.point_at(t))
    };
    let farthest = |from: f64, to: f64, count: u32| {
        let place = |i| (from + (to - from) * f64::from(i) / f64::from(count)).clamp(0.0, 1.0);
        let nearer = |f: &f64, g: &f64| distance(*f).total_cmp(&distance(*g));
        (0..=count).map(place).max_by(nearer).unwrap()
    };
    let near = farthest(0.0, 1.0, 4000);
    distance(farthest(near - 1.0 / 4000.0, near + 1.0 / 4000.0, 1000))
}

/// Smooth curves in the plane, rational or not.
fn planar_bezier() -> impl Strategy<Value = NurbsCurve> {
    vec((-10.0..10.0, -10.0..10.0, 0.3..3.0), 3..7).prop_map(|rows| {
        let points: Vec<DVec3> = rows.iter().map(|&(x, y, _)| DVec3::new(x, y, 0.0)).collect();
        let weights: Vec<f64> = rows.iter().map(|&(_, _, w)| w).collect();
        let knots = KnotVector::bezier(points.len() - 1).unwrap();
        NurbsCurve::rational(knots, &points, &weights).unwrap()
    })
}

proptest! {
    #[test]
    fn many_knots_at_once_leave_the_curve_in_place(
        curve in curve(), fs in vec(fraction(), 0..30),
    ) {
        let knots: Vec<f64> = fs.iter().map(|&f| parameter(&curve, f)).collect();
        let refined = curve.insert_knots(&knots);
        prop_assume!(refined.is_ok());
        let refined = refined.unwrap();
        prop_assert!(refined.points().len() == curve.points().len() + knots.len());
        prop_assert!(refined.knots().as_slice().is_sorted());
        prop_assert!(are_same(&curve, &refined, 1e-12));
    }

    #[test]
    fn removal_undoes_insertion(curve in curve(), f in 0.01..0.99, times in 1..=3usize) {
        let t = parameter(&curve, f);
        prop_assume!(curve.knots().multiplicity(t) + times <= curve.degree());
        let more = curve.insert_knots(&vec![t; times]).unwrap();
        let back = more.without_knot(t, times, 1e-9).unwrap();
        prop_assert!(back.knots() == curve.knots());
        for (a, b) in back.points().into_iter().zip(curve.points()) {
            prop_assert!(are_near(a, b, 1e-9));
        }
        prop_assert!(are_same(&curve, &back, 1e-11));
    }

    #[test]
    fn a_removal_that_is_refused_tells_no_less_than_the_distance(curve in curve(), which in 0..8usize) {
        let breaks = curve.knots().breaks();
        prop_assume!(2 < breaks.len());
        let knot = breaks[1 + which % (breaks.len() - 2)];
        match curve.without_knot(knot, 1, 1e-12) {
            Err(GeomError::Fit(FitError::KnotNeeded { error, .. })) => {
                prop_assume!(error.is_finite());
                let moved = curve.without_knot(knot, 1, error).unwrap();
                let distance = sampled_distance(&curve, &moved);
                prop_assert!(distance <= error + 1e-12 && error <= 1.05 * distance + 1e-12, "{distance} {error}");
            }
            other => prop_assert!(other.is_ok()),
        }
    }

    #[test]
    fn joining_undoes_splitting(curve in curve(), f in 0.01..0.99) {
        let at = parameter(&curve, f);
        let parts = curve.split(at).unwrap();
        let joined = join(&parts, 1e-6).unwrap();
        prop_assert!(joined.domain() == curve.domain());
        prop_assert!(joined.points().len() == curve.clamped().points().len());
        prop_assert!(are_same(&curve, &joined, 1e-11));
    }

    #[test]
    fn joining_undoes_decomposition(curve in curve()) {
        let pieces = curve.decompose();
        prop_assume!(1 < pieces.len());
        let joined = join(&pieces, 1e-6).unwrap();
        prop_assert!(joined.knots().as_slice().len() == curve.clamped().knots().as_slice().len());
        prop_assert!(are_same(&curve, &joined, 1e-11));
    }

    #[test]
    fn reduction_undoes_elevation(curve in curve(), more in 1..=3usize) {
        prop_assume!(1 < curve.degree());
        let elevated = curve.elevate_degree(curve.degree() + more).unwrap();
        let back = elevated.reduced(Some(curve.degree()), 1e-9).unwrap();
        prop_assert!(back.degree() == curve.degree());
        prop_assert!(back.knots() == curve.clamped().knots());
        prop_assert!(are_same(&curve, &back, 1e-10));
    }

    #[test]
    fn a_reduction_that_is_refused_tells_no_less_than_the_distance(curve in curve()) {
        prop_assume!(1 < curve.degree());
        let degree = curve.degree() - 1;
        match curve.reduced(Some(degree), 1e-12) {
            Err(GeomError::Fit(FitError::NotReducible { error, .. })) => {
                // The least squares of a rational curve may have weights that are none.
                prop_assume!(error.is_finite());
                let moved = curve.reduced(Some(degree), error).unwrap();
                let distance = sampled_distance(&curve, &moved);
                prop_assert!(distance <= error + 1e-12 && error <= 1.05 * distance + 1e-12, "{distance} {error}");
                prop_assert!(are_near(moved.start(), curve.start(), 1e-13));
                prop_assert!(are_near(moved.end(), curve.end(), 1e-13));
            }
            other => prop_assert!(other.is_ok()),
        }
    }

    #[test]
    fn a_part_of_a_part_is_a_part(curve in curve(), f in 0.0..0.3, g in 0.7..1.0) {
        let outer = Interval::new(parameter(&curve, f), parameter(&curve, g)).unwrap();
        let inner = Interval::new(parameter(&curve, 0.4), parameter(&curve, 0.6)).unwrap();
        let twice = curve.trimmed(outer).unwrap().trimmed(inner).unwrap();
        let once = curve.trimmed(inner).unwrap();
        prop_assert!(twice.domain() == once.domain());
        prop_assert!(are_same(&once, &twice, 1e-12));
    }

    #[test]
    fn an_extension_leaves_the_curve_in_place_and_has_its_length(
        curve in curve(), length in 0.01..3.0, at_start in proptest::bool::ANY, f in fraction(),
    ) {
        let extended = if at_start { curve.extended_at_start(length) } else { curve.extended(length) };
        prop_assume!(extended.is_ok());
        let extended = extended.unwrap();
        let (old, new) = (curve.domain(), extended.domain());
        let t = old.at(0.001 + 0.998 * f);
        prop_assert!(are_near(curve.point_at(t), extended.point_at(t), 1e-9));
        let added = match at_start {
            true => Interval::new(new.start(), old.start()).unwrap(),
            false => Interval::new(old.end(), new.end()).unwrap(),
        };
        prop_assert!((extended.length(added) - length).abs() < 1e-9 * (1.0 + extended.length(new)));
        prop_assert!(extended.weights().iter().all(|&weight| 0.0 < weight));
    }

    #[test]
    fn edits_commute_with_affine_maps(curve in curve(), map in affine_map(), f in 0.1..0.9) {
        let at = parameter(&curve, f);
        let edit = |curve: &NurbsCurve| {
            let [left, right] = curve.split(at).unwrap();
            join(&[left.elevate_degree(6).unwrap(), right], 1e-6).unwrap().reversed()
        };
        prop_assert!(are_same(&edit(&curve).transformed(&map), &edit(&curve.transformed(&map)), 1e-9));
    }

    #[test]
    fn an_offset_is_within_its_tolerance(curve in planar_bezier(), distance in -3.0..3.0) {
        prop_assume!(0.01 < f64::abs(distance));
        let tolerance = Tolerance::default();
        let offset = curve.offset(distance, DVec3::Z, tolerance);
        prop_assume!(offset.is_ok());
        let offset = offset.unwrap().curve;
        prop_assert!(offset.domain() == curve.domain());
        for i in 0..=500 {
            let t = parameter(&curve, f64::from(i) / 500.0);
            let side = curve.tangent_at(t, Side::Right).unwrap().cross(DVec3::Z);
            let wanted = curve.point_at(t) + side * distance;
            prop_assert!(offset.point_at(t).distance(wanted) <= tolerance.distance);
        }
    }
}

#[test]
fn elevation_of_high_degree_stays_in_place_with_knots_of_any_width() {
    let points: Vec<DVec3> =
        (0..6).map(|i| DVec3::new(f64::from(i), f64::from(i * i % 5), f64::from(i % 2))).collect();
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1e-6, 0.999, 1.0, 1.0, 1.0, 1.0];
    let curve = NurbsCurve::polynomial(KnotVector::new(3, knots).unwrap(), &points).unwrap();
    let elevated = curve.elevate_degree(60).unwrap();
    assert_eq!(elevated.degree(), 60);
    assert!(are_same(&curve, &elevated, 1e-13));
    assert!(elevated.deviation_from(&curve) < 1e-12);
    assert!(elevated.weights().iter().all(|weight| (weight - 1.0).abs() < 1e-14));
}

#[test]
fn an_elevated_circle_keeps_its_radius() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let elevated = circle.elevate_degree(5).unwrap();
    for i in 0..=1000 {
        let t = f64::from(i) / 1000.0;
        assert!((elevated.point_at(t).length() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_spline_broken_at_a_knot_is_elevated_on_both_sides() {
    let points: Vec<DVec3> =
        (0..6).map(|i| DVec3::new(f64::from(i), f64::from(i % 3), 0.0)).collect();
    let knots = vec![0.0, 0.0, 0.0, 0.4, 0.4, 0.4, 1.0, 1.0, 1.0];
    let curve = NurbsCurve::polynomial(KnotVector::new(2, knots).unwrap(), &points).unwrap();
    let elevated = curve.elevate_degree(4).unwrap();
    assert_eq!(elevated.knots().multiplicity(0.4), 5);
    assert!(are_same(&curve, &elevated, 1e-14));
}

#[test]
fn knots_within_rounding_of_one_another_are_inserted_as_one() {
    let line = NurbsCurve::bezier(&[DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE]).unwrap();
    let refined = line.insert_knots(&[0.3, 0.1 + 0.2, 0.1 * 3.0]).unwrap();
    assert_eq!(refined.knots().distinct().len(), 3);
    assert_eq!(refined.knots().multiplicity(0.3), 3);
    // A fourth copy is a break, a fifth impossible.
    let knots = [0.3, 0.3, 0.3, 0.1 + 0.2, 0.3];
    let refused = line.insert_knots(&knots).unwrap_err();
    assert!(matches!(
        refused,
        GeomError::Knots(KnotError::KnotMultiplicity { times: 5, most: 4, .. })
    ));
}

#[test]
fn knots_that_are_near_but_apart_stay_two() {
    let line = NurbsCurve::line(DVec3::ZERO, DVec3::X).unwrap();
    for gap in [1e-9, 1e-6] {
        let refined = line.insert_knots(&[0.5, 0.5 + gap]).unwrap();
        assert_eq!(refined.n_segments(), 3);
        assert!(are_same(&line, &refined, 1e-15));
    }
}

#[test]
fn a_true_cubic_is_no_parabola() {
    // The third difference is 6; the best parabola with the same ends is 6·√3/36·… away, at most.
    let cubic = NurbsCurve::bezier(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE]).unwrap();
    let Err(GeomError::Fit(FitError::NotReducible { degree, error, .. })) =
        cubic.reduced(None, 1e-6)
    else {
        panic!("a cubic with a third derivative is of degree 3");
    };
    assert_eq!(degree, 2);
    let moved = cubic.reduced(Some(2), error).unwrap();
    assert!(sampled_distance(&cubic, &moved) <= error + 1e-12);
}

#[test]
fn a_gap_names_the_pieces() {
    let line = |a: f64, b: f64| NurbsCurve::line(DVec3::X * a, DVec3::X * b).unwrap();
    let lines = [line(0.0, 1.0), line(1.0, 2.0), line(3.0, 2.0)];
    let gap = join(&lines, 1e-6).unwrap_err();
    assert_eq!(
        gap,
        GeomError::Joint(JointError::Gap {
            index: 1,
            gap: 1.0,
            tolerance: 1e-6,
            reversed: Some(2)
        })
    );
    assert_eq!(
        gap.to_string(),
        "`curves[2]` starts 1 from where `curves[1]` ends, more than the tolerance 1e-6"
    );
}

#[test]
fn a_chain_of_bezier_curves_has_the_knots_of_its_continuity() {
    // Of degree 3: C² at 1, C¹ at 2, a corner at 3.
    let point = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let piece = |points: [DVec3; 4]| NurbsCurve::bezier(&points).unwrap();
    let a = piece([point(0.0, 0.0), point(1.0, 0.0), point(2.0, 1.0), point(3.0, 3.0)]);
    let b = piece([point(3.0, 3.0), point(4.0, 5.0), point(5.0, 8.0), point(7.0, 8.0)]);
    let c = piece([point(7.0, 8.0), point(9.0, 8.0), point(9.0, 5.0), point(9.0, 4.0)]);
    let d = piece([point(9.0, 4.0), point(10.0, 4.0), point(11.0, 5.0), point(12.0, 4.0)]);
    let joined = join(&[a, b, c, d], 1e-6).unwrap();
    let times: Vec<(f64, usize)> = joined.knots().distinct();
    assert_eq!(times, [(0.0, 4), (1.0, 1), (2.0, 2), (3.0, 3), (4.0, 4)]);
}

#[test]
fn weights_go_on_over_a_joint() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 2.0, DVec3::X, DVec3::Z, CircleForm::SevenSquare).unwrap();
    let [left, right] = circle.split(0.3).unwrap();
    let scaled: Vec<f64> = right.weights().iter().map(|weight| weight * 7.0).collect();
    let right = NurbsCurve::rational(right.knots().clone(), &right.points(), &scaled).unwrap();
    let joined = join(&[left, right], 1e-6).unwrap();
    assert_eq!(joined.points().len(), circle.points().len());
    assert!(are_same(&circle, &joined, 1e-13));
}

#[test]
fn an_arc_goes_on_around_its_circle_however_far() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let quarter = circle.trimmed(Interval::new(0.0, 0.25).unwrap()).unwrap();
    // The rest is three quarters of a turn.
    for turn in [0.1, 1.0, 2.0, 2.3, 2.4, 4.7, 5.0, 20.0] {
        let extended = quarter.extended(turn).unwrap();
        let angle = std::f64::consts::FRAC_PI_2 + turn;
        let wanted = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        assert!(extended.end().distance(wanted) < 1e-11, "{turn}");
        assert!(extended.weights().iter().all(|&weight| 0.0 < weight), "{turn}");
    }
}

#[test]
fn the_offset_of_an_ellipse_has_cusps_where_the_distance_is_the_radius_of_curvature() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let ellipse = circle.transformed(&DAffine3::from_scale(DVec3::new(2.0, 1.0, 1.0)));
    let cusps =
        |distance: f64| ellipse.offset(distance, DVec3::Z, Tolerance::default()).unwrap().cusps;
    // The least radius, b²/a = 1/2, is at both ends of the long axis.
    assert!(cusps(-0.4).is_empty() && cusps(0.6).is_empty());
    let touching = cusps(-0.5);
    assert!(touching.len() == 3, "{touching:?}");
    for (t, wanted) in touching.iter().zip([0.0, 0.5, 1.0]) {
        assert!((t - wanted).abs() < 1e-4, "{touching:?}");
    }
    let four = cusps(-1.0);
    assert_eq!(four.len(), 4);
    for t in four {
        assert!(
            (Curve::from(ellipse.clone()).local_at(t, Side::Right).unwrap().curvature().unwrap()
                - 1.0)
                .abs()
                < 1e-9
        );
    }
}

#[test]
fn the_offset_of_a_closed_curve_is_closed() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let ellipse = circle.transformed(&DAffine3::from_scale(DVec3::new(2.0, 1.0, 1.0)));
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y, DVec3::ZERO];
    let square = NurbsCurve::polyline(&square).unwrap();
    for curve in [circle, ellipse, square] {
        let offset = curve.offset(0.25, DVec3::Z, Tolerance::default()).unwrap().curve;
        assert!(offset.is_closed(1e-12));
    }
}

#[test]
fn the_offset_of_a_cusp_goes_around_its_tip() {
    let points = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    let cusp = NurbsCurve::bezier(&points).unwrap();
    let tip = cusp.point_at(0.5);
    let offset = cusp.offset(0.1, DVec3::Z, Tolerance::default()).unwrap().curve;
    // The arc around the tip is half a circle with the highest point above it.
    let highest = offset.bounds().max.y;
    assert!((highest - (tip.y + 0.1)).abs() < 1e-6, "{highest}");
}

#[test]
fn the_offset_of_a_cusp_at_an_odd_parameter_is_within_its_tolerance() {
    let points = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    let whole = NurbsCurve::bezier(&points).unwrap();
    let cusp = whole.trimmed(Interval::new(0.1, 0.8).unwrap()).unwrap();
    let offset = cusp.offset(0.1, DVec3::Z, Tolerance::default()).unwrap().curve;
    for i in 0..=2000 {
        let t = parameter(&cusp, f64::from(i) / 2000.0);
        let side = cusp.tangent_at(t, Side::Right).unwrap().cross(DVec3::Z);
        let wanted = cusp.point_at(t) + side * 0.1;
        // Up to the cusp the parameters are the same; behind it they follow the arc.
        if t < 0.5 {
            assert!(offset.point_at(t).distance(wanted) <= 1e-6, "{t}");
        }
    }
    let end = cusp.tangent_at(0.8, Side::Left).unwrap().cross(DVec3::Z) * 0.1 + cusp.end();
    assert!(offset.end().distance(end) < 1e-12);
}

#[test]
fn offsets_have_no_scale() {
    let points = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let n_points = [1.0, 1e-100, 1e-6, 1e6, 1e100].map(|scale| {
        let curve = NurbsCurve::bezier(&points.map(|point| point * scale)).unwrap();
        let tolerance = Tolerance::default().with_distance(1e-6 * scale);
        let offset = curve.offset(0.1 * scale, DVec3::Z, tolerance).unwrap();
        assert!(offset.cusps.is_empty());
        offset.curve.points().len()
    });
    assert!(n_points.iter().all(|&n| n == n_points[0]), "{n_points:?}");
}

#[test]
fn near_knots_of_a_chain_go_to_the_first_of_each_cluster() {
    let line = NurbsCurve::line(DVec3::ZERO, DVec3::X).unwrap();
    let refined = line.insert_knots(&[0.5 + 1.4e-12, 0.5, 0.5 + 0.7e-12]).unwrap();
    let inner = &refined.knots().as_slice()[2..5];
    assert_eq!(inner, [0.5, 0.5, 0.5 + 1.4e-12]);
    assert!(are_same(&line, &refined, 1e-15));
}

#[test]
fn pieces_join_on_domains_of_any_size_until_one_vanishes() {
    let piece = |start: f64, width: f64| {
        let line = NurbsCurve::line(DVec3::X * start, DVec3::X * (start + 1.0)).unwrap();
        line.reparametrized(Interval::new(0.0, width).unwrap())
    };
    let joined = join(&[piece(0.0, 1.0), piece(1.0, 1e6)], 1e-6).unwrap();
    assert_eq!(joined.knots().as_slice(), [0.0, 0.0, 1.0, 1_000_001.0, 1_000_001.0]);
    assert!(joined.point_at(0.5).distance(DVec3::X * 0.5) < 1e-15);
    let vanishing = join(&[piece(0.0, 1e-9), piece(1.0, 1e6)], 1e-6).unwrap_err();
    assert!(matches!(vanishing, GeomError::Knots(KnotError::VanishingPiece { index: 0, .. })));
}

#[test]
fn unclamped_and_clamped_curves_join() {
    let points: Vec<DVec3> = [[0.0, 0.0], [1.0, 3.0], [2.0, 1.0], [4.0, 2.0], [5.0, 0.0]]
        .iter()
        .map(|&[x, y]| DVec3::new(x, y, 0.0))
        .collect();
    let unclamped = NurbsCurve::polynomial(KnotVector::uniform(3, 5).unwrap(), &points).unwrap();
    let line = NurbsCurve::line(unclamped.end(), DVec3::new(9.0, 9.0, 9.0)).unwrap();
    let joined = join(&[unclamped.clone(), line.clone()], 1e-6).unwrap();
    assert_eq!(joined.knots().multiplicity(2.0), 3);
    for f in [0.0, 0.1, 0.5, 0.9] {
        assert!(joined.point_at(2.0 * f).distance(unclamped.point_at(2.0 * f)) < 1e-14);
        assert!(joined.point_at(2.0 + f).distance(line.point_at(f)) < 1e-14);
    }
}

#[test]
fn very_many_knots_are_inserted_in_one_pass() {
    // Two hundred thousand knots; a pass over all points for each would take minutes.
    let points: Vec<DVec3> =
        (0..2000).map(|i| DVec3::new(f64::from(i), f64::from(i % 7), 0.0)).collect();
    let knots = KnotVector::uniform_clamped(3, points.len(), 1.0).unwrap();
    let curve = NurbsCurve::polynomial(knots, &points).unwrap();
    let knots: Vec<f64> = (0..200_000).map(|i| (f64::from(i) + 0.5) / 200_001.0).collect();
    let refined = curve.insert_knots(&knots).unwrap();
    assert_eq!(refined.points().len(), 202_000);
    assert!(are_same(&curve, &refined, 1e-12));
}
