//! Parameters far from zero, such as seconds of an epoch, and spans as narrow as knots may stand: what is found does
//! not depend on where a domain begins, and places are not taken for one by their parameters alone.

use virote_kernel::{
    CircleForm, Curve, Frame, Interval, KnotVector, NurbsCurve, NurbsSurface, Surface, Tolerance,
    glam::DVec3,
};

const STARTS: [f64; 4] = [0.0, -7e3, 1e7, 1.7e9];

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn at(curve: &NurbsCurve, start: f64) -> NurbsCurve {
    let length = curve.domain().length();
    curve.reparametrized(Interval::new(start, start + length).unwrap())
}

/// A wave that passes the x axis four times and comes back to itself once.
fn track() -> NurbsCurve {
    let places = [
        (0.0, 10.0),
        (100.0, -30.0),
        (200.0, 40.0),
        (300.0, -50.0),
        (420.0, 60.0),
        (300.0, 90.0),
        (150.0, 60.0),
        (120.0, -40.0),
        (90.0, 20.0),
    ];
    let points: Vec<DVec3> = places.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    let knots = KnotVector::uniform_clamped(3, points.len(), 60.0).unwrap();
    NurbsCurve::polynomial(knots, &points).unwrap()
}

#[track_caller]
fn check(found: &[DVec3], expected: &[DVec3], start: f64) {
    assert_eq!(found.len(), expected.len(), "from {start}: {found:?} for {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.distance(*expected) < 1e-6, "from {start}: {found} for {expected}");
    }
}

#[test]
fn where_a_domain_begins_curves_meet_the_same_places() {
    let track = track();
    let level = Frame::ZX.at(DVec3::Y * 11.0);
    let line = NurbsCurve::line(DVec3::new(-10.0, 1.0, 0.0), DVec3::new(500.0, 3.0, 0.0)).unwrap();
    let points = |curve: &NurbsCurve, other: &NurbsCurve| -> Vec<DVec3> {
        curve.intersections(other, 1e-6).unwrap().iter().map(|meeting| meeting.point).collect()
    };
    let own = |curve: &NurbsCurve| -> Vec<DVec3> {
        curve.self_intersections(1e-6).unwrap().iter().map(|meeting| meeting.point).collect()
    };
    let sections = track.plane_points(level, TOLERANCE);
    let (crossings, loops) = (points(&track, &line), own(&track));
    assert!(4 <= crossings.len() && 2 <= sections.len() && !loops.is_empty());
    for start in STARTS {
        let there = at(&track, start);
        check(&there.plane_points(level, TOLERANCE), &sections, start);
        check(&points(&there, &line), &crossings, start);
        check(&own(&there), &loops, start);
        let parameters = there.plane_parameters(level, TOLERANCE);
        assert!(parameters.len() == sections.len());
        assert!(parameters.iter().all(|&t| there.domain().contains(t)));
        for meeting in there.intersections(&line, 1e-6).unwrap() {
            // As near as the last bit of the parameter tells.
            let near = 1e-6 + 1e3 * f64::EPSILON * start.abs();
            assert!(there.point_at(meeting.first).distance(meeting.point) <= near);
        }
    }
}

#[test]
fn where_a_domain_begins_surfaces_meet_the_same_places() {
    let track = track();
    let wall =
        |curve: &NurbsCurve| Surface::from(NurbsSurface::extruded(curve, DVec3::Z * 50.0).unwrap());
    let corner = |x: f64, z: f64| DVec3::new(x, 2.0 + 0.01 * x, z);
    let patch = NurbsSurface::bilinear(
        corner(-10.0, -20.0),
        corner(-10.0, 80.0),
        corner(500.0, -20.0),
        corner(500.0, 80.0),
    );
    let patch = Surface::from(patch.unwrap());
    let plane = Frame::from_normal(DVec3::new(10.0, 5.0, 10.0), DVec3::new(0.1, 1.0, 0.2), None);
    let plane = plane.unwrap();
    let pierced = |curve: NurbsCurve| -> Vec<DVec3> {
        let found = patch.piercings(&Curve::from(curve), TOLERANCE).unwrap();
        found.iter().map(|place| place.point).collect()
    };
    let length = |curves: &[NurbsCurve]| -> f64 {
        curves.iter().map(|curve| curve.length(curve.domain())).sum()
    };
    let expected = pierced(track.clone());
    let crossed = wall(&track).intersections(&patch, TOLERANCE).unwrap().curves;
    let cut = wall(&track).section(plane, TOLERANCE).unwrap().curves;
    assert!(!expected.is_empty() && !crossed.is_empty() && !cut.is_empty());
    for start in STARTS {
        let there = at(&track, start);
        let found = wall(&there).intersections(&patch, TOLERANCE).unwrap().curves;
        assert_eq!(found.len(), crossed.len(), "from {start}");
        assert!((length(&found) - length(&crossed)).abs() < 1e-4, "from {start}");
        let found = wall(&there).section(plane, TOLERANCE).unwrap().curves;
        assert_eq!(found.len(), cut.len(), "from {start}");
        assert!((length(&found) - length(&cut)).abs() < 1e-4, "from {start}");
        check(&pierced(there), &expected, start);
    }
}

/// A circle far from the origin has two places that stand out along a direction, one of them at its seam.
#[test]
fn a_place_at_the_seam_is_told_once_however_far_the_origin_is() {
    for k in 0..40 {
        let x = 0.1 * f64::from(k);
        for far in [0.0, 1e5, 1e7] {
            let normal = DVec3::new(0.3, x, 1.0);
            let frame = Frame::from_normal(DVec3::new(far + x, far, x), normal, None).unwrap();
            let circle = NurbsCurve::ellipse(frame, [1.0, 1.0], CircleForm::NinePoint).unwrap();
            let found = circle.extrema(frame.x(), TOLERANCE);
            assert_eq!(found.len(), 2, "at {far} + {x}: {found:?}");
            let found = circle.extrema(DVec3::X, TOLERANCE);
            assert_eq!(found.len(), 2, "at {far} + {x}: {found:?}");
        }
    }
}

/// Knots a billionth apart are knots, and between them the curve may go anywhere.
#[test]
fn places_in_narrow_spans_are_told_each() {
    let places = [(0.0, 0.0), (1.0, 1.0), (2.0, -1.0), (3.0, 0.5)];
    let points: Vec<DVec3> = places.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    let knots = KnotVector::new(1, vec![0.0, 0.0, 1e-9, 2e-9, 1.0, 1.0]).unwrap();
    let zigzag = NurbsCurve::polynomial(knots, &points).unwrap();
    assert_eq!(zigzag.extrema(DVec3::Y, TOLERANCE), [1e-9, 2e-9]);
    let found = zigzag.plane_points(Frame::ZX.at(DVec3::Y * 0.5), TOLERANCE);
    check(&found, &[(0.5, 0.5), (1.25, 0.5), (3.0, 0.5)].map(|(x, y)| DVec3::new(x, y, 0.0)), 0.0);
}
