//! Parts of surfaces: areas by closed forms, holes, seams, poles, what is refused.

use std::{
    f64::consts::{PI, TAU},
    sync::Arc,
};

use virote_kernel::{
    Bounds, CircleForm, Cutter, Direction, Face, FaceError, Frame, GeomError, Grid, Interval,
    KnotVector, NurbsCurve, NurbsSurface, Region, RegionSide, TessellationOptions, Tolerance,
    glam::{DAffine3, DVec3},
    work,
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
    check_area_within(face, area, 1e-12);
}

#[track_caller]
fn check_area_within(face: &Face, area: f64, relative: f64) {
    let found = face.mass().unwrap().amount;
    assert!((found / area - 1.0).abs() < relative, "{found} for {area}");
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
                let from_circle = libm::hypot(libm::hypot(middle.x, middle.y) - 3.0, middle.z);
                assert!((from_circle - 1.0).abs() <= tolerance);
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

fn whole(surface: NurbsSurface) -> Face {
    Face::whole(Arc::new(surface), TOLERANCE).unwrap()
}

fn areas(parts: &[Face]) -> Vec<f64> {
    let mut areas: Vec<f64> = parts.iter().map(|part| part.mass().unwrap().amount).collect();
    areas.sort_by(f64::total_cmp);
    areas
}

#[test]
fn a_plane_divides_a_sphere_as_archimedes_says_however_it_lies() {
    let directions = [DVec3::Z, DVec3::X, DVec3::new(1.0, 2.0, -0.5), DVec3::new(0.3, -0.1, 1.0)];
    for normal in directions {
        for height in [0.0, 0.3, -1.2] {
            let origin = normal.normalize() * height;
            let plane = Frame::from_normal(origin, normal, None).unwrap();
            let sphere = whole(NurbsSurface::sphere(Frame::XY, 2.0).unwrap());
            let parts = sphere.split(&[Cutter::Plane(plane)], TOLERANCE).unwrap();
            let small = 4.0 * PI * (2.0 - f64::abs(height));
            let found = areas(&parts);
            assert_eq!(found.len(), 2, "{normal} {height}");
            let errors = [found[0] - small, found[1] - (16.0 * PI - small)];
            assert!(errors.iter().all(|error| error.abs() < 1e-9), "{normal} {height}: {errors:?}");
            let above = areas(&sphere.beside_plane(plane, true, TOLERANCE).unwrap());
            let cap = 4.0 * PI * (2.0 - height);
            assert!(
                above.len() == 1 && (above[0] - cap).abs() < 1e-9,
                "{normal} {height}: {above:?}"
            );
        }
    }
}

#[test]
fn a_cylinder_cut_by_another_leaves_the_caps_of_steinmetz() {
    // Of a cylinder of radius 1 another one of the same radius across it holds two pieces of area 4;
    // outside of it lies what its own ends leave.
    let cylinder = |frame: Frame| {
        let circle =
            NurbsCurve::ellipse(frame.at(frame.z() * -2.0), [1.0; 2], CircleForm::NinePoint);
        NurbsSurface::extruded(&circle.unwrap(), frame.z() * 4.0).unwrap()
    };
    let other = Arc::new(cylinder(Frame::YZ));
    let parts = whole(cylinder(Frame::XY)).split(&[Cutter::Surface(other)], TOLERANCE).unwrap();
    let found = areas(&parts);
    assert_eq!(found.len(), 4, "{found:?}");
    // Within the other cylinder lies the area 8, in two pieces.
    let whole = 8.0 * PI;
    assert!((found.iter().sum::<f64>() - whole).abs() < 1e-9);
    assert!((found[0] - 4.0).abs() < 1e-9 && (found[1] - 4.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn a_part_is_told_by_a_point_and_a_side_of_a_plane_by_its_normal() {
    let plane = Frame::XY.at(DVec3::Z * 0.5);
    let sphere = whole(NurbsSurface::sphere(Frame::XY, 1.0).unwrap());
    let cap = sphere.part_at(&[Cutter::Plane(plane)], DVec3::Z, TOLERANCE).unwrap();
    check_area(&cap, PI);
    let above = sphere.beside_plane(plane, true, TOLERANCE).unwrap();
    assert_eq!(areas(&above).len(), 1);
    assert!((areas(&above)[0] - PI).abs() < 1e-11);
    let refused = |point: DVec3| match sphere.part_at(&[Cutter::Plane(plane)], point, TOLERANCE) {
        Err(GeomError::Face(error)) => error,
        other => panic!("{other:?}"),
    };
    assert!(matches!(refused(DVec3::Z * 2.0), FaceError::NoPartAt { .. }));
    assert!(matches!(refused(DVec3::new(0.75_f64.sqrt(), 0.0, 0.5)), FaceError::OnCut { .. }));
}

#[test]
fn cutters_that_divide_nothing_are_refused_with_the_place() {
    let square = Face::whole(square(4.0), TOLERANCE).unwrap();
    let split = |cutter: Cutter| match square.split(&[cutter], TOLERANCE) {
        Err(GeomError::Face(error)) => error,
        other => panic!("{other:?}"),
    };
    let line = |a: [f64; 2], b: [f64; 2]| {
        let at = |[x, y]: [f64; 2]| DVec3::new(x, y, 0.0);
        Cutter::Curve(NurbsCurve::line(at(a), at(b)).unwrap())
    };
    assert!(matches!(split(line([1.0, 1.0], [3.0, 1.0])), FaceError::EndsInside { .. }));
    let plane = |height: f64| Cutter::Plane(Frame::XY.at(DVec3::Z * height));
    assert!(matches!(split(plane(1.0)), FaceError::Misses { index: 0 }));
    let lifted = NurbsCurve::line(DVec3::new(0.0, 1.0, 0.1), DVec3::new(4.0, 1.0, 0.1)).unwrap();
    assert!(matches!(split(Cutter::Curve(lifted)), FaceError::OffSurface { .. }));
    // Over the border and past one another they divide.
    let both = [line([0.0, 1.0], [4.0, 1.0]), line([1.0, 0.0], [1.0, 4.0])];
    let parts = square.split(&both, TOLERANCE).unwrap();
    let found = areas(&parts);
    assert_eq!(found.len(), 4);
    assert!(found.iter().zip([1.0, 3.0, 3.0, 9.0]).all(|(a, b)| (a - b).abs() < 1e-12));
}

#[test]
fn a_loop_in_space_goes_over_seams() {
    // The circle about the x axis on a sphere whose seam runs through x.
    let sphere = Arc::new(NurbsSurface::sphere(Frame::XY, 1.0).unwrap());
    for axis in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 0.1, 0.3)] {
        let axis = axis.normalize();
        let frame = Frame::from_normal(axis * 0.8, axis, None).unwrap();
        let circle = NurbsCurve::ellipse(frame, [0.6; 2], CircleForm::NinePoint).unwrap();
        let cap =
            Face::bounded(Arc::clone(&sphere), std::slice::from_ref(&circle), TOLERANCE).unwrap();
        check_area_within(&cap, 0.4 * PI, 1e-10);
        let rest = Face::bounded(Arc::clone(&sphere), &[circle.reversed()], TOLERANCE).unwrap();
        check_area_within(&rest, 3.6 * PI, 1e-10);
        for face in [cap, rest] {
            let mesh = face.mesh(&TessellationOptions::within(1e-3), 100_000).unwrap();
            let check = mesh.check(TOLERANCE);
            assert!(check.is_manifold && check.is_oriented && check.boundaries == 1, "{check:?}");
            assert_eq!(check.euler, 1);
        }
    }
}

#[test]
fn the_rim_of_a_sphere_cut_where_its_knots_are_hardly_apart_is_one_circle() {
    let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    let sphere = Face::whole(Arc::new(sphere), Tolerance::DEFAULT).unwrap();
    for height in [0.5, -0.5, 0.25] {
        let plane = Frame::from_normal(DVec3::Y * height, DVec3::NEG_Y, None).unwrap();
        for part in sphere.beside_plane(plane, true, Tolerance::DEFAULT).unwrap() {
            let edges = part.edges(Tolerance::DEFAULT).unwrap();
            let lengths = edges.iter().map(|edge| edge.length(edge.domain()));
            let expected = TAU * (1.0 - height * height).sqrt();
            assert!((lengths.sum::<f64>() - expected).abs() < 1e-6);
        }
    }
}

/// The edges of what is cut from surfaces of degree 1 have corners, beside which their pieces are as narrow as parameters
/// are rounded.
#[test]
fn faces_cut_from_surfaces_of_degree_one_have_bounds() {
    let row = |x: f64, heights: [f64; 2]| {
        [0.0, 1.0].map(|y| DVec3::new(x, y, heights[y as usize])).to_vec()
    };
    let rows = vec![row(0.0, [0.0, 0.5]), row(1.0, [0.0, 2.0]), row(2.0, [-1.0, 0.0])];
    let knots = [3, 2].map(|n| KnotVector::uniform_clamped(1, n, 1.0).unwrap());
    let [by_u, by_v] = knots;
    let surface = NurbsSurface::polynomial(by_u, by_v, &Grid::from_rows(rows).unwrap()).unwrap();
    let whole = surface.bounds();
    let face = Face::whole(Arc::new(surface), TOLERANCE).unwrap();
    let mut n_parts = 0;
    for x in [1.5, 1.2, 0.7] {
        let plane = Frame::from_normal(DVec3::new(x, 0.9, 0.0), DVec3::ONE, None).unwrap();
        for keeps_above in [true, false] {
            for part in face.beside_plane(plane, keeps_above, TOLERANCE).unwrap() {
                let bounds = part.bounds(TOLERANCE).unwrap();
                assert!(whole.min.distance(whole.max) >= bounds.min.distance(bounds.max));
                n_parts += 1;
            }
        }
    }
    assert!(6 <= n_parts);
}

/// Parameters of stations and years have fewer digits behind the point than those from 0 to 1.
#[test]
fn parts_of_a_surface_are_the_same_wherever_its_parameters_lie() {
    let height = |i: f64, k: f64| libm::sin(2.0 * i) * libm::cos(k);
    let row = |i: u8| {
        let point = |k: u8| {
            let (i, k) = (f64::from(i), f64::from(k));
            DVec3::new(2.0 * i, 2.0 * k, height(i, k))
        };
        (0..=5).map(point).collect::<Vec<_>>()
    };
    let rows = (0..=5).map(row).collect();
    let knots = [0, 1].map(|_| KnotVector::uniform_clamped(3, 6, 1.0).unwrap());
    let [by_u, by_v] = knots;
    let surface = NurbsSurface::polynomial(by_u, by_v, &Grid::from_rows(rows).unwrap()).unwrap();
    let plane = Frame::XY.at(DVec3::Z * 0.1);
    let split = |surface: NurbsSurface| {
        let parts = whole(surface).split(&[Cutter::Plane(plane)], TOLERANCE).unwrap();
        let before = work::counted();
        let boxes: Vec<Bounds> = parts.iter().map(|part| part.bounds(TOLERANCE).unwrap()).collect();
        (areas(&parts), boxes, work::counted() - before)
    };
    let (areas, boxes, steps) = split(surface.clone());
    assert_eq!(areas.len(), 7);
    for start in [200.0, -2e4] {
        let domain = Interval::new(start, start + 1.0).unwrap();
        let (found, found_boxes, found_steps) = split(surface.reparametrized(Direction::U, domain));
        assert_eq!(found.len(), 7, "{start}");
        for (found, expected) in found.iter().zip(&areas) {
            // A tolerance along the borders.
            assert!((found - expected).abs() < 1e-5, "{start}: {found} for {expected}");
        }
        for (found, expected) in found_boxes.iter().zip(&boxes) {
            let off = (found.min - expected.min).abs().max((found.max - expected.max).abs());
            assert!(off.max_element() < 2.0 * TOLERANCE.distance, "{start}: {off}");
        }
        assert!(found_steps < 25 * steps, "{start}: {found_steps} steps, {steps} from 0 to 1");
    }
}

#[test]
fn what_is_nearest_is_found_at_once_where_all_of_the_surface_is_nearly_equally_far() {
    let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1e3).unwrap()), TOLERANCE);
    let upper =
        sphere.unwrap().part_at(&[Cutter::Plane(Frame::XY)], DVec3::Z * 1e3, TOLERANCE).unwrap();
    let before = work::counted();
    for exponent in -9..3 {
        let off = libm::pow(10.0, f64::from(exponent));
        for (x, z) in [(0.0, -off), (-off, -off), (-off, off)] {
            let found = upper.closest(DVec3::new(x, 0.0, z), TOLERANCE).unwrap();
            let least = match z < 0.0 {
                true => libm::hypot(1e3 + x, z),
                false => 1e3 - libm::hypot(x, z),
            };
            assert!((found.distance - least).abs() < 1e-9, "{x}, {z}: {} {least}", found.distance);
        }
    }
    assert!(work::counted() - before < 1_000_000, "{}", work::counted() - before);
}

#[test]
fn what_is_nearest_of_a_cap_is_found_at_once_from_beside_its_rim() {
    let upright = circle([0.0; 2], 999.9);
    let turn = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.65);
    let cap = Region::new(&upright, &[], TOLERANCE).unwrap();
    let cap = Face::of_region(&cap, TOLERANCE).unwrap().transformed(&turn).unwrap();
    let before = work::counted();
    for angle in 0..2 {
        let angle = 0.1 + 2.5 * f64::from(angle);
        let place = |radius: f64, z: f64| {
            turn.transform_point3(DVec3::new(
                radius * libm::cos(angle),
                radius * libm::sin(angle),
                z,
            ))
        };
        for off in [1e-7, 1e-4, 0.1, 10.0] {
            for z in [-80.0, 1e-3, 1e3] {
                let found = cap.closest(place(999.9 + off, z), TOLERANCE).unwrap();
                assert!((found.distance - libm::hypot(off, z)).abs() < 1e-9, "{angle}, {off}, {z}");
                let found = cap.closest(place(999.9 - off, z), TOLERANCE).unwrap();
                assert!((found.distance - z.abs()).abs() < 1e-9, "{angle}, {off}, {z}");
            }
        }
    }
    assert!(work::counted() - before < 1_000_000, "{}", work::counted() - before);
}

/// Inside of a face what is nearest or reaches farthest is smooth, but for tips and for seams with a crease.
#[test]
fn tips_and_creased_seams_are_nearest_and_reach_farthest() {
    let cone = whole(NurbsSurface::cone(Frame::XY, [2.0, 0.0], 4.0).unwrap());
    let plane = Frame::XY.at(DVec3::Z * 2.0);
    let upper = &cone.beside_plane(plane, true, TOLERANCE).unwrap()[0];
    let bounds = upper.bounds(TOLERANCE).unwrap();
    assert!((bounds.max.z - 4.0).abs() < 1e-9 && (bounds.min.z - 2.0).abs() < 1e-9, "{bounds:?}");
    for (x, z) in [(0.0, 5.0), (0.1, 5.0), (-0.2, 4.5), (0.0, 7.0)] {
        let found = upper.closest(DVec3::new(x, 0.0, z), TOLERANCE).unwrap().distance;
        assert!((found - libm::hypot(x, z - 4.0)).abs() < 1e-9, "{x}, {z}: {found}");
    }
    // The outline of a leaf, whose tips lie on the seam and opposite to it.
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0]).unwrap();
    let outline = [at(2.0, 0.0), at(0.0, 1.5), at(-2.0, 0.0), at(0.0, -1.5), at(2.0, 0.0)];
    let leaf = NurbsCurve::polynomial(knots, &outline).unwrap();
    let wall = whole(NurbsSurface::extruded(&leaf, DVec3::Z * 4.0).unwrap());
    let plane = Frame::from_normal(DVec3::Z * 2.0, DVec3::X, None).unwrap();
    let half = &wall.beside_plane(plane, true, TOLERANCE).unwrap()[0];
    for (y, z) in [(0.0, 2.0), (0.2, 1.0), (-0.1, 3.5)] {
        let found = half.closest(DVec3::new(3.0, y, z), TOLERANCE).unwrap().distance;
        assert!((found - libm::hypot(1.0, y)).abs() < 1e-9, "{y}, {z}: {found}");
    }
}

/// A roof of three slopes, of which a part is left out.
#[test]
fn a_ridge_of_a_face_is_nearest_where_no_slope_is() {
    let at = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    let knots = KnotVector::new(1, vec![0.0, 0.0, 2.0, 3.0, 4.0, 4.0]).unwrap();
    let profile = [at(-2.0, 0.0), at(0.0, 1.0), at(1.0, 0.0), at(2.0, 1.5)];
    let profile = NurbsCurve::polynomial(knots, &profile).unwrap();
    let roof = whole(NurbsSurface::extruded(&profile, DVec3::Y * 10.0).unwrap());
    let plane = Frame::from_normal(DVec3::X * 1.5, DVec3::X, None).unwrap();
    let face = &roof.beside_plane(plane, false, TOLERANCE).unwrap()[0];
    for (x, z) in [(1.0, 3.0), (0.8, 3.0), (0.9, 3.0), (0.0, 2.0)] {
        let found = face.closest(DVec3::new(x, 5.0, z), TOLERANCE).unwrap().distance;
        assert!((found - libm::hypot(x, z - 1.0)).abs() < 1e-9, "{x}, {z}: {found}");
    }
    assert!((face.bounds(TOLERANCE).unwrap().max.z - 1.0).abs() < 1e-9);
}

/// Beside the border of a bent face what is nearest is on the border.
#[test]
fn what_is_nearest_beside_a_slanted_border_is_found_at_once() {
    let torus = Arc::new(NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap());
    let disc = Face::within(Arc::clone(&torus), &[circle([0.5, 0.5], 0.3)], TOLERANCE).unwrap();
    let before = work::counted();
    for (u, v) in [(0.55, 0.15), (0.2, 0.3), (0.75, 0.75), (0.4, 0.9)] {
        let found = disc.closest(torus.point_at(u, v), TOLERANCE).unwrap();
        let border = disc.edges(TOLERANCE).unwrap();
        let beside = border.iter().map(|edge| edge.closest(torus.point_at(u, v), 1e-9).distance);
        let least = beside.fold(f64::INFINITY, f64::min);
        assert!((found.distance - least).abs() < 1e-6, "{u}, {v}: {} {least}", found.distance);
    }
    assert!(work::counted() - before < 100_000, "{}", work::counted() - before);
}
