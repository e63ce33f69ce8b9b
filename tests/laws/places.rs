//! Places on curves: what stands out, what is nearest, where they meet, and by arc length.

use glam::{DAffine3, DMat3, DVec3};
use proptest::{prelude::*, proptest};
use virote_kernel::{
    CircleForm, Frame, GeomError, IntersectionError, Interval, NurbsCurve, Tolerance,
};

use crate::some::{curve, fraction, parameter, point};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn flat(curve: &NurbsCurve) -> NurbsCurve {
    let flatten = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
    curve.transformed(&DAffine3 { matrix3: flatten, translation: DVec3::ZERO })
}

fn bezier(points: &[(f64, f64)]) -> NurbsCurve {
    let points: Vec<DVec3> = points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    NurbsCurve::bezier(&points).unwrap()
}

fn ellipse(rx: f64, ry: f64) -> NurbsCurve {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    circle.transformed(&DAffine3::from_scale(DVec3::new(rx, ry, 1.0)))
}

#[track_caller]
fn are(found: &[f64], expected: &[f64]) {
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12;
    let fits = found.len() == expected.len() && found.iter().zip(expected).all(is_near);
    assert!(fits, "found {found:?}, expected {expected:?}");
}

/// The crossing of both curves to which Newton's method leads from these parameters, if it does.
fn refined(a: &NurbsCurve, b: &NurbsCurve, mut t: f64, mut s: f64) -> Option<(f64, f64)> {
    for _ in 0..50 {
        let (p, q) = (a.derivatives_at(t, 1), b.derivatives_at(s, 1));
        let (apart, across) = (q[0] - p[0], p[1].cross(q[1]).z);
        t = (t + apart.cross(q[1]).z / across).clamp(a.domain().start(), a.domain().end());
        s = (s + apart.cross(p[1]).z / across).clamp(b.domain().start(), b.domain().end());
    }
    let has_met = t.is_finite() && s.is_finite() && a.point_at(t).distance(b.point_at(s)) < 1e-9;
    has_met.then_some((t, s))
}

/// Where the polygon through many points of one curve crosses that of another, by parameters.
fn crossings_of_samples(a: &NurbsCurve, b: &NurbsCurve, n: usize, skip: usize) -> Vec<(f64, f64)> {
    let (of_a, of_b) = (a.domain().steps(n), b.domain().steps(n));
    let (p, q): (Vec<DVec3>, Vec<DVec3>) = (
        of_a.iter().map(|&t| a.point_at(t)).collect(),
        of_b.iter().map(|&t| b.point_at(t)).collect(),
    );
    let side = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a).z;
    let mut found = Vec::new();
    for i in 0..n {
        let from = if skip > 0 { i + skip } else { 0 };
        for j in from..n {
            let apart = p[i].min(p[i + 1]).cmpgt(q[j].max(q[j + 1])).any()
                || q[j].min(q[j + 1]).cmpgt(p[i].max(p[i + 1])).any();
            if apart {
                continue;
            }
            let (c, d) = (side(p[i], p[i + 1], q[j]), side(p[i], p[i + 1], q[j + 1]));
            let (e, f) = (side(q[j], q[j + 1], p[i]), side(q[j], q[j + 1], p[i + 1]));
            if c * d < 0.0 && e * f < 0.0 {
                found.extend(refined(a, b, of_a[i], of_b[j]));
            }
        }
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Against samples, each improved by the neighbourhood's best.
    #[test]
    fn nothing_is_nearer_than_the_nearest(curve in curve(), p in point()) {
        let foot = curve.closest(p, TOLERANCE.distance);
        prop_assert!((curve.point_at(foot.parameter).distance(p) - foot.distance).abs() <= 1e-12);
        let nearest = curve
            .sample(2000)
            .into_iter()
            .map(|point| point.distance(p))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(foot.distance <= nearest + 1e-12 * (1.0 + nearest));
        prop_assert!(foot.count >= 1);
    }

    #[test]
    fn a_point_of_the_curve_is_its_own_foot(curve in curve(), fraction in fraction()) {
        let p = curve.point_at(parameter(&curve, fraction));
        prop_assert!(curve.closest(p, TOLERANCE.distance).distance <= 1e-9);
    }

    #[test]
    fn every_crossing_of_samples_is_a_meeting(a in curve(), b in curve()) {
        let (a, b) = (flat(&a), flat(&b));
        let meetings = a.intersections(&b, TOLERANCE.distance).unwrap();
        for meeting in &meetings {
            let (p, q) = (a.point_at(meeting.first), b.point_at(meeting.second));
            prop_assert!(p.distance(q) <= TOLERANCE.distance);
        }
        for (t, s) in crossings_of_samples(&a, &b, 400, 0) {
            let near = |x: f64, y: f64, curve: &NurbsCurve| {
                (x - y).abs() <= 1e-6 * curve.domain().length()
            };
            prop_assert!(
                meetings.iter().any(|m| near(m.first, t, &a) && near(m.second, s, &b)),
                "at {t}, {s} of {meetings:?}"
            );
        }
    }

    #[test]
    fn every_crossing_of_a_curve_with_itself_is_told(curve in curve()) {
        let curve = flat(&curve);
        let meetings = curve.self_intersections(TOLERANCE.distance).unwrap();
        for meeting in &meetings {
            prop_assert!(meeting.first < meeting.second);
            let (p, q) = (curve.point_at(meeting.first), curve.point_at(meeting.second));
            prop_assert!(p.distance(q) <= TOLERANCE.distance);
        }
        for (t, s) in crossings_of_samples(&curve, &curve, 400, 6) {
            let near = |x: f64, y: f64| (x - y).abs() <= 1e-6 * curve.domain().length();
            let is_told = |t: f64, s: f64| {
                meetings.iter().any(|m| near(m.first, t) && near(m.second, s))
            };
            prop_assert!(
                near(t, s) || is_told(t, s) || is_told(s, t),
                "at {t}, {s} of {meetings:?}"
            );
        }
    }

    /// Every change of sign between samples is among them, and there is one near each.
    #[test]
    fn inflections_are_where_the_signed_curvature_changes_sign(curve in curve()) {
        let curve = flat(&curve);
        let found = curve.inflections(TOLERANCE);
        let bend = |t: f64| {
            let d = curve.derivatives_at(t, 2);
            let clear = 1e-9 * d[1].length() * (d[1].length() + d[2].length());
            Some(d[1].cross(d[2]).z).filter(|bend| clear < bend.abs())
        };
        let corners = curve.corners(TOLERANCE);
        let steps = curve.domain().steps(500);
        for pair in steps.windows(2) {
            let bends = bend(pair[0]).zip(bend(pair[1]));
            if bends.is_some_and(|(before, behind)| before * behind < 0.0) {
                let among = |t: &f64| pair[0] - 1e-9 <= *t && *t <= pair[1] + 1e-9;
                prop_assert!(found.iter().any(among) || corners.iter().any(among));
            }
        }
    }

    #[test]
    fn extrema_are_where_the_curve_turns_round(curve in curve(), direction in point()) {
        prop_assume!(direction.length() > 0.1);
        let found = curve.extrema(direction.normalize(), TOLERANCE);
        let steps = curve.domain().steps(500);
        let along: Vec<f64> = steps.iter().map(|&t| curve.point_at(t).dot(direction)).collect();
        for i in 1..steps.len() - 1 {
            let turns = (along[i] - along[i - 1]) * (along[i + 1] - along[i]) < 0.0;
            let among = |t: &f64| steps[i - 1] <= *t && *t <= steps[i + 1];
            prop_assert!(!turns || found.iter().any(among), "near {}", steps[i]);
        }
    }

    #[test]
    fn a_parameter_at_a_length_has_that_length(curve in curve(), fraction in fraction()) {
        let total = curve.length(curve.domain());
        let t = curve.parameter_at_length(fraction * total).unwrap();
        let part = Interval::new(curve.domain().start(), t);
        let length = part.map_or(0.0, |part| curve.length(part));
        prop_assert!((length - fraction * total).abs() <= 1e-10 * total, "{length} of {total}");
    }

    #[test]
    fn places_move_with_the_curve(curve in curve(), p in point(), by in point()) {
        let map = DAffine3::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.0);
        let map = DAffine3::from_translation(by) * map;
        let moved = curve.transformed(&map);
        let (foot, image) =
            (curve.closest(p, 1e-6), moved.closest(map.transform_point3(p), 1e-6));
        prop_assert!((foot.distance - image.distance).abs() <= 1e-9);
        let direction = DVec3::new(0.0, 0.6, 0.8);
        let turned = moved.extrema(map.transform_vector3(direction), TOLERANCE);
        prop_assert_eq!(curve.extrema(direction, TOLERANCE).len(), turned.len());
    }
}

#[test]
fn an_ellipse_has_four_vertices_and_no_inflection() {
    let oval = ellipse(3.0, 2.0);
    are(&oval.vertices(TOLERANCE), &[0.0, 0.25, 0.5, 0.75]);
    are(&oval.inflections(TOLERANCE), &[]);
    are(&oval.extrema(DVec3::X, TOLERANCE), &[0.0, 0.5]);
    are(&oval.corners(TOLERANCE), &[]);
    assert_eq!(oval.self_intersections(1e-6).unwrap(), []);
}

#[test]
fn a_circle_has_nothing_that_stands_out() {
    for radius in [1e-4, 1.0, 1e6] {
        let circle = ellipse(radius, radius);
        are(&circle.vertices(TOLERANCE), &[]);
        are(&circle.inflections(TOLERANCE), &[]);
        are(&circle.cusps(TOLERANCE), &[]);
    }
}

/// y = x³ − x has its inflection where y'' = 6x vanishes, and it crosses the axis three times.
#[test]
fn a_cubic_graph() {
    // On x = 4t − 2, from −2 to 2.
    let graph = bezier(&[
        (-2.0, -6.0),
        (-2.0 / 3.0, 8.666666666666666),
        (2.0 / 3.0, -8.666666666666666),
        (2.0, 6.0),
    ]);
    are(&graph.inflections(TOLERANCE), &[0.5]);
    let of = |x: f64| (x + 2.0) / 4.0;
    let root = (1.0f64 / 3.0).sqrt();
    are(&graph.extrema(DVec3::Y, TOLERANCE), &[of(-root), of(root)]);
    are(&graph.plane_parameters(Frame::ZX, TOLERANCE), &[of(-1.0), of(0.0), of(1.0)]);
}

/// The quartic (t⁴) is flat at its middle and does not change its way of bending.
#[test]
fn a_flat_place_without_a_change_is_no_inflection() {
    // y = (2t − 1)⁴ on x = t.
    let quartic = bezier(&[(0.0, 1.0), (0.25, -1.0), (0.5, 1.0), (0.75, -1.0), (1.0, 1.0)]);
    are(&quartic.inflections(TOLERANCE), &[]);
}

#[test]
fn the_crossed_square_is_a_cusp() {
    let cusp = bezier(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]);
    are(&cusp.cusps(TOLERANCE), &[0.5]);
    // At a parameter that no halving hits.
    let [_, part] = cusp.split(0.1234).unwrap();
    let part = part.reparametrized(Interval::UNIT);
    let found = part.cusps(TOLERANCE);
    assert_eq!(found.len(), 1);
    assert!((found[0] - (0.5 - 0.1234) / (1.0 - 0.1234)).abs() < 1e-7);
    // Slightly opened it is a loop.
    let open = bezier(&[(0.0, 0.0), (1.02, 1.0), (-0.02, 1.0), (1.0, 0.0)]);
    are(&open.cusps(TOLERANCE), &[]);
    assert_eq!(open.self_intersections(1e-6).unwrap().len(), 1);
}

#[test]
fn corners_and_turns_of_polygons() {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let polygon = NurbsCurve::polyline(&[
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(1.0, 1.0),
        at(1.0, 0.5),
        at(0.0, 0.0),
    ]);
    let polygon = polygon.unwrap();
    are(&polygon.corners(TOLERANCE), &[0.0, 1.0, 3.0]);
    are(&polygon.cusps(TOLERANCE), &[2.0]);
}

#[test]
fn tangents_touch_once() {
    let circle = ellipse(2.0, 2.0);
    let line = NurbsCurve::line(DVec3::new(-3.0, 2.0, 0.0), DVec3::new(3.0, 2.0, 0.0)).unwrap();
    let meetings = circle.intersections(&line, 1e-6).unwrap();
    assert_eq!(meetings.len(), 1);
    assert!((meetings[0].first - 0.25).abs() < 1e-9 && (meetings[0].second - 0.5).abs() < 1e-9);
    let beside = circle.transformed(&DAffine3::from_translation(DVec3::new(4.0, 0.0, 0.0)));
    let meetings = circle.intersections(&beside, 1e-6).unwrap();
    assert_eq!(meetings.len(), 1);
    assert!(meetings[0].point.distance(DVec3::new(2.0, 0.0, 0.0)) < 1e-9);
    let apart = circle.transformed(&DAffine3::from_translation(DVec3::new(4.001, 0.0, 0.0)));
    assert_eq!(circle.intersections(&apart, 1e-6).unwrap(), []);
}

#[test]
fn curves_that_share_a_stretch_are_told() {
    let circle = ellipse(2.0, 2.0);
    let [first, _] = circle.split(0.4).unwrap();
    let error = circle.intersections(&first, 1e-6).unwrap_err();
    assert!(error.to_string().contains("run together"), "{error}");
}

/// A feature of a thousandth of the size between two samples of a thousand.
#[test]
fn a_small_loop_is_not_overlooked() {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let mut points: Vec<DVec3> = (0..200).map(|i| at(f64::from(i), 0.0)).collect();
    points.splice(100..100, [at(99.7, 0.0), at(99.4, 0.3), at(99.3, -0.3)]);
    let knots = virote_kernel::KnotVector::uniform_clamped(3, points.len(), 1.0).unwrap();
    let curve = NurbsCurve::polynomial(knots, &points).unwrap();
    let of_samples = crossings_of_samples(&curve, &curve, 4_000, 2).len();
    assert!(of_samples > 0);
    assert_eq!(curve.self_intersections(1e-6).unwrap().len(), of_samples);
}

#[test]
fn the_centre_of_a_circle_has_feet_all_around() {
    let circle = ellipse(2.0, 2.0);
    let foot = circle.closest(DVec3::ZERO, 1e-6);
    assert!((foot.distance - 2.0).abs() < 1e-15);
    // The whole of it is one stretch.
    assert_eq!((foot.count, foot.stretch), (1, Some(circle.domain())));
    let far = ellipse(2.0, 2.0).closest(DVec3::new(0.0, 1e6, 0.0), 1e-6);
    assert!((far.parameter - 0.25).abs() < 1e-9 && far.count == 1);
}

/// A circle's parameter at a quarter of its length, and the parabola's length in closed form.
#[test]
fn lengths_are_inverted() {
    let circle = ellipse(2.0, 2.0);
    let t = circle.parameter_at_length(std::f64::consts::PI).unwrap();
    assert!((t - 0.25).abs() < 1e-12);
    assert!(circle.parameter_at_length(-0.1).is_err());
    assert!(circle.parameter_at_length(12.6).is_err());
    let parts = circle.divided(3);
    assert_eq!(parts.len(), 4);
    assert!(parts[1].distance(DVec3::new(-1.0, 3f64.sqrt(), 0.0)) < 1e-12);
}

/// A polygon of as many diameters of a circle, each run through once.
fn star(n: usize) -> NurbsCurve {
    let corner = |i: usize| {
        let angle = std::f64::consts::PI * ((i / 2) as f64) / n as f64;
        let out = if i.is_multiple_of(2) == (i / 2).is_multiple_of(2) { 1.0 } else { -1.0 };
        DVec3::new(out * libm::cos(angle), out * libm::sin(angle), 0.0)
    };
    NurbsCurve::polyline(&(0..2 * n).map(corner).collect::<Vec<_>>()).unwrap()
}

/// A curve that comes through one point again and again meets another there each time.
#[test]
fn every_passage_through_a_point_counts() {
    for n in [3, 6, 10] {
        let star = star(n);
        let line =
            NurbsCurve::line(DVec3::new(-0.3, -0.1, 0.0), DVec3::new(0.3, 0.1, 0.0)).unwrap();
        let is_middle = |point: &DVec3| point.length() < 1e-6;
        let meetings = line.intersections(&star, 1e-6).unwrap();
        assert_eq!(meetings.iter().filter(|meeting| is_middle(&meeting.point)).count(), n);
        let own = star.self_intersections(1e-6).unwrap();
        let own = own.iter().filter(|meeting| is_middle(&meeting.point));
        assert_eq!(own.count(), n * (n - 1) / 2);
    }
}

/// A figure of eight that begins where it crosses itself crosses itself once.
#[test]
fn a_crossing_at_the_seam_counts_once() {
    let points =
        [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [0.0, 0.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, 0.0]];
    let eight = NurbsCurve::polyline(&points.map(|[x, y]| DVec3::new(x, y, 0.0))).unwrap();
    let meetings = eight.self_intersections(1e-6).unwrap();
    assert_eq!(meetings.len(), 1, "{meetings:?}");
    are(&[meetings[0].first, meetings[0].second], &[0.0, 3.0]);
}

/// A curve that ends on a line at a small angle meets it in its end; one that only drifts beside another, within the
/// tolerance up to an end of it, runs together with it.
#[test]
fn what_ends_on_a_curve_at_a_small_angle_does_not_run_along_it() {
    let line = bezier(&[(0.0, 0.0), (10.0, 0.0)]);
    for slope in [1.0, 0.1, 0.05, 0.01, 1e-3] {
        for bent in [0.0, 0.3] {
            let start = (0.4, -3.0 * slope);
            let middle = (0.5 * (start.0 + 3.3), 0.5 * start.1 * (1.0 + bent));
            let curve = bezier(&[start, middle, (3.3, 0.0)]);
            for [a, b] in [[&line, &curve], [&curve, &line]] {
                let found = a.intersections(b, 1e-6).unwrap();
                assert!(found.len() == 1, "slope {slope}: {found:?}");
                let off = found[0].point.distance(DVec3::X * 3.3);
                assert!(off <= 1e-12, "slope {slope}: {off} off");
            }
        }
    }
    let beside = [
        [bezier(&[(0.0, 5e-7), (5.0, -4e-7)]), line.clone()],
        [bezier(&[(0.0, 1e-7), (1.25, 0.0), (2.5, 0.0)]), line],
        [
            bezier(&[(0.0, 0.0), (5.0, 4.0), (10.0, 0.0)]),
            bezier(&[(0.0, 3e-7), (0.5, 0.400_000_1), (1.0, 0.720_000_4)]),
        ],
    ];
    for [a, b] in beside {
        for found in [a.intersections(&b, 1e-6), b.intersections(&a, 1e-6)] {
            let is_told = matches!(
                found,
                Err(GeomError::Intersection(IntersectionError::RunTogether { .. }))
            );
            assert!(is_told, "{found:?}");
        }
    }
}
