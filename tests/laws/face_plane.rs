//! Parts of plane patches: curves on them go over as what they are, and are measured by their borders.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    CircleForm, Cutter, Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface, Tolerance,
    glam::DVec3,
};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;
const CORNER: DVec3 = DVec3::new(1.0, 2.0, 3.0);
const ALONG: [DVec3; 2] = [DVec3::new(4.0, 1.0, 0.5), DVec3::new(-1.0, 3.0, 2.0)];

/// A patch with sides that are neither equal nor at a right angle.
fn patch() -> Face {
    let [a, b] = ALONG;
    let surface = NurbsSurface::bilinear(CORNER, CORNER + b, CORNER + a, CORNER + a + b).unwrap();
    Face::whole(Arc::new(surface), TOLERANCE).unwrap()
}

fn frame(u: f64, v: f64, aside: f64) -> Frame {
    let [a, b] = ALONG;
    let normal = a.cross(b).normalize();
    let place = CORNER + a * u + b * v + normal * aside;
    Frame::from_normal(place, normal, None).unwrap()
}

fn circle(frame: Frame, radius: f64) -> NurbsCurve {
    NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).unwrap()
}

#[track_caller]
fn check(found: f64, right: f64) {
    assert!((found - right).abs() <= 1e-12 * right.abs().max(1.0), "{found} for {right}");
}

#[test]
fn a_circle_on_a_skew_patch_divides_it_and_stays_a_circle() {
    for aside in [0.0, 0.5, -0.9].map(|share| share * TOLERANCE.distance) {
        let (frame, radius) = (frame(0.45, 0.55, aside), 0.7);
        let parts =
            patch().split(&[Cutter::Curve(circle(frame, radius))], TOLERANCE).expect("two parts");
        assert_eq!(parts.len(), 2);
        let [a, b] = ALONG;
        let sum: f64 = parts.iter().map(|part| part.mass().unwrap().amount).sum();
        check(sum, a.cross(b).length());
        let disc = parts
            .iter()
            .min_by(|a, b| a.mass().unwrap().amount.total_cmp(&b.mass().unwrap().amount))
            .unwrap();
        let mass = disc.mass().unwrap();
        check(mass.amount, PI * radius * radius);
        let foot = frame.origin() - frame.z() * aside;
        assert!(mass.centroid.distance(foot) < 1e-13);
        let about = |axis: DVec3| axis.dot(mass.inertia * axis);
        let quarter = PI * (radius * radius) * (radius * radius) / 4.0;
        check(about(frame.z()), 2.0 * quarter);
        check(about(frame.x()), quarter);
        check(frame.x().dot(mass.inertia * frame.y()), 0.0);
        let edges = disc.edges(TOLERANCE).unwrap();
        assert!(edges.iter().all(|edge| edge.degree() == 2), "{edges:?}");
        let off = |p: DVec3| ((p - foot).length() - radius).abs() + (p - foot).dot(frame.z()).abs();
        let places = edges
            .iter()
            .flat_map(|edge| edge.domain().steps(7).into_iter().map(|t| edge.point_at(t)));
        assert!(places.map(off).fold(0.0, f64::max) < 1e-14 * 64.0);
    }
}

#[test]
fn what_leaves_a_plane_patch_is_told() {
    let aside = circle(frame(0.45, 0.55, 2.0 * TOLERANCE.distance), 0.7);
    let over_the_border = circle(frame(0.1, 0.5, 0.0), 0.7);
    for curve in [aside, over_the_border] {
        let found = patch().split(&[Cutter::Curve(curve)], TOLERANCE);
        assert!(matches!(found, Err(GeomError::Face(FaceError::OffSurface { .. }))), "{found:?}");
    }
}

#[test]
fn a_straight_curve_of_any_degree_is_a_line_on_a_plane_patch() {
    let [a, b] = ALONG;
    let at = |u: f64, v: f64| CORNER + a * u + b * v;
    let points = [0.0, 0.1, 0.8, 1.0].map(|v| at(0.25 + 0.5 * v, v));
    let across = NurbsCurve::bezier(&points).unwrap();
    let parts = patch().split(&[Cutter::Curve(across)], TOLERANCE).unwrap();
    assert_eq!(parts.len(), 2);
    for part in &parts {
        check(part.mass().unwrap().amount, 0.5 * a.cross(b).length());
        let edges = part.edges(TOLERANCE).unwrap();
        assert!(edges.iter().all(|edge| edge.points().len() == 2), "{edges:?}");
    }
    // One that runs back along itself is none.
    let back = [0.0, 1.4, -0.4, 1.0].map(|v| at(0.25 + 0.5 * v, 0.1 + 0.8 * v));
    let back = NurbsCurve::bezier(&back).unwrap();
    assert!(patch().split(&[Cutter::Curve(back)], TOLERANCE).is_err());
}
