//! Laws of knots: which span a parameter belongs to, which knots are one, and how they turn around.

#![expect(clippy::float_cmp, reason = "knots that are one have the same bits")]

use glam::DVec3;
use proptest::{prop_assert, proptest};
use virote_kernel::{
    Curve, Direction, Grid, Interval, KnotVector, NurbsCurve, NurbsSurface, Side,
    tolerance::KNOT_RELATIVE,
};

use crate::some::knots;

/// A polyline with its corners at these parameters: its derivative tells the span.
fn polyline(parameters: &[f64]) -> NurbsCurve {
    let n = parameters.len();
    let all = [&parameters[..1], parameters, &parameters[n - 1..]].concat();
    let knots = KnotVector::new(1, all).unwrap();
    let point = |(i, &t): (usize, &f64)| DVec3::new(t, (i * i) as f64, 0.0);
    let points: Vec<DVec3> = parameters.iter().enumerate().map(point).collect();
    NurbsCurve::polynomial(knots, &points).unwrap()
}

/// A cubic with one inner knot on 0..1.
fn with_a_knot_at(t: f64) -> NurbsCurve {
    let knots = KnotVector::new(3, vec![0.0, 0.0, 0.0, 0.0, t, 1.0, 1.0, 1.0, 1.0]).unwrap();
    let points = [[0.0, 0.0], [1.0, 2.0], [2.0, -1.0], [4.0, 1.0], [5.0, 0.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, x * y));
    NurbsCurve::polynomial(knots, &points).unwrap()
}

/// What the knots between the ends of a clamped cubic are.
fn inner(curve: &NurbsCurve) -> Vec<f64> {
    let knots = curve.knots().as_slice();
    knots[4..knots.len() - 4].to_vec()
}

proptest! {
    #[test]
    fn a_knot_begins_its_span_and_ends_the_one_before(knots in knots()) {
        let breaks = knots.breaks();
        let last = breaks.len() - 1;
        for (i, &t) in breaks.iter().enumerate() {
            let ends = |span: usize| {
                let ends = knots.span_interval(span);
                [ends.start(), ends.end()]
            };
            let before = [breaks[i.max(1) - 1], breaks[i.max(1)]];
            let behind = [breaks[i.min(last - 1)], breaks[i.min(last - 1) + 1]];
            prop_assert!(ends(knots.span_at(t)) == behind);
            prop_assert!(ends(knots.span_beside(t, Side::Right)) == behind);
            prop_assert!(ends(knots.span_beside(t, Side::Left)) == before);
            // The neighbours among the numbers belong to their own spans, beyond the ends to the
            // outermost.
            prop_assert!(ends(knots.span_at(t.next_down())) == before);
            prop_assert!(ends(knots.span_at(t.next_up())) == behind);
            for side in [Side::Left, Side::Right] {
                prop_assert!(ends(knots.span_beside(t.next_down(), side)) == before);
                prop_assert!(ends(knots.span_beside(t.next_up(), side)) == behind);
            }
        }
    }

    #[test]
    fn knots_turned_around_stand_as_far_from_the_other_end(knots in knots()) {
        let n = knots.n_points();
        let points: Vec<DVec3> = (0..n).map(|i| DVec3::splat(i as f64)).collect();
        let curve = NurbsCurve::polynomial(knots.clone(), &points).unwrap();
        let turned = curve.reversed();
        let ends = knots.domain().start() + knots.domain().end();
        prop_assert!(turned.domain() == curve.domain());
        let all = turned.knots().as_slice();
        prop_assert!(all.is_sorted() && all.len() == n + knots.degree() + 1);
        for (&there, &here) in all.iter().rev().zip(knots.as_slice()) {
            prop_assert!((there - (ends - here)).abs() < 1e-14);
        }
    }
}

#[test]
fn at_an_uneven_knot_the_next_segment_counts() {
    // Of so many spans an even guess is too low at some of the knots and too high at others.
    for parameters in [
        vec![0.0, 0.1, 2.0],
        vec![0.0, 1.9, 2.0],
        vec![-1.0, -0.9, -0.7, 3.0, 8.0],
        vec![0.0, 5.0, 6.0, 6.5, 7.0],
        vec![0.0, 1.0, 2.0, 3.0, 3.25],
    ] {
        let curve = polyline(&parameters);
        let last = parameters.len() - 1;
        for (i, &t) in parameters.iter().enumerate() {
            let slope = |i: usize| {
                let rise = ((i + 1) * (i + 1) - i * i) as f64;
                rise / (parameters[i + 1] - parameters[i])
            };
            let near = |side: Side, expected: f64| {
                let found = curve.derivatives_beside(t, side, 1)[1].y;
                assert!((found - expected).abs() < 1e-12 * expected, "{parameters:?} at {t}");
            };
            let behind = slope(i.min(last - 1));
            assert!((curve.derivatives_at(t, 1)[1].y - behind).abs() < 1e-12 * behind);
            near(Side::Right, behind);
            near(Side::Left, slope(i.max(1) - 1));
        }
    }
}

#[test]
fn a_knot_beside_another_is_that_one() {
    for at in [0.375, 0.9] {
        let curve = with_a_knot_at(at);
        for off in [-0.5, 0.5].map(|part| part * KNOT_RELATIVE) {
            assert_eq!(inner(&curve.insert_knots(&[at + off]).unwrap()), [at, at], "{off}");
            let [left, right] = curve.split(at + off).unwrap();
            assert_eq!([left.domain().end(), right.domain().start()], [at, at], "{off}");
            let part = curve.trimmed(Interval::new(0.125, at + off).unwrap()).unwrap();
            assert_eq!(part.domain().end(), at, "{off}");
            let part = curve.trimmed(Interval::new(at + off, 0.96875).unwrap()).unwrap();
            assert_eq!(part.domain().start(), at, "{off}");
            assert_eq!(inner(&curve.without_knot(at + off, 1, 100.0).unwrap()), [0.0; 0], "{off}");
        }
        // What is further off is a knot of its own.
        for off in [-4.0, 4.0].map(|part| part * KNOT_RELATIVE) {
            let found = inner(&curve.insert_knots(&[at + off]).unwrap());
            assert_eq!(found.iter().filter(|&&t| t == at).count(), 1, "{off}");
            assert!(found.contains(&(at + off)), "{off}");
        }
    }
}

#[test]
fn a_knot_of_a_surface_beside_another_is_that_one() {
    let knots = || with_a_knot_at(0.375).knots().clone();
    let point = |i: usize, j: usize| DVec3::new(i as f64, j as f64, (i * j) as f64);
    let surface = NurbsSurface::polynomial(knots(), knots(), &Grid::from_fn(5, 5, point)).unwrap();
    for along in [Direction::U, Direction::V] {
        for off in [-0.5, 0.5].map(|part| part * KNOT_RELATIVE) {
            let [left, right] = surface.split(along, 0.375 + off).unwrap();
            let domain = |surface: &NurbsSurface| match along {
                Direction::U => surface.domain_u(),
                Direction::V => surface.domain_v(),
            };
            assert_eq!([domain(&left).end(), domain(&right).start()], [0.375; 2], "{off}");
        }
    }
}

#[test]
fn unclamped_knots_are_mirrored_beyond_the_ends() {
    let given = vec![-3.0, -1.0, 0.0, 2.0, 3.0, 7.0, 8.0, 12.0];
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, -1.0], [4.0, 4.0], [6.0, 0.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, 1.0));
    let knots = KnotVector::new(2, given).unwrap();
    let curve = NurbsCurve::polynomial(knots, &points).unwrap();
    let turned = curve.reversed();
    // From the domain 0..7.
    assert_eq!(turned.knots().as_slice(), [-5.0, -1.0, 0.0, 4.0, 5.0, 7.0, 8.0, 10.0]);
    for t in [0.0, 0.5, 2.0, 3.0, 6.9, 7.0] {
        assert!(turned.point_at(7.0 - t).distance(curve.point_at(t)) < 1e-14, "{t}");
    }
    assert_eq!(turned.reversed().knots(), curve.knots());

    let surface = NurbsSurface::polynomial(
        curve.knots().clone(),
        KnotVector::bezier(1).unwrap(),
        &Grid::from_fn(5, 2, |i, j| points[i] + DVec3::Z * j as f64),
    )
    .unwrap();
    let turned = surface.reversed(Direction::U);
    assert_eq!(turned.knots(Direction::U).as_slice(), [-5.0, -1.0, 0.0, 4.0, 5.0, 7.0, 8.0, 10.0]);
    assert!(turned.point_at(6.5, 0.25).distance(surface.point_at(0.5, 0.25)) < 1e-14);
    // A curve of either kind says the same.
    let either = Curve::from(curve.clone()).reversed().unwrap();
    assert!(either.point_at(6.5).unwrap().distance(curve.point_at(0.5)) < 1e-14);
}

#[test]
fn knots_that_come_again_after_a_period_are_periodic() {
    // Steps of 1, 1/2 and 3/2, so that no knot comes again by chance.
    let mut knots = vec![-2.0, -1.5, 0.0, 1.0, 1.5, 3.0, 4.0, 4.5];
    let class = KnotVector::new(2, knots.clone()).unwrap().class();
    assert!(class.is_periodic && !class.is_uniform && !class.is_clamped);
    assert_eq!(class.word(), "periodic");
    for (idx, moved) in [(0, -2.25), (7, 5.0)] {
        let before = std::mem::replace(&mut knots[idx], moved);
        let class = KnotVector::new(2, knots.clone()).unwrap().class();
        assert!(!class.is_periodic, "knot {idx} at {moved} instead of {before}");
        assert_eq!(class.word(), "unclamped");
        knots[idx] = before;
    }
}
