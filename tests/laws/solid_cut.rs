//! Solids cut by planes: volumes of both sides by closed forms, wherever they are and however large.

use std::f64::consts::{PI, TAU};

use virote_kernel::{
    Axis, Frame, GeomError, NurbsSurface, Solid, SolidError,
    glam::{DAffine3, DVec3},
};

use crate::solid::{TOLERANCE, ball, check, circle, polygon, region, sieve, whole};

fn cube(x: f64) -> f64 {
    x * x * x
}

/// The volumes of both sides of a plane, and the area between them.
#[track_caller]
fn cut(solid: &Solid, plane: Frame) -> ([f64; 2], f64) {
    let side = |is_above| solid.cut(plane, is_above, TOLERANCE).expect("a side");
    let volumes = [false, true].map(|is_above| {
        side(is_above).map_or(0.0, |side| side.volume_mass().expect("a volume").amount)
    });
    let section = solid.section(plane, TOLERANCE).expect("a section");
    (volumes, section.iter().map(|region| region.mass().amount).sum())
}

/// A cap of height h of a ball holds πh²(r − h/3) above a circle of radius √(r² − (r − h)²), wherever they are.
#[test]
fn a_ball_falls_apart_into_its_caps() {
    for scale in [1e-3, 1.0, 1e3] {
        for turn in [0, 4] {
            let axis = DVec3::new(1.0, f64::from(turn) - 2.5, 0.7).normalize();
            let map = DAffine3::from_translation(DVec3::new(2.0, -1.0, 0.5) * scale)
                * DAffine3::from_axis_angle(axis, f64::from(turn))
                * DAffine3::from_scale(DVec3::splat(scale));
            let solid = Solid::new(&[ball(DVec3::ZERO, 2.0)], TOLERANCE).expect("a ball");
            let solid = solid.transformed(&map).expect("an image");
            for height in [-2.5, -0.2, 0.0, 1.9_f64] {
                let normal = map.matrix3 * DVec3::Z;
                let plane =
                    Frame::from_normal(map.transform_point3(DVec3::Z * height), normal, None);
                let ([below, above], area) = cut(&solid, plane.expect("a plane"));
                let h = (2.0 - height).clamp(0.0, 4.0);
                let cap = PI * h * h * (2.0 - h / 3.0) * cube(scale);
                let whole = 32.0 / 3.0 * PI * cube(scale);
                let circle = PI * (4.0 - height * height).max(0.0) * scale * scale;
                let what = format!("scale {scale}, turn {turn}, height {height}");
                assert!(
                    (above - cap).abs() < 2e-6 * whole.max(scale * scale),
                    "{what}: {above} for {cap}"
                );
                assert!(
                    (below + above - whole).abs() < 2e-6 * whole.max(scale * scale),
                    "{what}: {below}"
                );
                assert!(
                    (area - circle).abs() < 1e-5 * circle.max(scale),
                    "{what}: {area} for {circle}"
                );
            }
        }
    }
}

/// What a plane has of the surface of a face beside the face is no part of the cut: an oblique plane that misses
/// the lower end of a cylinder, but not the square of which that is a disc, and cuts of what was cut before.
#[test]
fn planes_beside_trimmed_faces_leave_them_whole() {
    let pipe = whole(NurbsSurface::cone(Frame::XY, [1.0; 2], 3.0).expect("a pipe"));
    let cylinder = Solid::capped(&[pipe], TOLERANCE).expect("a cylinder");
    let tilted = Frame::from_normal(DVec3::new(0.8, 0.8, 0.0), DVec3::new(1.0, 1.0, 0.4), None);
    let ([below, above], _) = cut(&cylinder, tilted.expect("a plane"));
    // Segments beyond chords from (1.6 - 0.4 * 3) / sqrt(2) on, which grow with the height.
    let nearest = 0.4 / libm::sqrt(2.0);
    let half = libm::sqrt(1.0 - nearest * nearest);
    let segments = half - cube(half) / 3.0 - nearest * libm::acos(nearest);
    let hoof = libm::sqrt(2.0) / 0.4 * segments;
    assert!((above - hoof).abs() < 1e-5, "{above} for {hoof}");
    assert!((below + above - 3.0 * PI).abs() < 1e-5, "{below}");

    let ball = Solid::new(&[ball(DVec3::ZERO, 2.0)], TOLERANCE).expect("a ball");
    let at = |height: f64| Frame::XY.at(DVec3::Z * height);
    let cap = ball.cut(at(1.0), true, TOLERANCE).expect("a side").expect("a cap");
    let ([below, above], _) = cut(&cap, at(0.5));
    assert!(below.abs() < 1e-9 && (above - 5.0 / 3.0 * PI).abs() < 1e-5, "{below} {above}");
    let ([below, above], _) = cut(&cap, at(1.5));
    assert!((above - PI * 0.25 * (2.0 - 0.5 / 3.0)).abs() < 1e-5, "{above}");
    assert!((below + above - 5.0 / 3.0 * PI).abs() < 1e-5, "{below}");
}

/// A plane through the middle leaves half, though the flux through its caps is nothing but rounding.
#[test]
fn planes_through_the_middle_leave_halves() {
    let through = |normal: DVec3| Frame::from_normal(DVec3::ZERO, normal, None).expect("a plane");
    for radius in [0.55, 0.75, 2.0, 2.08] {
        let ball = Solid::new(&[ball(DVec3::ZERO, radius)], TOLERANCE).expect("a ball");
        let ([below, above], _) = cut(&ball, through(DVec3::new(1.0, 1.0, 0.0)));
        let half = 2.0 / 3.0 * PI * cube(radius);
        for side in [below, above] {
            assert!((side - half).abs() < 1e-5, "{radius}: {side} for {half}");
        }
    }
    let corners = [[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0], [1.0, 1.0, -1.0], [-1.0, 1.0, -1.0]];
    let square = region(&polygon(&corners), &[]);
    let cube = Solid::extruded(&square, DVec3::Z * 2.0, TOLERANCE).expect("a cube");
    for normal in [DVec3::new(1.0, 2.0, 3.0), DVec3::ONE, DVec3::Z] {
        let ([below, above], _) = cut(&cube, through(normal));
        assert!((below - 4.0).abs() < 1e-9 && (above - 4.0).abs() < 1e-9, "{below} {above}");
    }
}

/// A side that falls apart is one solid of several shells, though these have parts of one face in them.
#[test]
fn a_side_may_fall_apart_into_parts_of_one_face() {
    let corners = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [3.0, 3.0, 0.0],
        [2.0, 3.0, 0.0],
        [2.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 3.0, 0.0],
        [0.0, 3.0, 0.0],
    ];
    let fork = Solid::extruded(&region(&polygon(&corners), &[]), DVec3::Z, TOLERANCE);
    let fork = fork.expect("a fork");
    let plane = Frame::from_normal(DVec3::Y * 2.0, DVec3::Y, None).expect("a plane");
    let side = |is_above| fork.cut(plane, is_above, TOLERANCE).expect("a side").expect("a part");
    let (legs, base) = (side(true), side(false));
    let section = fork.section(plane, TOLERANCE).expect("a section");
    assert_eq!((legs.shells().count(), base.shells().count(), section.len()), (2, 1, 2));
    check(&legs, 2.0, 4);
    check(&base, 5.0, 2);
    // Parts of one plane that overlap, or one in the other, are refused.
    let plate = |from: f64, to: f64, top: f64| {
        let square = polygon(&[[from, from, 0.0], [to, from, 0.0], [to, to, 0.0], [from, to, 0.0]]);
        let plate = Solid::extruded(&region(&square, &[]), DVec3::Z * top, TOLERANCE);
        plate.expect("a plate").faces().to_vec()
    };
    for other in [plate(1.0, 2.0, 1.0), plate(1.0, 4.0, 2.0), plate(2.5, 5.0, 1.0)] {
        let found = Solid::new(&[plate(0.0, 3.0, 3.0), other].concat(), TOLERANCE);
        assert!(matches!(found, Err(GeomError::Solid(SolidError::ShellsMeet { .. }))), "{found:?}");
    }
}

/// A plane that touches a hole or a void from outside cuts what is on its other side, and has a section; the side of
/// the hole would touch itself along a line or in a point.
#[test]
fn sides_are_judged_by_themselves_where_planes_touch_holes() {
    let square = polygon(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 2.0, 0.0], [0.0, 2.0, 0.0]]);
    let hole = |x: f64| circle(Frame::XY.at(DVec3::new(x, 1.0, 0.0)), 0.5);
    let plate = Solid::extruded(&region(&square, &[hole(1.0), hole(3.0)]), DVec3::Z, TOLERANCE);
    let corners = [[1.0, 0.5, 0.0], [1.5, 1.0, 0.0], [1.0, 1.5, 0.0], [0.5, 1.0, 0.0]];
    let pierced = Solid::extruded(&region(&square, &[polygon(&corners)]), DVec3::Z, TOLERANCE);
    let balls = [ball(DVec3::ZERO, 2.0), ball(DVec3::ZERO, 1.0)];
    let pipe =
        |radius: f64| whole(NurbsSurface::cone(Frame::XY, [radius; 2], 3.0).expect("a pipe"));
    let segment = 4.0 * libm::acos(0.5) - libm::sqrt(3.0);
    for (solid, plane, above, area) in [
        (plate, Frame::YZ.at(DVec3::X * 1.5), 5.0 - PI / 4.0, 2.0),
        (pierced, Frame::YZ.at(DVec3::X * 1.5), 5.0, 2.0),
        (Solid::new(&balls, TOLERANCE), Frame::XY.at(DVec3::Z), 5.0 / 3.0 * PI, 3.0 * PI),
        (
            Solid::capped(&[pipe(2.0), pipe(1.0)], TOLERANCE),
            Frame::YZ.at(DVec3::X),
            3.0 * segment,
            6.0 * libm::sqrt(3.0),
        ),
    ] {
        let solid = solid.expect("a solid");
        let side = solid.cut(plane, true, TOLERANCE).expect("a side").expect("a part");
        let volume = side.volume_mass().expect("a volume").amount;
        assert!((volume - above).abs() < 1e-5, "{volume} for {above}");
        let section = solid.section(plane, TOLERANCE).expect("a section");
        let found: f64 = section.iter().map(|region| region.mass().amount).sum();
        assert!((found - area).abs() < 1e-5, "{found} for {area}");
        let other = solid.cut(plane, false, TOLERANCE);
        let touched = match other {
            Err(GeomError::Solid(SolidError::TouchesPlane { point })) => vec![point],
            // Along its edge the cut tells from where to where.
            Err(GeomError::Solid(SolidError::TouchesAlong { ends })) => ends.to_vec(),
            other => panic!("{:?} for a side that touches {plane:?}", other.err()),
        };
        for point in touched {
            assert!((point - plane.origin()).dot(plane.z()).abs() < 1e-6, "{point}");
        }
    }
}

/// A plane through the rims of a hole touches it at both ends: half of the ring hangs together in one of these places
/// alone, on either side.
#[test]
fn halves_that_hang_together_in_a_rim_alone_are_refused() {
    let corners = [[1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [3.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let axis = Axis::new(DVec3::ZERO, DVec3::Y).expect("an axis");
    let ring = Solid::revolved(&region(&polygon(&corners), &[]), axis, TAU, TOLERANCE);
    let ring = ring.expect("a ring");
    let plane = Frame::from_normal(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), None).expect("a plane");
    for is_above in [true, false] {
        let found = ring.cut(plane, is_above, TOLERANCE);
        let Err(GeomError::Solid(SolidError::TouchesPlane { point })) = found else {
            panic!("{:?} of a half that touches itself", found.err());
        };
        let place = DVec3::new(1.0, -1.0, 0.0);
        assert!(point.distance(if is_above { -place } else { place }) < 1e-4, "{point}");
    }
}

/// Planes through a plate with holes, along its sides, through and beside its holes.
#[test]
fn a_sieve_is_cut_through_its_holes() {
    let solid = Solid::extruded(&sieve(3), DVec3::new(0.3, 0.0, 1.0), TOLERANCE).expect("a sieve");
    let whole = solid.volume_mass().expect("a volume").amount;
    for normal in
        [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 0.4, 0.2), DVec3::new(0.1, 0.2, 1.0)]
    {
        for step in [0, 4] {
            let origin = normal.normalize() * (0.37 * f64::from(step) + 0.01);
            let plane = Frame::from_normal(origin, normal, None).expect("a plane");
            let ([below, above], _) = cut(&solid, plane);
            assert!(
                (below + above - whole).abs() < 1e-6 * whole,
                "{normal} {step}: {below} {above}"
            );
        }
    }
    let at = |height: f64| Frame::XY.at(DVec3::Z * height);
    let disc = 9.0 * (1.0 - PI * 0.09);
    // Between its ends the borders are splines within an eighth of the tolerance.
    let border = 12.0 + 9.0 * TAU * 0.3;
    for (height, off) in [(0.0, 1e-9), (0.25, 0.125e-6 * border), (1.0, 1e-9)] {
        let ([below, _], area) = cut(&solid, at(height));
        assert!((below - disc * height).abs() < off, "{height}: {below} for {}", disc * height);
        assert!((area - disc).abs() < off, "{height}: {area} for {disc}");
    }
}

/// `VIROTE_ORIENTATIONS` says how many placements are tried. A thousand times as large the tolerance is 2e-10 of the
/// size.
#[test]
fn placing_makes_no_difference_to_cuts() {
    let n: u32 = std::env::var("VIROTE_ORIENTATIONS").map_or(3, |n| n.parse().expect("a number"));
    let pipe =
        |radius: f64| whole(NurbsSurface::cone(Frame::XY, [radius; 2], 3.0).expect("a pipe"));
    let tube = Solid::capped(&[pipe(2.0), pipe(1.0)], TOLERANCE).expect("a tube");
    let plate = Solid::extruded(&sieve(2), DVec3::new(0.3, 0.0, 1.0), TOLERANCE).expect("a plate");
    let plane = |origin: DVec3, normal: DVec3| Frame::from_normal(origin, normal, None);
    // Through the axis, and through the middle, half is on either side.
    let cases = [
        (&tube, DVec3::Z * 1.5, DVec3::new(0.3, 0.1, 1.0)),
        (&tube, DVec3::ZERO, DVec3::new(0.6, 0.8, 0.0)),
        (&plate, DVec3::new(1.15, 1.0, 0.5), DVec3::new(1.0, 0.4, 0.2)),
        (&plate, DVec3::new(1.15, 1.0, 0.5), DVec3::Z),
    ];
    for i in 0..n {
        let at = |k: f64| 2.0 * libm::fmod(k * f64::from(i + 1), 1.0) - 1.0;
        let axis = DVec3::new(at(0.754_877_666), at(0.569_840_291), at(0.618_033_989)).normalize();
        let scale = [1e-3, 1.0, 1e3][i as usize % 3];
        let map = DAffine3::from_translation(5.0 * scale * axis.cross(DVec3::X))
            * DAffine3::from_axis_angle(axis, f64::from(i))
            * DAffine3::from_scale(DVec3::splat(scale));
        for (number, (solid, origin, normal)) in cases.into_iter().enumerate() {
            let whole = solid.volume_mass().expect("a volume").amount * cube(scale);
            let solid = solid.transformed(&map).expect("an image");
            let plane = plane(map.transform_point3(origin), map.transform_vector3(normal));
            let plane = plane.expect("a plane");
            let ([below, above], _) = cut(&solid, plane);
            let off = TOLERANCE.distance * solid.area_mass().expect("an area").amount;
            for side in [below, above] {
                assert!((side - 0.5 * whole).abs() < off, "{i}, {number}: {side} of {whole}");
            }
        }
    }
}

/// Where the rim crosses seams, at which a section curve may have its middle, nothing touches.
#[test]
fn planes_beside_the_axis_of_a_torus_and_of_a_ring_leave_both_sides() {
    let torus = whole(NurbsSurface::torus(Frame::XY, 3.0, 1.0).expect("a torus"));
    let torus = Solid::new(&[torus], TOLERANCE).expect("a solid");
    let corners = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 0.0, 3.0], [1.0, 0.0, 3.0]];
    let profile = region(&polygon(&corners), &[]);
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).expect("an axis");
    let ring = Solid::revolved(&profile, axis, TAU, TOLERANCE).expect("a ring");
    for (solid, whole, places) in [
        (torus, 6.0 * PI * PI, [0.4, 1.9, 2.2, 2.5, 3.1, 3.7]),
        (ring, 9.0 * PI, [0.2, 0.7, 0.9, 1.3, 1.5, 1.8]),
    ] {
        for at in places {
            let part = |at: f64, is_above: bool| {
                let plane = Frame::from_normal(DVec3::X * at, DVec3::X, None).expect("a plane");
                let part = solid.cut(plane, is_above, TOLERANCE).expect("a part");
                part.expect("something").volume_mass().expect("a volume").amount
            };
            let (above, below) = (part(at, true), part(at, false));
            assert!((above + below - whole).abs() < 1e-6 * whole, "{at}: {above} and {below}");
            assert!((part(-at, false) - above).abs() < 1e-6 * whole, "{at}: {above}");
        }
    }
}

/// Through an edge of the floor of an angle iron as far as its concave corner, and on through the floor: what is below
/// y = 1 + z/2 of x ≤ 2, y ≤ 1 and of x ≤ 1, y ≤ 2 is 2 + ∫ z/2 dz = 9/4 of 3, and the cut is √5/2 long and 1 wide.
#[test]
fn a_plane_goes_on_along_an_edge_behind_a_concave_corner() {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let corners = corners.map(|[x, y]| [x, y, 0.0]);
    let iron = Solid::extruded(&region(&polygon(&corners), &[]), DVec3::Z, TOLERANCE);
    let iron = iron.expect("an angle iron");
    let (corner, normal) = (DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, 1.0, -0.5));
    let mirror = DAffine3::from_axis_angle(DVec3::new(1.0, 1.0, 0.0).normalize(), PI);
    for turn in 0..6 {
        let axis = DVec3::new(1.0, f64::from(turn) - 2.5, 0.7).normalize();
        let place = DAffine3::from_translation(DVec3::new(2.0, -1.0, 0.5))
            * DAffine3::from_axis_angle(axis, f64::from(turn));
        for map in [place, place * mirror] {
            let solid = iron.transformed(&map).expect("an image");
            let (point, up) = (map.transform_point3(corner), map.transform_vector3(normal));
            let ([below, above], area) =
                cut(&solid, Frame::from_normal(point, up, None).expect("a plane"));
            assert!((below - 2.25).abs() < 1e-9 && (above - 0.75).abs() < 1e-9, "{below}, {above}");
            assert!((area - 0.5 * 5.0_f64.sqrt()).abs() < 1e-9, "{turn}: {area}");
        }
    }
}
