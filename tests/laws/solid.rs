//! Solids: volumes by closed forms, meshes that close, shells in one another, what is refused.

use std::{
    f64::consts::{FRAC_PI_2, PI, TAU},
    sync::Arc,
};

use virote_kernel::{
    Axis, CircleForm, Curve, Cutter, Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface,
    Region, RegionSide, Solid, SolidError, TessellationOptions, Tolerance,
    glam::{DAffine3, DMat3, DVec3},
};

pub(super) const TOLERANCE: Tolerance = Tolerance::DEFAULT;

pub(super) fn circle(frame: Frame, radius: f64) -> NurbsCurve {
    NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).expect("a circle")
}

pub(super) fn polygon(corners: &[[f64; 3]]) -> NurbsCurve {
    let mut corners: Vec<DVec3> = corners.iter().map(|&corner| DVec3::from(corner)).collect();
    corners.push(corners[0]);
    NurbsCurve::polyline(&corners).expect("a polygon")
}

pub(super) fn region(outer: &NurbsCurve, holes: &[NurbsCurve]) -> Region {
    Region::new(outer, holes, TOLERANCE).expect("a region")
}

/// A plate with n × n holes.
pub(super) fn sieve(n: usize) -> Region {
    let side = n as f64;
    let hole = |i: usize| {
        let center = DVec3::new((i % n) as f64 + 0.5, (i / n) as f64 + 0.5, 0.0);
        circle(Frame::XY.at(center), 0.3)
    };
    let outer = polygon(&[[0.0; 3], [side, 0.0, 0.0], [side, side, 0.0], [0.0, side, 0.0]]);
    region(&outer, &(0..n * n).map(hole).collect::<Vec<_>>())
}

fn axis() -> Axis {
    Axis::new(DVec3::ZERO, DVec3::Z).expect("an axis")
}

pub(super) fn whole(surface: NurbsSurface) -> Face {
    Face::whole(Arc::new(surface), TOLERANCE).expect("a face")
}

pub(super) fn ball(center: DVec3, radius: f64) -> Face {
    whole(NurbsSurface::sphere(Frame::XY.at(center), radius).expect("a sphere"))
}

/// Its volume, and a closed mesh within a thousandth of its size with V − E + F.
#[track_caller]
pub(super) fn check(solid: &Solid, volume: f64, euler: i64) {
    let found = solid.volume_mass().expect("a volume").amount;
    assert!((found / volume - 1.0).abs() < 1e-9, "{found} for {volume}");
    let bounds = solid.bounds(TOLERANCE).expect("a box");
    let options = TessellationOptions::within(1e-3 * bounds.diagonal());
    let mesh = solid.mesh(&options, 1_000_000).expect("a mesh");
    let check = mesh.check(TOLERANCE);
    assert!(check.is_closed && check.is_manifold && check.is_oriented, "{check:?}");
    assert_eq!((check.euler, check.degenerate), (euler, 0), "{check:?}");
    let area = solid.area_mass().expect("an area").amount;
    let of_mesh = mesh.volume();
    assert!((of_mesh - volume).abs() <= 1.1 * options.tolerance * area, "{of_mesh} for {volume}");
}

#[test]
fn a_prism_is_its_area_times_its_height() {
    let lshape = [
        [0.0; 3],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 3.0, 0.0],
        [0.0, 3.0, 0.0],
    ];
    for vector in
        [DVec3::new(0.0, 0.0, 2.0), DVec3::new(0.5, -1.0, 2.0), DVec3::new(0.0, 0.0, -2.0)]
    {
        let prism = Solid::extruded(&region(&polygon(&lshape), &[]), vector, TOLERANCE);
        let prism = prism.expect("a prism");
        assert_eq!(prism.faces().len(), 8);
        check(&prism, 8.0, 2);
    }
}

#[test]
fn each_hole_of_an_extruded_plate_is_a_handle() {
    let plate = Solid::extruded(&sieve(4), DVec3::Z * 0.5, TOLERANCE).expect("a plate");
    check(&plate, 0.5 * (16.0 - 16.0 * PI * 0.09), 2 - 2 * 16);
}

#[test]
fn turned_regions_follow_pappus() {
    let section = region(
        &circle(Frame::ZX.at(DVec3::X * 3.0), 1.0),
        &[circle(Frame::ZX.at(DVec3::X * 3.2), 0.5)],
    );
    // The moment of the ring about the axis, by those of both discs.
    let moment = PI * (3.0 - 0.25 * 3.2);
    for (angle, euler) in [(TAU, 0), (-TAU, 0), (1.0, 0), (-4.0, 0)] {
        let turned = Solid::revolved(&section, axis(), angle, TOLERANCE).expect("a solid");
        check(&turned, angle.abs() * moment, euler);
        let n_shells = turned.shells().count();
        assert_eq!(n_shells, if angle.abs() < TAU { 1 } else { 2 });
    }
}

#[test]
fn a_border_along_the_axis_makes_poles_and_no_face() {
    let half = polygon(&[[0.0; 3], [2.0, 0.0, 0.0], [0.0, 0.0, 3.0]]);
    let cone = Solid::revolved(&region(&half, &[]), axis(), TAU, TOLERANCE).expect("a cone");
    assert_eq!(cone.faces().len(), 2);
    check(&cone, 4.0 * PI, 2);
    let wedge =
        Solid::revolved(&region(&half, &[]), axis(), FRAC_PI_2, TOLERANCE).expect("a wedge");
    assert_eq!(wedge.faces().len(), 4);
    check(&wedge, PI, 2);
}

#[test]
fn faces_are_turned_outward() {
    let cone = NurbsSurface::cone(Frame::XY, [2.0, 1.0], 3.0).expect("a cone");
    for side in [whole(cone.clone()), whole(cone.clone()).reversed()] {
        let frustum = Solid::capped(&[side], TOLERANCE).expect("a frustum");
        assert_eq!(frustum.faces().len(), 3);
        check(&frustum, 7.0 * PI, 2);
    }
}

#[test]
fn rims_in_one_plane_are_closed_together() {
    let pipe =
        |radius: f64| whole(NurbsSurface::cone(Frame::XY, [radius; 2], 3.0).expect("a pipe"));
    let ring = Solid::capped(&[pipe(2.0), pipe(1.0)], TOLERANCE).expect("a ring");
    assert_eq!((ring.faces().len(), ring.shells().count()), (4, 1));
    check(&ring, 9.0 * PI, 0);
}

#[test]
fn parts_of_surfaces_share_the_vertices_of_their_cuts() {
    let sphere = ball(DVec3::ZERO, 1.0);
    for (height, tilt) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.7), (0.2, 1.1)] {
        let normal = DMat3::from_axis_angle(DVec3::X, tilt) * DVec3::Z;
        let plane = Frame::from_normal(normal * height, normal, None).expect("a plane");
        let dome = sphere.part_at(&[Cutter::Plane(plane)], normal, TOLERANCE).expect("a dome");
        let cap = Solid::capped(&[dome], TOLERANCE).expect("a cap");
        let h = 1.0 - height;
        let volume = PI * h * h * (1.0 - h / 3.0);
        let found = cap.volume_mass().expect("a volume").amount;
        assert!((found - volume).abs() < 1e-5, "{found} for {volume}");
        let mesh = cap.mesh(&TessellationOptions::within(1e-3), 1_000_000).expect("a mesh");
        let check = mesh.check(TOLERANCE);
        assert!(check.is_closed && check.is_manifold && check.is_oriented, "{tilt}: {check:?}");
        assert_eq!(check.euler, 2);
    }
}

#[test]
fn shells_in_one_another_are_voids_and_bodies_in_turn() {
    let balls = [3.0, 1.0, 2.0].map(|radius| ball(DVec3::X * 0.1, radius));
    let nested = Solid::new(&balls, TOLERANCE).expect("a solid");
    check(&nested, 4.0 / 3.0 * PI * (27.0 - 8.0 + 1.0), 6);
    let beside = [ball(DVec3::ZERO, 1.0), ball(DVec3::new(1.5, 1.5, 0.0), 1.0)];
    check(&Solid::new(&beside, TOLERANCE).expect("two bodies"), 8.0 / 3.0 * PI, 4);
}

#[test]
fn a_mirrored_solid_looks_outward() {
    let plate = Solid::extruded(&sieve(2), DVec3::new(0.3, 0.0, 1.0), TOLERANCE).expect("a plate");
    let volume = 4.0 - 4.0 * PI * 0.09;
    for (scale, factor) in [
        (DVec3::new(-1.0, 1.0, 1.0), 1.0),
        (DVec3::splat(-2.0), 8.0),
        (DVec3::new(1.0, 3.0, 1.0), 3.0),
    ] {
        let image = plate.transformed(&DAffine3::from_scale(scale)).expect("an image");
        check(&image, factor * volume, 2 - 2 * 4);
    }
}

#[test]
fn what_makes_no_solid_is_refused() {
    let refused = |found: Result<Solid, GeomError>| found.expect_err("no solid");
    let pipe = whole(NurbsSurface::cone(Frame::XY, [1.0; 2], 3.0).expect("a pipe"));
    assert!(matches!(
        refused(Solid::new(std::slice::from_ref(&pipe), TOLERANCE)),
        GeomError::Face(FaceError::OpenShell { .. })
    ));
    let crossing = [ball(DVec3::ZERO, 1.0), ball(DVec3::X, 1.0)];
    assert!(matches!(
        refused(Solid::new(&crossing, TOLERANCE)),
        GeomError::Solid(SolidError::ShellsMeet { faces: [0, 1], .. })
    ));
    let touching = [ball(DVec3::ZERO, 1.0), ball(DVec3::X * 2.0, 1.0)];
    assert!(matches!(
        refused(Solid::new(&touching, TOLERANCE)),
        GeomError::Solid(SolidError::ShellsMeet { .. })
    ));
    let square = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y);
    let square = whole(square.expect("a square"));
    assert!(matches!(
        refused(Solid::new(&[square.clone(), square.reversed()], TOLERANCE)),
        GeomError::Solid(SolidError::Thin { .. })
    ));
    let revolved = |outer: &NurbsCurve, angle: f64| {
        refused(Solid::revolved(&region(outer, &[]), axis(), angle, TOLERANCE))
    };
    let disc = |x: f64| circle(Frame::ZX.at(DVec3::X * x), 1.0);
    assert!(matches!(revolved(&disc(0.5), TAU), GeomError::Solid(SolidError::AcrossAxis { .. })));
    assert!(matches!(revolved(&disc(1.0), 1.0), GeomError::Solid(SolidError::PointOnAxis { .. })));
    let tip = polygon(&[[0.0; 3], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0]]);
    assert!(matches!(revolved(&tip, TAU), GeomError::Solid(SolidError::PointOnAxis { .. })));
    let flat = circle(Frame::XY.at(DVec3::X * 3.0), 1.0);
    assert!(matches!(revolved(&flat, TAU), GeomError::Solid(SolidError::AxisOffPlane { .. })));
    let along = Solid::extruded(&region(&flat, &[]), DVec3::X, TOLERANCE);
    assert!(matches!(refused(along), GeomError::Solid(SolidError::AlongPlane { .. })));
}

/// As many handles as the mesh has, and as counted; a place is inside as the closed form says.
#[test]
fn edges_tell_the_genus_and_nearest_faces_the_inside() {
    let pipe =
        |radius: f64| whole(NurbsSurface::cone(Frame::XY, [radius; 2], 3.0).expect("a pipe"));
    let tube = Solid::capped(&[pipe(2.0), pipe(1.0)], TOLERANCE).expect("a tube");
    let plate = Solid::extruded(&sieve(3), DVec3::new(0.3, 0.0, 1.0), TOLERANCE).expect("a plate");
    let nested = [ball(DVec3::ZERO, 3.0), ball(DVec3::ZERO, 1.0)];
    let nested = Solid::new(&nested, TOLERANCE).expect("a hollow ball");
    let tilted = Frame::from_normal(DVec3::Y * 0.2, DVec3::new(0.3, 0.1, 1.0), None);
    let tilted = tilted.expect("a plane").at(DVec3::Z * 1.5);
    let half = tube.cut(tilted, false, TOLERANCE).expect("a half").expect("a part");
    for (solid, genus) in [(&tube, 1), (&plate, 9), (&nested, 0), (&half, 1)] {
        let found = solid.topology(TOLERANCE).expect("edges");
        assert_eq!(found.genus(), genus);
        let mesh = solid.mesh(&TessellationOptions::within(1e-2), 1_000_000).expect("a mesh");
        let n_shells = solid.shells().count() as i64;
        assert_eq!(mesh.check(TOLERANCE).euler, 2 * (n_shells - genus));
    }
    for (solid, edges) in [(&tube, 4), (&plate, 12 + 18), (&nested, 0)] {
        assert_eq!(solid.edges(TOLERANCE).expect("edges").len(), edges);
    }
    let in_tube = |p: DVec3| {
        let radius = libm::sqrt(p.x * p.x + p.y * p.y);
        (1.0..2.0).contains(&radius) && (0.0..3.0).contains(&p.z)
    };
    let in_ball = |p: DVec3| (1.0..3.0).contains(&p.length());
    for i in 0..200 {
        let at = |k: f64| 4.4 * (libm::fmod(k * f64::from(i), 1.0) - 0.5);
        let p = DVec3::new(at(0.754_877_666), at(0.569_840_291), 0.5 * at(0.618_033_989) + 1.5);
        for (solid, is_inside) in [(&tube, in_tube(p)), (&nested, in_ball(p))] {
            let found = solid.side_of(p, TOLERANCE).expect("a side");
            let expected = if is_inside { RegionSide::Inside } else { RegionSide::Outside };
            assert_eq!(found, expected, "{p}");
        }
    }
    // Beside a rim, an edge and a corner.
    for off in [1e-5, -1e-5] {
        let rim = DVec3::new(2.0 + off, 0.0, 3.0 + 0.3 * off);
        let rim = tube.side_of(rim, TOLERANCE).expect("a side");
        let corner = plate.side_of(DVec3::new(-off, -off, -off), TOLERANCE).expect("a side");
        let expected = if off < 0.0 { RegionSide::Inside } else { RegionSide::Outside };
        assert_eq!((rim, corner), (expected, expected), "{off}");
    }
}

/// Shells that are apart by a hundredth of a thousandth of their size, wherever their poles and seams are.
#[test]
fn walls_may_be_thin() {
    let turn = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.6);
    let ring = |minor: f64| whole(NurbsSurface::torus(Frame::XY, 3.0, minor).expect("a ring"));
    for wall in [1e-2, 1e-3, 1e-4, 1e-5] {
        let inner = ball(DVec3::ZERO, 1.0 - wall).transformed(&turn).expect("an image");
        let hollow = Solid::new(&[ball(DVec3::ZERO, 1.0), inner], TOLERANCE).expect("a ball");
        let rest = 1.0 - wall;
        check(&hollow, 4.0 / 3.0 * PI * (1.0 - rest * rest * rest), 4);
        let tire = Solid::new(&[ring(1.0), ring(rest)], TOLERANCE).expect("a tire");
        check(&tire, 6.0 * PI * PI * (1.0 - rest * rest), 0);
    }
}

/// A ball, a void in it and a block beside it, gone through by a line in every direction.
#[test]
fn a_line_goes_through_a_solid_where_the_equations_of_its_faces_say() {
    let center = DVec3::new(0.3, -0.2, 0.1);
    let hollow = Solid::new(&[ball(center, 2.0), ball(center, 1.5)], TOLERANCE);
    let hollow = hollow.expect("a hollow ball");
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    let block = Solid::extruded(&region(&polygon(&corners), &[]), 3.0 * DVec3::Z, TOLERANCE)
        .expect("a block");
    for n in 0..60 {
        let turn = f64::from(n);
        let way = DVec3::new(libm::cos(turn), libm::sin(1.7 * turn), libm::sin(0.6 * turn + 0.3));
        let beside = DVec3::new(libm::sin(turn), libm::cos(0.9 * turn), 0.4) * 0.8;
        let line = |through: DVec3| {
            NurbsCurve::line(through - 8.0 * way, through + 8.0 * way).expect("a line").into()
        };
        // |from + t·16·way − center| is the radius.
        let line_of_ball: Curve = line(center + beside);
        let (along, off) = (way.length(), beside - way * (beside.dot(way) / way.length_squared()));
        let mut expected = Vec::new();
        for radius in [2.0, 1.5] {
            let half = (radius * radius - off.length_squared()).sqrt() / (16.0 * along);
            let middle = 0.5 - beside.dot(way) / (16.0 * way.length_squared());
            if half.is_finite() {
                expected.extend([middle - half, middle + half]);
            }
        }
        expected.sort_by(f64::total_cmp);
        let found = hollow.piercings(&line_of_ball, TOLERANCE).expect("places");
        assert_eq!(found.len(), expected.len(), "{n}: {found:?}");
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found.place.t - expected).abs() < 1e-9, "{n}: {found:?} for {expected}");
        }
        // Through a convex block: none or two places, on its sides; through its middle two.
        let middle = DVec3::new(0.5, 1.0, 1.5);
        let found = block.piercings(&line(middle), TOLERANCE).expect("places");
        assert_eq!(found.len(), 2, "{n}: {found:?}");
        for place in &found {
            let side = block.side_of(place.place.point, TOLERANCE).expect("a side");
            assert_eq!(side, RegionSide::Border, "{n}");
        }
        let sum = found[0].place.point + found[1].place.point;
        assert!(sum.distance(2.0 * middle) < 1e-9, "{n}: {found:?}");
    }
    // Through two corners, which three faces have in common each, and along a diagonal of a face.
    let diagonal: Curve =
        NurbsCurve::line(DVec3::new(-1.0, -2.0, -3.0), DVec3::new(2.0, 4.0, 6.0)).unwrap().into();
    let found = block.piercings(&diagonal, TOLERANCE).expect("places");
    assert_eq!(found.len(), 2, "{found:?}");
    let in_face: Curve =
        NurbsCurve::line(DVec3::new(-1.0, -1.0, 3.0), DVec3::new(2.0, 2.0, 3.0)).unwrap().into();
    assert!(block.piercings(&in_face, TOLERANCE).is_err());
}

/// However many holes there are, the volume of a plate is known to the last digits.
#[test]
fn a_plate_with_many_holes_has_an_exact_volume() {
    for (n, way) in [(3, DVec3::Z), (12, DVec3::new(0.3, -0.2, 2.0))] {
        let plate = Solid::extruded(&sieve(n), way, TOLERANCE).expect("a plate");
        let n_holes = (n * n) as f64;
        let expected = way.z * n_holes * (1.0 - 0.09 * PI);
        let found = plate.volume_mass().expect("a volume").amount;
        assert!((found / expected - 1.0).abs() <= 1e-13, "{found} for {expected}");
    }
}
