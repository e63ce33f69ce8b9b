//! Laws of curves and surfaces prepared for many parameters.

use glam::DVec3;
use proptest::{collection::vec, prop_assert, prop_assert_eq, proptest};
use virote_kernel::{CircleForm, Grid, KnotVector, NurbsCurve, NurbsSurface};

use crate::some::{are_near, curve, fraction, parameter, point, surface};

proptest! {
    #[test]
    fn a_prepared_curve_has_the_points_of_the_curve(curve in curve(), f in fraction()) {
        let t = parameter(&curve, f);
        prop_assert!(are_near(curve.evaluator().point_at(t), curve.point_at(t), 1e-14));
    }

    #[test]
    fn a_prepared_curve_has_the_derivatives_of_the_curve(curve in curve(), f in fraction()) {
        let t = parameter(&curve, f);
        for t in curve.knots().breaks().into_iter().chain([t]) {
            let width = curve.knots().span_interval(curve.knots().span_at(t)).length();
            let ours = curve.evaluator().second_order_at(t);
            let unit = |k: usize| libm::pow(width, k as f64);
            let size: f64 = ours.iter().enumerate().map(|(k, d)| d.length() * unit(k)).sum();
            for (k, derivative) in curve.derivatives_at(t, 2).into_iter().enumerate() {
                let miss = ours[k].distance(derivative) * unit(k);
                prop_assert!(miss <= 1e-13 * (1.0 + size), "order {k} at {t} misses by {miss:e}");
            }
        }
    }

    #[test]
    fn a_prepared_curve_goes_on_beyond_its_ends(curve in curve(), f in fraction()) {
        // Without weights, whose sum vanishes somewhere out there.
        let curve = NurbsCurve::polynomial(curve.knots().clone(), &curve.points()).unwrap();
        let (domain, evaluator) = (curve.domain(), curve.evaluator());
        for t in [domain.start() - 0.1 * f, domain.end() + 0.1 * f] {
            prop_assert!(are_near(evaluator.point_at(t), curve.point_at(t), 1e-12));
        }
    }

    #[test]
    fn a_prepared_clamped_curve_has_the_same_ends_to_the_bit(curve in curve()) {
        let clamped = curve.clamped();
        let evaluator = clamped.evaluator();
        for end in [clamped.domain().start(), clamped.domain().end()] {
            prop_assert_eq!(evaluator.point_at(end), clamped.point_at(end));
            prop_assert_eq!(evaluator.second_order_at(end)[0], clamped.point_at(end));
        }
    }

    #[test]
    fn prepared_points_at_knots_are_ends_of_pieces(curve in curve()) {
        let evaluator = curve.evaluator();
        for (piece, t) in curve.decompose().iter().zip(curve.knots().breaks()) {
            prop_assert!(are_near(evaluator.point_at(t), piece.start(), 1e-15));
        }
    }

    #[test]
    fn many_parameters_have_the_points_of_each(curve in curve(), fractions in vec(fraction(), 0..200)) {
        let evaluator = curve.evaluator();
        let ts: Vec<f64> = fractions.into_iter().map(|f| parameter(&curve, f)).collect();
        let each: Vec<DVec3> = ts.iter().map(|&t| evaluator.point_at(t)).collect();
        prop_assert_eq!(evaluator.points_at(&ts), each);
        let mut orders = Vec::new();
        evaluator.each_second_order(&ts, |order| orders.push(order));
        let each: Vec<[DVec3; 3]> = ts.iter().map(|&t| evaluator.second_order_at(t)).collect();
        prop_assert_eq!(orders, each);
    }

    #[test]
    fn a_prepared_surface_is_the_surface(surface in surface(), at in vec((fraction(), fraction()), 1..99)) {
        let (domain_u, domain_v) = (surface.domain_u(), surface.domain_v());
        let places: Vec<[f64; 2]> =
            at.into_iter().map(|(f, g)| [domain_u.at(f), domain_v.at(g)]).collect();
        let evaluator = surface.evaluator();
        // Points are quotients: what is rounded is as large as the homogeneous coordinates, and is
        // divided by as little as the least weight.
        let net = surface.control_points().as_slice();
        let largest = net.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        let least = net.iter().map(|point| point.w).fold(f64::INFINITY, f64::min);
        let rounded = largest / least;
        let (mut points, mut orders) = (Vec::new(), Vec::new());
        evaluator.each_point(&places, |point| points.push(point));
        evaluator.each_second_order(&places, |order| orders.push(order));
        for ((&[u, v], point), order) in places.iter().zip(points).zip(orders) {
            let miss = point.distance(surface.point_at(u, v));
            prop_assert!(miss <= 4e-15 * rounded, "{u}, {v} misses by {miss:e} of {rounded}");
            prop_assert_eq!(point, evaluator.point_at(u, v));
            prop_assert_eq!(order, evaluator.second_order_at(u, v));
            let width = |knots: &KnotVector, t| knots.span_interval(knots.span_at(t)).length();
            let (unit_u, unit_v) = (width(surface.knots_u(), u), width(surface.knots_v(), v));
            let units = [1.0, unit_u, unit_v, unit_u * unit_u, unit_u * unit_v, unit_v * unit_v];
            let size: f64 = order.iter().zip(units).map(|(d, unit)| d.length() * unit).sum();
            let all = surface.derivatives_at(u, v, 2);
            let orders = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
            for (i, (k, l)) in orders.into_iter().enumerate() {
                let miss = order[i].distance(all.get(k, l)) * units[i];
                prop_assert!(miss <= 1e-12 * (1.0 + size), "{k}, {l} at {u}, {v} misses by {miss:e}");
            }
        }
    }

    #[test]
    fn every_degree_is_prepared(points in vec(point(), 1..=101), f in fraction()) {
        let curve = NurbsCurve::bezier(&points).unwrap();
        let (by_knots, evaluator) = (curve.derivatives_at(f, 2), curve.evaluator());
        prop_assert!(are_near(evaluator.point_at(f), by_knots[0], 1e-13));
        let size = (points.len() * points.len()) as f64;
        for (prepared, by_knots) in evaluator.second_order_at(f).into_iter().zip(by_knots) {
            prop_assert!(are_near(prepared, by_knots, 1e-13 * size));
        }
    }
}

#[test]
fn a_prepared_surface_may_have_any_degree() {
    let point = |i: usize, j: usize| DVec3::new(i as f64, j as f64, ((3 * i + 5 * j) % 7) as f64);
    for (n, m) in [(1, 1), (1, 9), (2, 4), (7, 3), (8, 8)] {
        let surface = NurbsSurface::bezier(&Grid::from_fn(n, m, point)).unwrap();
        for [u, v] in [[0.0, 0.0], [0.3, 0.6], [1.0, 1.0]] {
            let found = surface.evaluator().second_order_at(u, v);
            assert!(are_near(found[0], surface.point_at(u, v), 1e-13));
            assert!(are_near(found[4], surface.derivatives_at(u, v, 1).get(1, 1), 1e-12));
            let mut of_each = Vec::new();
            surface.evaluator().each_point(&[[u, v]], |point| of_each.push(point));
            assert!(are_near(of_each[0], found[0], 1e-13));
        }
    }
}

#[test]
fn crowded_knots_find_their_pieces() {
    // Widths that halve: all but a few of the knots lie in one of the equal parts of the domain.
    let mut knots = vec![0.0; 4];
    knots.extend((0..30).rev().map(|i| libm::exp2(-f64::from(i))));
    knots.extend([1.0; 3]);
    let knots = KnotVector::new(3, knots).unwrap();
    let points: Vec<DVec3> =
        (0..knots.n_points()).map(|i| DVec3::new(i as f64, (i % 3) as f64, 0.0)).collect();
    let breaks = knots.breaks();
    let curve = NurbsCurve::polynomial(knots, &points).unwrap();
    let evaluator = curve.evaluator();
    for pair in breaks.windows(2) {
        for t in [pair[0], pair[0].midpoint(pair[1]), pair[1].next_down(), pair[1]] {
            assert!(are_near(evaluator.point_at(t), curve.point_at(t), 1e-14), "at {t}");
        }
    }
}

#[test]
fn a_prepared_curve_of_lines_does_not_bend() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [4.0, 0.0, 1.0]].map(DVec3::from_array);
    let path = NurbsCurve::polyline(&corners).unwrap();
    let [_, velocity, acceleration] = path.evaluator().second_order_at(1.0);
    assert_eq!([velocity, acceleration], [corners[2] - corners[1], DVec3::ZERO]);
}

#[test]
fn a_prepared_circle_is_round() {
    let form = CircleForm::NinePoint;
    let circle = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, form).unwrap();
    let (domain, circle) = (circle.domain(), circle.evaluator());
    for i in 0..=1000 {
        let [point, first, second] = circle.second_order_at(domain.at(f64::from(i) / 1000.0));
        assert!((point.length() - 1.0).abs() < 1e-15);
        let curvature = first.cross(second).length() / libm::pow(first.length(), 3.0);
        assert!((curvature - 1.0).abs() < 1e-13, "curvature {curvature}");
    }
}

#[test]
fn a_parameter_that_is_no_number_has_a_point_that_is_none() {
    let line = NurbsCurve::line(DVec3::ZERO, DVec3::X).unwrap();
    assert!(line.evaluator().point_at(f64::NAN).x.is_nan());
}
