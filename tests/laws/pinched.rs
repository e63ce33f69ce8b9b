//! Surfaces that narrow to a point, that lie on one another in part, that are flat where curves cross, and that cross
//! at a small angle: what is told of them, turned in every way, against closed forms.

use std::{
    f64::consts::{PI, SQRT_2, TAU},
    sync::Arc,
};

use virote_kernel::{
    Axis, Cutter, Face, Frame, GeomError, Grid, KnotVector, NurbsCurve, NurbsSurface, PictureError,
    Solid, SolidError, Surface, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn whole(surface: NurbsSurface) -> Face {
    Face::whole(Arc::new(surface), TOLERANCE).unwrap()
}

fn place(n: u64) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(0.3, -1.7, 0.9)) * turn(n)
}

/// A cone of both sides with the apex in the origin, as wide as it is high.
fn double_cone() -> NurbsSurface {
    let side = [DVec3::new(1.0, 0.0, -1.0), DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0)];
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    NurbsSurface::revolved(&NurbsCurve::polyline(&side).unwrap(), axis, TAU).unwrap()
}

#[test]
fn planes_through_the_point_to_which_a_surface_narrows_part_its_sides() {
    let horn = NurbsSurface::torus(Frame::XY, 1.0, 1.0).unwrap();
    for n in 0..orientations() {
        let [a, b, ..] = fractions(n);
        let tilted = DVec3::new(0.6 * (a - 0.5), 0.6 * (b - 0.5), 1.0);
        for (surface, half) in [(&horn, TAU * PI), (&double_cone(), PI * SQRT_2)] {
            let map = place(n);
            let face = whole(surface.transformed(&map));
            let normal = map.transform_vector3(tilted);
            let plane =
                Frame::from_normal(map.transform_point3(DVec3::ZERO), normal, None).unwrap();
            for is_above in [false, true] {
                let parts = face.beside_plane(plane, is_above, TOLERANCE).unwrap();
                let area: f64 = parts.iter().map(|part| part.mass().unwrap().amount).sum();
                assert!((area - half).abs() < 1e-6, "{n}: {area} for {half}");
            }
            let parts = face.split(&[Cutter::Plane(plane)], TOLERANCE).unwrap();
            assert_eq!(parts.len(), 2, "{n}");
        }
    }
}

#[test]
fn no_solid_has_a_face_that_narrows_to_a_point() {
    let is_refused = |faces: &[Face]| {
        let found = Solid::capped(faces, TOLERANCE);
        matches!(found, Err(GeomError::Solid(SolidError::Pinched { face: 0, .. })))
    };
    let torus = |minor: f64| whole(NurbsSurface::torus(Frame::XY, 1.0, minor).unwrap());
    assert!(is_refused(&[torus(1.0)]));
    assert!(is_refused(&[torus(0.999_999_5)]));
    assert!(is_refused(&[whole(double_cone())]));
    assert!(Solid::capped(&[torus(0.99)], TOLERANCE).is_ok());
    // Smooth along the axis, and not at a knot.
    let waist = NurbsCurve::bezier(&[
        DVec3::new(1.0, 0.0, -1.0),
        DVec3::new(-0.5, 0.0, 0.2),
        DVec3::new(0.25, 0.0, 1.0),
    ]);
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    let hourglass = NurbsSurface::revolved(&waist.unwrap(), axis, TAU).unwrap();
    assert!(is_refused(&[whole(hourglass)]));
    // A band lower than the tolerance narrows nowhere.
    assert!(!is_refused(&[whole(NurbsSurface::cone(Frame::XY, [1.0; 2], 1e-7).unwrap())]));
}

#[test]
fn patches_that_overlap_run_together() {
    let patch = |corner: DVec3| {
        let [x, y] = [DVec3::X * 2.0, DVec3::Y * 2.0];
        NurbsSurface::bilinear(corner, corner + y, corner + x, corner + x + y).unwrap()
    };
    for n in 0..3 * orientations() {
        let map = place(n);
        let [one, other] =
            [DVec3::ZERO, DVec3::X + DVec3::Y].map(|corner| patch(corner).transformed(&map));
        let found = Surface::from(one).intersections(&Surface::from(other), TOLERANCE);
        let runs_together =
            matches!(found, Err(GeomError::Picture(PictureError::SurfacesRunTogether { .. })));
        assert!(runs_together, "{n}: {found:?}");
    }
}

/// The graph of a polynomial of both coordinates of degree 3, by its blossom's values.
fn graph(height: impl Fn(usize, usize) -> f64) -> NurbsSurface {
    let along = |i: usize| 2.0 / 3.0 * i as f64 - 1.0;
    let net = Grid::from_fn(4, 4, |i, j| DVec3::new(along(i), along(j), height(i, j)).extend(1.0));
    let knots = || KnotVector::bezier(3).unwrap();
    NurbsSurface::new(knots(), knots(), net).unwrap()
}

/// The Bézier points of x, x² and x³ over −1..1.
const POWERS: [[f64; 4]; 3] = [
    [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0],
    [1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0],
    [-1.0, 1.0, -1.0, 1.0],
];

#[test]
fn sections_through_flat_saddles_have_no_loops_in_their_middle() {
    let [one, two, three] = POWERS;
    let cases = [
        // z = x³ − y³ along a diagonal.
        (graph(|i, j| three[i] - three[j]), 2.0 * SQRT_2, 1),
        // z = x²·y along both axes.
        (graph(|i, j| two[i] * one[j]), 4.0, 4),
    ];
    for (surface, length, most) in cases {
        let found = surface.section(Frame::XY, TOLERANCE).unwrap();
        let lengths: Vec<f64> =
            found.curves.iter().map(|curve| curve.length(curve.domain())).collect();
        assert!((lengths.iter().sum::<f64>() - length).abs() < 1e-5, "{lengths:?} for {length}");
        assert!(lengths.len() <= most && lengths.iter().all(|length| 0.5 < *length), "{lengths:?}");
    }
}

#[test]
fn thin_rings_are_bounded_by_two_circles() {
    for height in [0.02, 0.05, 0.1, 0.3] {
        let radius = f64::sqrt(4.0 - 0.25 * height * height);
        let ball = NurbsSurface::sphere(Frame::XY, 2.0).unwrap();
        let base = Frame::XY.at(DVec3::new(0.0, 0.0, -3.0));
        let hole = NurbsSurface::cone(base, [radius; 2], 6.0).unwrap();
        for n in 0..3 {
            let map = place(n);
            let [ball, hole] = [&ball, &hole].map(|s| Surface::from(s.transformed(&map)));
            let found = ball.intersections(&hole, TOLERANCE).unwrap();
            assert_eq!((found.curves.len(), found.touches.len()), (2, 0), "{height}, {n}");
            for circle in found.curves {
                let length = circle.length(circle.domain());
                assert!((length - TAU * radius).abs() < 1e-6, "{height}, {n}: {length}");
            }
        }
    }
}
