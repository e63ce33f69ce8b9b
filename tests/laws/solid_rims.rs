//! Solids cut by planes that touch a rim in one point, or nearly: volumes by closed forms, and meshes that close.

use std::f64::consts::PI;

use virote_kernel::{
    Frame, GeomError, Mesh, NurbsSurface, RegionError, Solid, SolidError, TessellationOptions,
    glam::{DAffine3, DVec3},
};

use crate::solid::{TOLERANCE, ball, whole};

/// Half a ball, a rod and a hat, each with a point of a rim, the normal of a plane through its tangent there, and the
/// volumes below and above.
fn bodies() -> [(Solid, DVec3, DVec3, [f64; 2]); 3] {
    let wall = |radii, height| whole(NurbsSurface::cone(Frame::XY, radii, height).expect("a wall"));
    let capped = |face| Solid::capped(&[face], TOLERANCE).expect("a body");
    let globe = Solid::new(&[ball(DVec3::ZERO, 1.0)], TOLERANCE).expect("a ball");
    let half = globe.cut(Frame::XY, true, TOLERANCE).expect("a half").expect("something");
    // The plane x + z = 1 leaves a cap of the ball; of the hat a cone over an ellipse with half axes √8/3 and 1/√3.
    let h = 1.0 - 0.5_f64.sqrt();
    let (cap, tip) = (PI * h * h * (3.0 - h) / 3.0, 2.0 * 3.0_f64.sqrt() * PI / 27.0);
    let inward = DVec3::new(1.0, 0.0, 1.0);
    [
        (half, DVec3::X, inward, [2.0 / 3.0 * PI - cap, cap]),
        (
            capped(wall([1.0; 2], 3.0)),
            DVec3::new(1.0, 0.0, 3.0),
            DVec3::new(-1.0, 0.0, 1.0),
            [2.0 * PI, PI],
        ),
        (capped(wall([1.0, 0.0], 2.0)), DVec3::X, inward, [2.0 / 3.0 * PI - tip, tip]),
    ]
}

/// The sides of a plane that passes a point of a rim by a distance, after a turn.
fn sides(
    (solid, point, normal): (&Solid, DVec3, DVec3),
    by: f64,
    turn: f64,
) -> [Result<Option<Solid>, GeomError>; 2] {
    let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
    // About the axis of the body first: rims are not touched in their seams alone.
    let map = DAffine3::from_translation(DVec3::new(0.3, -0.2, 0.1))
        * DAffine3::from_axis_angle(axis, turn);
    let around = DAffine3::from_rotation_z(0.7 * turn);
    let point = around.transform_point3(point + normal.normalize() * by);
    let normal = around.transform_vector3(normal);
    let (point, normal) = (map.transform_point3(point), map.transform_vector3(normal));
    let plane = Frame::from_normal(point, normal, None).expect("a plane");
    let solid = solid.transformed(&map).expect("an image");
    [false, true].map(|is_above| solid.cut(plane, is_above, TOLERANCE))
}

fn meshed(side: &Solid) -> Result<Mesh, GeomError> {
    let options = TessellationOptions { weld: 1e-6, ..TessellationOptions::within(1e-3) };
    side.mesh(&options, 1_000_000)
}

#[track_caller]
fn check_mesh(mesh: &Mesh, volume: f64, what: &str) {
    let check = mesh.check(TOLERANCE);
    assert!(check.is_closed && check.is_oriented, "{what}: {check:?}");
    assert!((mesh.volume() - volume).abs() < 0.02, "{what}: {} for {volume}", mesh.volume());
}

#[test]
fn a_plane_that_touches_a_rim_within_the_tolerance_leaves_two_sides_whose_meshes_close() {
    for (solid, point, normal, volumes) in bodies() {
        for (k, by) in [0.0].into_iter().enumerate() {
            let turn = k as f64;
            let found = sides((&solid, point, normal), by, turn);
            for (i, (side, volume)) in found.into_iter().zip(volumes).enumerate() {
                let what = format!("rim at {point}, by {by}, side {i}");
                let side = side.expect(&what).expect(&what);
                let amount = side.volume_mass().expect(&what).amount;
                assert!((amount - volume).abs() < 3e-6, "{what}: {amount} for {volume}");
                check_mesh(&meshed(&side).expect(&what), volume, &what);
            }
        }
    }
}

#[test]
fn slivers_that_are_thicker_than_the_tolerance_are_parts_whose_volumes_sum_up() {
    for (solid, point, normal, volumes) in bodies() {
        for (k, by) in [1e-5, -1e-4, 1e-3].into_iter().enumerate() {
            let found = sides((&solid, point, normal), by, k as f64);
            let mut sum = 0.0;
            for (i, (side, volume)) in found.into_iter().zip(volumes).enumerate() {
                let what = format!("rim at {point}, by {by}, side {i}");
                let side = side.expect(&what).expect(&what);
                sum += side.volume_mass().expect(&what).amount;
                // A sliver may be too thin for its borders to be told apart, and is then refused.
                match meshed(&side) {
                    Ok(mesh) => check_mesh(&mesh, volume, &what),
                    Err(GeomError::Region(RegionError::Unclear { .. })) => {}
                    Err(other) => panic!("{what}: {other}"),
                }
            }
            assert!((sum - volumes[0] - volumes[1]).abs() < 1e-6, "rim at {point}, by {by}: {sum}");
        }
    }
}

#[test]
fn slivers_as_thick_as_the_tolerance_are_cut_or_refused_with_the_edge() {
    for (solid, point, normal, _) in bodies() {
        for (k, by) in [1e-6, -1e-6, 2e-6, -4e-6].into_iter().enumerate() {
            for found in sides((&solid, point, normal), by, k as f64) {
                match found {
                    Ok(_) => {}
                    Err(GeomError::Solid(SolidError::ThinCut { thickness, .. })) => {
                        assert!((thickness - f64::abs(by)).abs() < 1e-8, "{thickness} for {by}");
                    }
                    Err(other) => panic!("rim at {point}, by {by}: {other}"),
                }
            }
        }
    }
}

#[test]
fn planes_beside_a_whole_rim_cut_through_it() {
    let globe = Solid::new(&[ball(DVec3::ZERO, 1.0)], TOLERANCE).expect("a ball");
    let half = globe.cut(Frame::XY, true, TOLERANCE).expect("a half").expect("something");
    let volumes = [0.0, 2.0 / 3.0 * PI];
    for (k, by) in [0.0, 1e-9, -1e-9, 1e-7, -5e-7, 1e-6, -2e-6].into_iter().enumerate() {
        let found = sides((&half, DVec3::X, DVec3::Z), by, k as f64);
        for (i, (side, volume)) in found.into_iter().zip(volumes).enumerate() {
            let what = format!("{volumes:?}, by {by}, side {i}");
            let side = match side {
                Err(GeomError::Solid(SolidError::ThinCut { .. })) if 5e-7 < f64::abs(by) => {
                    continue;
                }
                side => side.expect(&what),
            };
            let amount = side.as_ref().map_or(0.0, |side| side.volume_mass().expect(&what).amount);
            assert!((amount - volume).abs() < 8e-6, "{what}: {amount} for {volume}");
            for chord in [0.05, 0.01] {
                let options =
                    TessellationOptions { weld: 1e-6, ..TessellationOptions::within(chord) };
                let Some(side) = side.as_ref().filter(|_| f64::abs(by) <= 5e-7) else {
                    continue;
                };
                let check = side.mesh(&options, 1_000_000).expect(&what).check(TOLERANCE);
                assert!(check.is_closed && check.is_manifold, "{what}, {chord}: {check:?}");
            }
        }
    }
}

/// Of a cone of radius and height 1, a plane through its axis leaves halves; one through its tip that meets the floor
/// at x = 1/3 leaves above it a cone over the segment of the circle there.
#[test]
fn planes_beside_the_tip_of_a_cone_cut_through_it() {
    let cone = whole(NurbsSurface::cone(Frame::XY, [1.0, 0.0], 1.0).expect("a cone"));
    let cone = Solid::capped(&[cone], TOLERANCE).expect("a body");
    let (cos, chord) = (1.0 / 3.0, 8.0_f64.sqrt() / 3.0);
    let segment = (libm::acos(cos) - cos * chord) / 3.0;
    let half = PI / 6.0;
    let cases = [(DVec3::X, [half; 2]), (DVec3::new(3.0, 0.0, 1.0), [PI / 3.0 - segment, segment])];
    for (normal, volumes) in cases {
        for (k, by) in [0.0, 1e-9, -1e-9, 1e-7, 5e-7].into_iter().enumerate() {
            let found = sides((&cone, DVec3::Z, normal), by, k as f64);
            for (i, (side, volume)) in found.into_iter().zip(volumes).enumerate() {
                let what = format!("{normal}, by {by}, side {i}");
                let side = side.expect(&what).expect(&what);
                let amount = side.volume_mass().expect(&what).amount;
                assert!((amount - volume).abs() < 3e-6, "{what}: {amount} for {volume}");
                check_mesh(&meshed(&side).expect(&what), volume, &what);
            }
        }
    }
}
