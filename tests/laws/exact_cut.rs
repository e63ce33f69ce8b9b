//! Planes cut planes, quadrics and the circles of tori exactly: lengths, areas and volumes by closed forms.

use std::{
    f64::consts::{PI, TAU},
    sync::Arc,
};

use virote_kernel::{
    ConicKind, Cutter, Face, FacePart, Frame, GeomError, KnotVector, NurbsCurve, NurbsSurface,
    Solid, SolidError, Surface, SurfaceCurve,
    glam::{DAffine3, DVec3},
};

use super::solid::{TOLERANCE, ball, polygon, region, whole};

/// As near as sums of some hundred numbers come to closed forms.
const EXACT: f64 = 1e-13;

fn plane(origin: DVec3, normal: DVec3) -> Frame {
    Frame::from_normal(origin, normal, None).expect("a plane")
}

fn section(surface: &NurbsSurface, plane: Frame) -> Vec<NurbsCurve> {
    surface.section(plane, TOLERANCE).expect("a section").curves
}

fn cone(radii: [f64; 2], height: f64) -> NurbsSurface {
    NurbsSurface::cone(Frame::XY, radii, height).expect("a cone")
}

fn length(curves: &[NurbsCurve]) -> f64 {
    curves.iter().map(|curve| curve.length(curve.domain())).sum()
}

#[track_caller]
fn assert_exact(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() <= EXACT, "{found} for {expected}");
}

/// Each is a conic of a kind, in the plane, and fulfils an equation.
#[track_caller]
fn check_conics(
    curves: &[NurbsCurve],
    kind: ConicKind,
    plane: Frame,
    equation: impl Fn(DVec3) -> f64,
) {
    assert!(!curves.is_empty());
    for curve in curves {
        assert_eq!(curve.conic_kind(), Ok(kind));
        for point in curve.sample(40) {
            assert!((point - plane.origin()).dot(plane.z()).abs() <= 1e-14, "{point}");
            assert!(equation(point).abs() <= 1e-13, "{point}");
        }
    }
}

#[test]
fn a_plane_cuts_a_sphere_in_an_exact_circle_wherever_it_is_turned() {
    let place = DVec3::new(0.5, -1.0, 2.0);
    let sphere = NurbsSurface::sphere(Frame::XY.at(place), 2.0).expect("a sphere");
    for i in 0..12 {
        let (sine, cosine) = on_circle(0.7 * f64::from(i));
        let normal = DVec3::new(cosine, sine, 0.3 * f64::from(i) - 1.5).normalize();
        let depth = 0.15 * f64::from(i);
        let curves = section(&sphere, plane(place + normal * depth, normal));
        assert_eq!(curves.len(), 1);
        assert!(curves[0].degree() == 2 && curves[0].control_points().len() == 9);
        assert_exact(length(&curves), TAU * (4.0 - depth * depth).sqrt());
    }
}

/// The part of a cylinder or cone around a sphere that is up to some heights away along an axis from its middle.
fn around(sphere: (DVec3, f64), axis: DVec3, slope: f64, heights: [f64; 2]) -> NurbsSurface {
    let (center, radius) = sphere;
    // The sphere touches the meridian where it comes next to the middle.
    let in_middle = radius * (1.0 + slope * slope).sqrt();
    let radii = heights.map(|height| in_middle + slope * height);
    let frame = Frame::from_normal(center + axis * heights[0], axis, None).expect("a frame");
    NurbsSurface::cone(frame, radii, heights[1] - heights[0]).expect("a cone")
}

#[test]
fn cylinders_and_cones_around_one_sphere_cross_in_exact_conics() {
    let center = DVec3::new(0.5, -1.0, 2.0);
    for (i, slope) in (0..12).zip([0.0, 0.2, -0.1].into_iter().cycle()) {
        let (sine, cosine) = on_circle(0.9 + 0.05 * f64::from(i));
        let (radius, x) = (1.5, DVec3::new(0.6, 0.8, 0.0));
        let axis = (DVec3::Z * cosine + x * sine).normalize();
        let sine = axis.cross(DVec3::Z).length();
        let tube = around((center, radius), DVec3::Z, 0.0, [-9.0, 9.0]);
        let other = around((center, radius), axis, slope, [-6.5, 6.5]);
        let [tube, other] = [tube, other].map(Arc::new);
        let both = [&tube, &other].map(|surface| Surface::Nurbs(Arc::clone(surface)));
        let found =
            both[0].intersections(&both[1], TOLERANCE).expect("two conics that cross twice");
        assert_eq!(found.curves.len(), 4);
        for curve in &found.curves {
            assert_eq!(curve.conic_kind(), Ok(ConicKind::Ellipse));
            for point in curve.sample(40).into_iter().map(|point| point - center) {
                let in_middle = radius * (1.0 + slope * slope).sqrt();
                let from_axis = |axis: DVec3| point.cross(axis).length();
                let off = from_axis(axis) - in_middle - slope * point.dot(axis);
                assert!((from_axis(DVec3::Z) - radius).abs() <= 1e-13, "{point}");
                assert!(off.abs() <= 1e-13, "{point}");
            }
        }
        let parts = whole((*tube).clone()).split(&[Cutter::Surface(other)], TOLERANCE);
        let mut areas: Vec<f64> =
            parts.expect("four parts").iter().map(|part| part.mass().unwrap().amount).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(areas.len(), 4);
        if slope == 0.0 {
            // Of two tubes in one another 8r²/sin is on each.
            assert!(((areas[0] + areas[1]) * sine / (8.0 * radius * radius) - 1.0).abs() <= 1e-12);
        }
    }
}

#[test]
fn conics_that_begin_on_a_seam_have_their_parameters_on_both_cylinders() {
    let tube = around((DVec3::ZERO, 1.0), DVec3::Z, 0.0, [-3.0, 3.0]);
    // Both have their seams through places in which the conics meet, or cross them, and none.
    for axis in [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.8, 0.0)] {
        let other = around((DVec3::ZERO, 1.0), axis, 0.0, [-3.0, 3.0]);
        let surfaces = [&tube, &other];
        let found = SurfaceCurve::all(surfaces, TOLERANCE).expect("four curves");
        assert_eq!(found.len(), 4);
        for curve in found {
            assert!(curve.deviation <= TOLERANCE.distance, "{}", curve.deviation);
            for (surface, on) in surfaces.iter().zip(&curve.on) {
                for t in curve.curve.domain().steps(40) {
                    let place = on.point_at(t);
                    let gap = surface.point_at(place.x, place.y).distance(curve.curve.point_at(t));
                    assert!(gap <= TOLERANCE.distance, "{gap}");
                }
            }
        }
    }
}

#[test]
fn cylinders_whose_axes_miss_one_another_cross_in_no_conics() {
    for miss in [1e-5, 1e-3] {
        let tube = around((DVec3::ZERO, 1.0), DVec3::Z, 0.0, [-3.0, 3.0]);
        let other = around((DVec3::Y * miss, 1.0), DVec3::X, 0.0, [-3.0, 3.0]);
        let both = [tube, other].map(Surface::from);
        let found = both[0].intersections(&both[1], TOLERANCE).expect("curves");
        assert!(found.curves.iter().all(|curve| curve.degree() == 3));
        for point in found.curves.iter().flat_map(|curve| curve.sample(40)) {
            assert!((point.truncate().length() - 1.0).abs() <= TOLERANCE.distance, "{point}");
            let from_other = libm::hypot(point.y - miss, point.z);
            assert!((from_other - 1.0).abs() <= TOLERANCE.distance, "{point}");
        }
    }
}

/// About the sine and the cosine of an angle, the same on each platform.
fn on_circle(angle: f64) -> (f64, f64) {
    let half = angle / 8.0;
    let (mut s, mut c) = (half - half * half * half / 6.0, 1.0 - half * half / 2.0);
    for _ in 0..3 {
        (s, c) = (2.0 * s * c, c * c - s * s);
    }
    (s, c)
}

#[test]
fn a_plane_cuts_cylinders_and_cones_in_each_kind_of_conic() {
    let tube = |p: DVec3| p.x * p.x + p.y * p.y - 1.0;
    let oblique = plane(DVec3::Z * 2.0, DVec3::new(0.5, 0.2, 1.0));
    check_conics(&section(&cone([1.0, 1.0], 4.0), oblique), ConicKind::Ellipse, oblique, tube);
    // One that leaves through the rim.
    let low = plane(DVec3::Z * 0.2, DVec3::new(0.5, 0.2, 1.0));
    check_conics(&section(&cone([1.0, 1.0], 4.0), low), ConicKind::Ellipse, low, tube);

    let pointed = cone([0.0, 1.0], 4.0);
    let sides = |p: DVec3| p.x * p.x + p.y * p.y - p.z * p.z / 16.0;
    let across = plane(DVec3::Z * 2.0, DVec3::new(0.5, 0.2, 1.0));
    check_conics(&section(&pointed, across), ConicKind::Ellipse, across, sides);
    let upright = plane(DVec3::X * 0.2, DVec3::X);
    check_conics(&section(&pointed, upright), ConicKind::Hyperbola, upright, sides);
}

#[test]
fn a_plane_along_the_axis_cuts_a_cylinder_in_lines() {
    let lines = section(&cone([1.0, 1.0], 4.0), plane(DVec3::X * 0.5, DVec3::X));
    assert_eq!(lines.len(), 2);
    assert!(lines.iter().all(|line| line.degree() == 1 && line.control_points().len() == 2));
    assert_exact(length(&lines), 8.0);
}

#[test]
fn the_circles_of_a_torus_are_exact() {
    let ring = NurbsSurface::torus(Frame::XY, 3.0, 1.0).expect("a torus");
    let flat = section(&ring, plane(DVec3::Z * 0.6, DVec3::Z));
    assert_eq!(flat.len(), 2);
    assert_exact(length(&flat), TAU * 6.0);
    let meridians = section(&ring, plane(DVec3::ZERO, DVec3::new(0.3, 1.0, 0.0)));
    assert_eq!(meridians.len(), 2);
    assert_exact(length(&meridians), TAU * 2.0);
    // Those of Villarceau meet where the plane touches, which is known within the tolerance.
    let circles = section(&ring, plane(DVec3::ZERO, DVec3::new(1.0, 0.0, 8.0_f64.sqrt())));
    assert!(circles.iter().all(|circle| circle.degree() == 2));
    assert!((length(&circles) - TAU * 6.0).abs() < 1e-5);
    // Others are no conics.
    let spiric = section(&ring, plane(DVec3::X * 2.5, DVec3::X));
    assert!(spiric.iter().all(|curve| curve.degree() == 3));
}

#[test]
fn what_is_not_quite_a_cylinder_is_cut_as_it_is() {
    let sheared = DAffine3::from_cols(DVec3::X, DVec3::Y * (1.0 + 1e-5), DVec3::Z, DVec3::ZERO);
    let tilted = plane(DVec3::Z * 2.0, DVec3::new(0.5, 0.2, 1.0));
    let curves = section(&cone([1.0, 1.0], 4.0).transformed(&sheared), tilted);
    for point in curves[0].sample(40) {
        let y = point.y / (1.0 + 1e-5);
        assert!((point.x * point.x + y * y - 1.0).abs() <= 4e-6, "{point}");
    }
}

#[test]
fn a_cut_ball_has_the_volume_and_the_area_of_its_cap() {
    let solid = Solid::new(&[ball(DVec3::ZERO, 2.0)], TOLERANCE).expect("a ball");
    for normal in [DVec3::Z, DVec3::X, DVec3::new(1.0, 2.0, 3.0).normalize()] {
        let depth = 0.3;
        let cap = solid.cut(plane(normal * depth, normal), true, TOLERANCE).expect("a cut");
        let cap = cap.expect("a cap");
        let height = 2.0 - depth;
        let volume = PI * height * height * (6.0 - height) / 3.0;
        assert_exact(cap.volume_mass().expect("a volume").amount, volume);
        let area = TAU * 2.0 * height + PI * (4.0 - depth * depth);
        assert_exact(cap.area_mass().expect("an area").amount, area);
        for face in cap.faces() {
            let edges = face.edges(TOLERANCE).expect("edges");
            assert!(edges.iter().all(|edge| edge.degree() == 2), "{edges:?}");
        }
    }
}

#[test]
fn a_cut_tube_has_the_volume_of_a_hoof() {
    // Half of the mean height over a disc, and a third of the cube of the radius for one through the middle of its floor.
    let tube = Solid::capped(&[whole(cone([1.0, 1.0], 4.0))], TOLERANCE).expect("a tube");
    let tilted = plane(DVec3::Z * 2.0, DVec3::new(0.5, 0.2, 1.0));
    let below = tube.cut(tilted, false, TOLERANCE).expect("a cut").expect("a part");
    assert_exact(below.volume_mass().expect("a volume").amount, TAU);
    let slanted = plane(DVec3::ZERO, DVec3::new(-1.0, 0.0, 1.0));
    let hoof = tube.cut(slanted, false, TOLERANCE).expect("a cut").expect("a hoof");
    assert_exact(hoof.volume_mass().expect("a volume").amount, 2.0 / 3.0);
}

#[test]
fn a_prism_is_cut_in_lines() {
    let corners: Vec<[f64; 3]> = (0..60)
        .map(|i| {
            let (sine, cosine) = on_circle(TAU * f64::from(i) / 60.0);
            [cosine, sine, 0.0]
        })
        .collect();
    let floor = region(&polygon(&corners), &[]);
    let prism = Solid::extruded(&floor, DVec3::Z, TOLERANCE).expect("a prism");
    let half = prism.cut(plane(DVec3::Z * 0.5, DVec3::Z), true, TOLERANCE).expect("a cut");
    let half = half.expect("a half");
    assert_exact(half.volume_mass().expect("a volume").amount, 0.5 * floor.area());
    for face in half.faces() {
        let edges = face.edges(TOLERANCE).expect("edges");
        assert!(edges.iter().all(|edge| edge.degree() == 1), "{edges:?}");
    }
}

/// An edge that is a parabola but for a dent in one of its spans is told with the dent.
#[test]
fn a_dent_in_an_edge_is_no_part_of_a_conic() {
    let [a, b, c, d] = [DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE];
    let patch = Arc::new(NurbsSurface::bilinear(a, b, c, d).expect("a patch"));
    let line = |from: DVec3, to: DVec3| NurbsCurve::line(from, to).expect("a side");
    let n = 34;
    for dent in 1..n - 1 {
        let knots = KnotVector::uniform_clamped(2, n, 1.0).expect("knots");
        let x = knots.greville();
        let mut places: Vec<DVec3> = x.iter().map(|&x| DVec3::new(x, 0.2 + 0.3 * x, 0.0)).collect();
        places[dent].y += 0.05;
        let path = NurbsCurve::polynomial(knots, &places).expect("a path");
        let (start, end) = (places[0], places[n - 1]);
        let border =
            vec![line(DVec3::ZERO, c), line(c, end), path.reversed(), line(start, DVec3::ZERO)];
        let parts = [FacePart { loops: vec![border] }];
        let face = Face::of_parts(Arc::clone(&patch), &parts, TOLERANCE).expect("a face");
        let edges = face.edges(TOLERANCE).expect("edges");
        for k in 0..=200 {
            let place = path.point_at(f64::from(k) / 200.0);
            let point = patch.point_at(place.x, place.y);
            let near = edges.iter().map(|edge| edge.closest(point, 1e-6).distance);
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near < 1e-6, "dent {dent}: {near} from {place}");
        }
    }
}

/// A plane that comes down to the rim of a hole at a small angle: its arcs end on the rim, and not a tolerance beside it.
#[test]
fn a_plate_with_a_hole_is_cut_by_planes_that_hardly_slope() {
    let outer = polygon(&[[-5.0, -4.0, 0.0], [5.0, -4.0, 0.0], [5.0, 4.0, 0.0], [-5.0, 4.0, 0.0]]);
    for x in [0.0, 0.7, 3.4] {
        let rim = NurbsCurve::ellipse(
            Frame::XY.at(DVec3::X * x),
            [1.5; 2],
            virote_kernel::CircleForm::NinePoint,
        );
        let plate = region(&outer, &[rim.expect("a circle")]);
        let plate = Solid::extruded(&plate, DVec3::Z * 2.0, TOLERANCE).expect("a plate");
        let volume = 2.0 * (80.0 - 2.25 * PI);
        for slope in [0.01, 0.05, 0.3] {
            let plane = plane(DVec3::Z * 1.99, DVec3::new(slope, 0.0, 1.0));
            let side = |is_above: bool| {
                let side = plate.cut(plane, is_above, TOLERANCE).expect("a cut").expect("a side");
                side.volume_mass().expect("a volume").amount
            };
            assert_exact(side(true) + side(false), volume);
        }
    }
}

/// The inner tangent plane of a torus cuts it in an eight: beyond it the body is whole, before it two wedges touch.
#[test]
fn the_side_of_a_torus_that_its_tangent_plane_leaves_touching_itself_is_refused() {
    let torus = NurbsSurface::torus(Frame::XY, 3.0, 1.0).expect("a torus");
    let torus = Solid::new(&[whole(torus)], TOLERANCE).expect("a solid");
    let plane = plane(DVec3::X * 2.0, DVec3::X);
    let beyond = torus.cut(plane, true, TOLERANCE).expect("a cut").expect("a side");
    assert!((beyond.volume_mass().expect("a volume").amount - 15.576_944_636_37).abs() < 1e-7);
    match torus.cut(plane, false, TOLERANCE) {
        Err(GeomError::Solid(SolidError::TouchesPlane { point })) => {
            assert!(point.distance(DVec3::X * 2.0) < 1e-4, "{point}");
        }
        other => unreachable!("{other:?}"),
    }
}

/// Where a plane touches a surface and crosses it about the place, the curves end in one place, that of contact.
#[test]
fn curves_that_cross_where_a_plane_touches_end_where_it_does() {
    let torus = NurbsSurface::torus(Frame::XY, 3.0, 1.0).expect("a torus");
    // All about the hole, first where it is narrowest.
    for k in 0..96 {
        let up = if k < 24 { 0.0 } else { 0.3 * f64::from(k % 8) - 1.1 };
        let ((sine, cosine), (high, inward)) = (libm::sincos(0.3 + f64::from(k)), libm::sincos(up));
        let normal = DVec3::new(-inward * cosine, -inward * sine, high);
        let place = 3.0 * DVec3::new(cosine, sine, 0.0) + normal;
        let curves = section(&torus, plane(place, normal));
        assert_eq!(curves.len(), 2, "{place}");
        let first = curves[0].start();
        assert!(first.distance(place) <= 1e-14, "{first} for {place}");
        for end in curves.iter().flat_map(|curve| [curve.start(), curve.end()]) {
            assert_eq!(end, first, "{place}");
        }
    }
}

/// Where surfaces tell the plane of what they share, `intersections` answers with the conic of that plane.
#[test]
fn surfaces_that_cross_in_a_plane_cross_in_conics() {
    let sphere = |x: f64, radius: f64| {
        Surface::from(NurbsSurface::sphere(Frame::XY.at(DVec3::X * x), radius).expect("a sphere"))
    };
    let [o, x, y] = [DVec3::new(-3.0, -3.0, 0.6), DVec3::X * 6.0, DVec3::Y * 6.0];
    let patch = Surface::from(NurbsSurface::bilinear(o, o + y, o + x, o + x + y).expect("a patch"));
    let curves = |a: &Surface, b: &Surface| a.intersections(b, TOLERANCE).expect("curves").curves;
    for curves in [curves(&patch, &sphere(0.0, 1.0)), curves(&sphere(0.0, 1.0), &patch)] {
        let equation = |point: DVec3| point.length_squared() - 1.0;
        check_conics(&curves, ConicKind::Ellipse, Frame::XY.at(DVec3::Z * 0.6), equation);
        assert_exact(length(&curves), TAU * 0.8);
    }
    // At x = (d² + r² − R²) / 2d with the radius √(r² − x²).
    for (d, radius) in [(1.5, 1.0), (1.2, 0.7), (0.6, 1.1)] {
        let found = curves(&sphere(0.0, 1.0), &sphere(d, radius));
        let at = (d * d + 1.0 - radius * radius) / (2.0 * d);
        let place = plane(DVec3::X * at, DVec3::X);
        check_conics(&found, ConicKind::Ellipse, place, |point| point.length_squared() - 1.0);
        assert_exact(length(&found), TAU * (1.0 - at * at).sqrt());
    }
}
