//! Parts of surfaces: areas by closed forms, holes, seams, poles, what is refused.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    CircleForm, Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface, RegionSide,
    TessellationOptions, Tolerance, glam::DVec3,
};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn square(side: f64) -> Arc<NurbsSurface> {
    let (o, x, y) = (DVec3::ZERO, DVec3::X * side, DVec3::Y * side);
    Arc::new(NurbsSurface::bilinear(o, y, x, x + y).expect("a square"))
}

/// A circle in the plane of parameters, counter-clockwise.
fn circle(center: [f64; 2], radius: f64) -> NurbsCurve {
    let frame = Frame::XY.at(DVec3::new(center[0], center[1], 0.0));
    NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).expect("a circle")
}

fn rectangle(u: [f64; 2], v: [f64; 2]) -> NurbsCurve {
    let corner = |i: usize, k: usize| DVec3::new(u[i], v[k], 0.0);
    let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), corner(0, 0)];
    NurbsCurve::polyline(&corners).expect("a rectangle")
}

#[track_caller]
fn check_area(face: &Face, area: f64) {
    let found = face.mass().expect("a face has an area").amount;
    assert!((found / area - 1.0).abs() < 1e-12, "{found} for {area}");
}

#[test]
fn a_hole_takes_its_area_away() {
    let hole = circle([0.5, 0.5], 0.25).reversed();
    let face = Face::within(square(4.0), &[hole], TOLERANCE).expect("a face");
    check_area(&face, 16.0 - PI);
    let disc = Face::within(square(4.0), &[circle([0.5, 0.5], 0.25)], TOLERANCE).expect("a face");
    check_area(&disc, PI);
    assert!(disc.mass().expect("mass").centroid.distance(DVec3::new(2.0, 2.0, 0.0)) < 1e-12);
}

#[test]
fn a_rectangle_of_parameters_of_a_sphere_has_the_area_of_archimedes() {
    let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0).expect("a sphere"));
    let whole = Face::whole(Arc::clone(&sphere), TOLERANCE).expect("a face");
    check_area(&whole, 16.0 * PI);
    let [u, v] = [sphere.domain_u(), sphere.domain_v()];
    for (low, high) in [(0.1, 0.7), (0.0, 0.3), (0.55, 1.0)] {
        let loops = rectangle([u.at(0.13), u.at(0.83)], [v.at(low), v.at(high)]);
        let face = Face::within(Arc::clone(&sphere), &[loops], TOLERANCE).expect("a face");
        let heights = [low, high].map(|at| sphere.point_at(u.start(), v.at(at)).z);
        let angle = |at: f64| {
            let p = sphere.point_at(u.at(at), v.at(0.5));
            libm::atan2(p.y, p.x).rem_euclid(2.0 * PI)
        };
        let turn = angle(0.83) - angle(0.13);
        check_area(&face, 2.0 * turn * (heights[1] - heights[0]));
    }
}

#[test]
fn a_mesh_of_a_face_keeps_to_its_tolerance_and_has_its_area() {
    let torus = Arc::new(NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap());
    let [u, v] = [torus.domain_u(), torus.domain_v()];
    let window = circle([u.at(0.4), v.at(0.6)], 0.17 * u.length().min(v.length()));
    for loops in [vec![window.clone()], vec![window.reversed()]] {
        let face = Face::within(Arc::clone(&torus), &loops, TOLERANCE).unwrap();
        let area = face.mass().unwrap().amount;
        for tolerance in [1e-2, 1e-3, 1e-4] {
            let options = TessellationOptions::within(tolerance);
            let mesh = face.mesh(&options, 1_000_000).unwrap();
            let check = mesh.check(TOLERANCE);
            assert!(check.is_manifold && check.is_oriented && check.boundaries == 1, "{check:?}");
            assert_eq!(check.degenerate, 0);
            assert!((mesh.area() / area - 1.0).abs() < 3.0 * tolerance, "{} {area}", mesh.area());
            for [a, b, c] in mesh.corners() {
                let middle = (a + b + c) / 3.0;
                assert!(torus.closest(middle).distance <= tolerance);
            }
        }
    }
}

#[test]
fn what_bounds_no_part_is_refused() {
    let refused = |loops: &[NurbsCurve]| match Face::within(square(4.0), loops, TOLERANCE) {
        Err(GeomError::Face(error)) => error,
        other => panic!("{other:?}"),
    };
    let line = NurbsCurve::line(DVec3::new(0.2, 0.2, 0.0), DVec3::new(0.8, 0.2, 0.0)).unwrap();
    assert!(matches!(refused(&[line]), FaceError::Open { index: 0, .. }));
    let beyond = circle([0.9, 0.5], 0.25);
    assert!(matches!(refused(&[beyond]), FaceError::OffDomain { index: 0, .. }));
    let [one, other] = [[0.25, 0.5], [0.75, 0.5]].map(|center| circle(center, 0.125));
    assert!(matches!(refused(&[one.clone(), other]), FaceError::Apart { n_parts: 2, .. }));
    // Both are outer ones: between them one has it to its left, the other to its right.
    let inner = circle([0.25, 0.5], 0.0625);
    assert!(matches!(refused(&[one.clone(), inner]), FaceError::BothSides { .. }));
    assert!(matches!(refused(&[one.clone(), one.reversed()]), FaceError::BothSides { .. }));
}

#[test]
fn places_are_inside_on_the_border_or_outside_also_at_seams() {
    let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0).unwrap());
    let [u, v] = [sphere.domain_u(), sphere.domain_v()];
    let window = circle([u.at(0.5), v.at(0.5)], 0.2 * u.length().min(v.length()));
    let face = Face::within(Arc::clone(&sphere), &[window.reversed()], TOLERANCE).unwrap();
    let side = |u: f64, v: f64| face.side_of_parameters([u, v], 1e-6);
    assert_eq!(side(u.at(0.5), v.at(0.5)), RegionSide::Outside);
    assert_eq!(side(window.start().x, window.start().y), RegionSide::Border);
    assert_eq!(side(u.start(), v.at(0.5)), RegionSide::Inside);
    assert_eq!(side(u.end(), v.at(0.3)), RegionSide::Inside);
    assert_eq!(side(u.end() + 1.0, v.at(0.3)), RegionSide::Outside);
}
