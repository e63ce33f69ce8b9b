//! Faces cut by what lies on them: areas of closed forms, in every orientation, at three scales, with other
//! parameters, and with gaps from far within the tolerance to far beyond.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    CircleForm, Cutter, Direction, Face, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface,
    Region, Solid, Tolerance,
    glam::{DAffine3, DQuat, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// A place, its scale, and the tolerance there, for a quarter of the orientations.
fn placements() -> impl Iterator<Item = (u64, DAffine3, f64, Tolerance)> {
    (0..orientations().div_ceil(4)).map(|n| {
        let scale = [1.0, 1e-3, 1e3][n as usize % 3];
        let [x, y, z, ..] = fractions(n);
        let place = DAffine3::from_translation(DVec3::new(x, -2.0 * y, z) * scale)
            * DAffine3::from_scale(DVec3::splat(scale))
            * turn(n);
        (n, place, scale, TOLERANCE.with_distance(TOLERANCE.distance * scale))
    })
}

/// A turn about z that no parameter line knows of, and every other time the other way up along `about`.
fn about_z(n: u64, angle: f64, flips_about: Option<f64>) -> DAffine3 {
    let spin = DAffine3::from_quat(DQuat::from_rotation_z(angle));
    match flips_about {
        Some(height) if n.is_multiple_of(2) => {
            let up = DAffine3::from_translation(DVec3::Z * height);
            up * DAffine3::from_quat(DQuat::from_rotation_x(PI)) * up.inverse() * spin
        }
        _ => spin,
    }
}

fn sheet(corner: [f64; 2], size: [f64; 2], height: f64) -> NurbsSurface {
    let at = |x: f64, y: f64| DVec3::new(corner[0] + x, corner[1] + y, height);
    let [x, y] = size;
    NurbsSurface::bilinear(at(0.0, 0.0), at(0.0, y), at(x, 0.0), at(x, y)).unwrap()
}

fn whole(surface: NurbsSurface, tolerance: Tolerance) -> Face {
    Face::whole(Arc::new(surface), tolerance).unwrap()
}

/// A body on a plane outline at a height, upward.
fn prism(outline: &NurbsCurve, up: DVec3) -> Solid {
    let region = Region::new(outline, &[], TOLERANCE).unwrap();
    Solid::extruded(&region, up, TOLERANCE).unwrap()
}

fn bar(corner: DVec3, [x, y, z]: [f64; 3]) -> Solid {
    let [a, b] = [corner, corner + DVec3::X * x];
    let across = DVec3::Y * y;
    prism(&NurbsCurve::polyline(&[a, b, b + across, a + across, a]).unwrap(), DVec3::Z * z)
}

fn tube(radii: [f64; 2], low: f64, height: f64) -> NurbsSurface {
    NurbsSurface::cone(Frame::XY.at(DVec3::Z * low), radii, height).unwrap()
}

fn area(parts: &[Face]) -> f64 {
    parts.iter().map(|part| part.mass().unwrap().amount).sum()
}

/// What is inside and outside, both by their areas, and how many parts they are.
fn check(
    surface: &NurbsSurface,
    solid: &Solid,
    wanted: [(f64, usize); 2],
    moves: impl Fn(u64) -> DAffine3,
) {
    for (n, place, scale, tolerance) in placements() {
        let mut own = surface.transformed(&place);
        if n % 4 == 1 {
            own = own.reversed(Direction::U);
        }
        let face = whole(own, tolerance);
        let solid = solid.transformed(&(place * moves(n))).unwrap();
        for (is_inside, (amount, n_parts)) in [true, false].into_iter().zip(wanted) {
            let parts = solid.parts_of(&face, is_inside, tolerance);
            let parts = parts.unwrap();
            let found = area(&parts) / (scale * scale);
            assert_eq!(parts.len(), n_parts, "{n}, {is_inside}: {found} for {amount}");
            assert!((found - amount).abs() < 1e-9, "{n}, {is_inside}: {found} for {amount}");
        }
    }
}

#[test]
fn a_box_that_stands_on_a_sheet_covers_its_base() {
    let base = bar(DVec3::new(-1.0, -1.5, 0.0), [1.0, 2.0, 1.0]);
    check(&sheet([-3.0, -3.0], [6.0, 6.0], 0.0), &base, [(2.0, 1), (34.0, 1)], |n| {
        about_z(n, 0.37, Some(0.0))
    });
}

#[test]
fn a_box_over_the_corner_of_a_sheet_covers_what_is_common() {
    let base = bar(DVec3::new(-1.0, -1.0, 0.0), [3.0, 3.0, 1.0]);
    check(&sheet([0.0, 0.0], [4.0, 3.0], 0.0), &base, [(4.0, 1), (8.0, 1)], |_| DAffine3::IDENTITY);
}

#[test]
fn a_box_whose_wall_is_flush_with_a_side_of_the_sheet_shares_that_side() {
    let base = bar(DVec3::new(1.0, 0.0, 0.0), [1.0, 2.0, 1.0]);
    check(&sheet([0.0, 0.0], [4.0, 3.0], 0.0), &base, [(2.0, 1), (10.0, 1)], |_| {
        DAffine3::IDENTITY
    });
}

#[test]
fn a_round_boss_covers_its_disc() {
    let boss = Solid::capped(&[whole(tube([1.0, 1.0], 0.0, 2.0), TOLERANCE)], TOLERANCE).unwrap();
    let wanted = [(PI, 1), (16.0 - PI, 1)];
    check(&sheet([-2.0, -2.0], [4.0, 4.0], 0.0), &boss, wanted, |n| about_z(n, 1.1, Some(0.0)));
}

#[test]
fn a_disc_is_covered_by_half() {
    let circle = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint).unwrap();
    let disc = Region::new(&circle, &[], TOLERANCE).unwrap();
    let disc = Face::of_region(&disc, TOLERANCE).unwrap();
    let half = bar(DVec3::new(0.0, -3.0, -1.0), [4.0, 6.0, 1.0]);
    for (n, place, scale, tolerance) in placements() {
        let face = disc.transformed(&place).unwrap();
        let solid = half.transformed(&(place * about_z(n, 0.2, None))).unwrap();
        for is_inside in [true, false] {
            let found = area(&solid.parts_of(&face, is_inside, tolerance).unwrap());
            assert!((found / (scale * scale) - 0.5 * PI).abs() < 1e-9, "{n}: {found}");
        }
    }
}

#[test]
fn a_coaxial_shaft_of_the_same_radius_covers_a_band_of_a_wall() {
    let shaft = Solid::capped(&[whole(tube([1.0, 1.0], 1.0, 2.0), TOLERANCE)], TOLERANCE).unwrap();
    let wanted = [(4.0 * PI, 1), (4.0 * PI, 2)];
    check(&tube([1.0, 1.0], 0.0, 4.0), &shaft, wanted, |n| about_z(n, 0.7, Some(2.0)));
}

#[test]
fn a_quarter_of_a_shaft_covers_a_window_of_a_wall() {
    let arc = NurbsCurve::arc(Frame::XY, 1.0, 0.0, 0.5 * PI).unwrap();
    let legs = NurbsCurve::polyline(&[arc.end(), DVec3::ZERO, arc.start()]).unwrap();
    let sector = virote_kernel::join(&[arc, legs], 1e-6).unwrap();
    let quarter = prism(&sector, DVec3::Z * 2.0);
    let wanted = [(PI, 1), (7.0 * PI, 1)];
    check(&tube([1.0, 1.0], -1.0, 4.0), &quarter, wanted, |n| {
        about_z(n, 0.4 + n as f64, Some(1.0))
    });
}

#[test]
fn a_part_of_a_cone_covers_a_band_of_it() {
    let plug = Solid::capped(&[whole(tube([1.5, 0.5], 1.0, 2.0), TOLERANCE)], TOLERANCE).unwrap();
    let slant = 1.25_f64.sqrt();
    let (inside, all) = (PI * 2.0 * 2.0 * slant, PI * 2.0 * 4.0 * slant);
    let wanted = [(inside, 1), (all - inside, 2)];
    check(&tube([2.0, 0.0], 0.0, 4.0), &plug, wanted, |n| about_z(n, 2.3, None));
}

#[test]
fn half_a_ball_covers_half_a_sphere() {
    let ball = whole(NurbsSurface::sphere(Frame::XY, 1.0).unwrap(), TOLERANCE);
    let ball = Solid::new(&[ball], TOLERANCE).unwrap();
    let half = ball.cut(Frame::XY, true, TOLERANCE).unwrap().unwrap();
    let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    check(&sphere, &half, [(2.0 * PI, 1), (2.0 * PI, 1)], turn);
    check(&sphere, &ball, [(4.0 * PI, 1), (0.0, 0)], turn);
}

#[test]
fn half_a_ring_covers_half_a_torus() {
    let torus = NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap();
    let ring = Solid::new(&[whole(torus.clone(), TOLERANCE)], TOLERANCE).unwrap();
    let upright = Frame::from_normal(DVec3::ZERO, DVec3::X, None).unwrap();
    let half = ring.cut(upright, true, TOLERANCE).unwrap().unwrap();
    let amount = 6.0 * PI * PI;
    check(&torus, &half, [(amount, 1), (amount, 1)], |n| about_z(n, 0.3 * n as f64, Some(0.0)));
}

/// With a gap between what is meant to coincide the answer is that of one side or the other, by what the gap is, or a
/// refusal; never anything between.
#[test]
fn gaps_are_within_the_tolerance_or_tell() {
    let base = bar(DVec3::new(-1.0, -1.5, 0.0), [1.0, 2.0, 1.0]);
    let shaft = Solid::capped(&[whole(tube([1.0, 1.0], 1.0, 2.0), TOLERANCE)], TOLERANCE).unwrap();
    let plate = sheet([-3.0, -3.0], [6.0, 6.0], 0.0);
    let wall = tube([1.0, 1.0], 0.0, 4.0);
    let (mut n_right, mut n_all) = (0, 0);
    for (n, place, scale, tolerance) in placements() {
        for digits in [9.0, 6.3, 6.0, 5.5] {
            for sign in [1.0, -1.0] {
                let gap = sign * libm::pow(10.0, -digits);
                let sunk = place * DAffine3::from_translation(DVec3::Z * gap);
                let wider = place * DAffine3::from_scale(DVec3::new(1.0 - gap, 1.0 - gap, 1.0));
                let cases =
                    [(&plate, &base, sunk, 2.0, 36.0), (&wall, &shaft, wider, 4.0 * PI, 8.0 * PI)];
                for (surface, solid, moved, covered, all) in cases {
                    let face = whole(surface.transformed(&place), tolerance);
                    let solid = solid.transformed(&moved).unwrap();
                    n_all += 2;
                    for is_inside in [true, false] {
                        let Ok(parts) = solid.parts_of(&face, is_inside, tolerance) else {
                            continue;
                        };
                        n_right += 1;
                        let found = area(&parts) / (scale * scale);
                        // Above the sheet, or narrower than the wall, it covers nothing.
                        let is_apart = 0.0 < gap && 1e-6 < gap * 1.2;
                        let [least, most] = match (is_apart, 0.0 < gap) {
                            (true, true) if gap < 1.1e-6 => [0.0, covered],
                            (true, _) => [0.0, 0.0],
                            _ => [covered, covered],
                        };
                        let found = if is_inside { found } else { all - found };
                        let near = 1e-4;
                        assert!(
                            (found - least).abs() < near || (found - most).abs() < near,
                            "{n}, gap {gap}, {is_inside}: {found} for {covered}"
                        );
                    }
                }
            }
        }
    }
    assert!(3 * n_all <= 4 * n_right, "{n_right} of {n_all}");
}

#[test]
fn what_covers_a_face_divides_nothing() {
    let small = whole(sheet([0.0, 0.0], [1.0, 1.0], 0.0), TOLERANCE);
    let cutters = [sheet([-1.0, -1.0], [3.0, 3.0], 0.0), sheet([0.0, 0.0], [1.0, 1.0], 0.0)];
    for cutter in cutters {
        let found = small.split(&[Cutter::Surface(Arc::new(cutter))], TOLERANCE);
        assert!(matches!(found, Err(GeomError::Face(FaceError::Covered { index: 0 }))));
    }
    let aside = Cutter::Surface(Arc::new(sheet([3.0, 0.0], [1.0, 1.0], 0.0)));
    let found = small.split(&[aside], TOLERANCE);
    assert!(matches!(found, Err(GeomError::Face(FaceError::Misses { index: 0 }))));
}

/// z = xy, with the tip of another one on it that is a little steeper.
#[test]
fn splines_that_nearly_coincide_are_refused_with_the_place() {
    let saddle = |rise: f64| {
        let at = |x: f64, y: f64| DVec3::new(x, y, rise * x * y);
        NurbsSurface::bilinear(at(0.0, 0.0), at(0.0, 1.0), at(1.0, 0.0), at(1.0, 1.0)).unwrap()
    };
    let face = whole(saddle(1.0), TOLERANCE);
    let found = face.split(&[Cutter::Surface(Arc::new(saddle(1.0 + 1e-8)))], TOLERANCE);
    assert!(
        matches!(found, Err(GeomError::Face(FaceError::RunsTogether { index: 0, .. }))),
        "{found:?}"
    );
    // A part of the very surface is no other one.
    let part = face.split(&[Cutter::Plane(Frame::YZ.at(DVec3::X * 0.5))], TOLERANCE).unwrap();
    let parts = face.split(&[Cutter::Face(Arc::new(part[0].clone()))], TOLERANCE).unwrap();
    assert_eq!(parts.len(), 2);
    assert!((area(&parts) - area(&[face])).abs() < 1e-9);
}
