//! Parts of surfaces: areas by closed forms, holes, seams, poles, what is refused.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    CircleForm, Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface, RegionSide, Tolerance,
    glam::DVec3,
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
