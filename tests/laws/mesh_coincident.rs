//! Laws of booleans of meshes whose faces coincide, as a whole or in parts.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec3};
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy},
    prop_assert, proptest,
};
use virote_kernel::{Frame, GeomError, Mesh, MeshError, NurbsSurface, polygon_mesh, tessellate};

use crate::{
    mesh_boolean::{Operation, TOLERANCE, cuboid, volume},
    some::motion,
};

/// A box whose corners have small whole numbers: its first corner and its size.
fn whole_box() -> impl Strategy<Value = [[u8; 3]; 2]> {
    [[0..3u8, 0..3u8, 0..3u8], [1..4u8, 1..4u8, 1..4u8]]
}

/// A prism over a regular polygon whose walls and ends are one face each.
fn turned_prism(n: usize, turn: f64, height: f64) -> Mesh {
    let corner = |k: usize| {
        let angle = TAU * (k % n) as f64 / n as f64 + turn;
        DVec3::new(libm::cos(angle), libm::sin(angle), if k < n { 0.0 } else { height })
    };
    let walls = (0..n).map(|k| vec![k, (k + 1) % n, (k + 1) % n + n, k + n]);
    let ends = [(0..n).rev().collect(), (n..2 * n).collect()];
    let faces: Vec<Vec<usize>> = walls.chain(ends).collect();
    polygon_mesh((0..2 * n).map(corner).collect(), &faces, 1000).unwrap()
}

/// Earth on a rectangle of 10 by 6, down to −2, with heights on its grid of n × n cells.
fn earth(n: usize, heights: &[f64]) -> Mesh {
    let vertices = (0..=n).flat_map(|i| {
        (0..=n).flat_map(move |j| {
            let (x, y) = (10.0 * i as f64 / n as f64, 6.0 * j as f64 / n as f64);
            [DVec3::new(x, y, -2.0), DVec3::new(x, y, heights[i * (n + 1) + j])]
        })
    });
    let [low, high] = [0, 1].map(|top| move |i: usize, j: usize| 2 * (i * (n + 1) + j) + top);
    let mut faces = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            let [a, b, c, d] = corners.map(|[i, j]| high(i, j));
            faces.extend([vec![a, b, c], vec![a, c, d]]);
            let [a, b, c, d] = corners.map(|[i, j]| low(i, j));
            faces.extend([vec![c, b, a], vec![d, c, a]]);
        }
    }
    for k in 0..n {
        let sides = [[k, 0, k + 1, 0], [n, k, n, k + 1], [k + 1, n, k, n], [0, k + 1, 0, k]];
        for [i, j, other_i, other_j] in sides {
            let [a, b] = [low(i, j), low(other_i, other_j)];
            faces.extend([
                vec![a, b, high(other_i, other_j)],
                vec![a, high(other_i, other_j), high(i, j)],
            ]);
        }
    }
    polygon_mesh(vertices.collect(), &faces, 100_000).unwrap()
}

/// Checks what two meshes make together, in place and moved: closed, of the volume that it should have and nothing where
/// that is none, and of the area that is left of both, or refused because it would touch itself. Where faces are where
/// they were put, only unions may be; moved, their planes are rounded, and of differences sheets of rounding may be left.
fn check_pair(a: &Mesh, b: &Mesh, common: Option<f64>, motion: &DAffine3) {
    let mut areas = [Vec::new(), Vec::new()];
    for is_moved in [false, true] {
        let [a, b] =
            [a, b].map(|mesh| if is_moved { mesh.transformed(motion) } else { mesh.clone() });
        let mut done = |operation: Operation, may_touch: bool| match operation(&[&a, &b], TOLERANCE)
        {
            Ok(found) => {
                let area = found.as_ref().map_or(0.0, Mesh::area);
                areas[usize::from(is_moved)].push(Some(area));
                if let Some(mesh) = &found {
                    let check = mesh.check(TOLERANCE);
                    assert!(check.is_closed && check.is_manifold && check.is_oriented, "{check:?}");
                }
                Some(volume(&found))
            }
            Err(GeomError::Mesh(MeshError::TouchesItself { .. })) if may_touch => {
                areas[usize::from(is_moved)].push(None);
                None
            }
            Err(error) => unreachable!("{error}"),
        };
        let shared = done(Mesh::intersection, false).unwrap();
        let common = common.unwrap_or(shared);
        let near = |found: Option<f64>, expected: f64| {
            assert!(
                found.is_none_or(|found| (found - expected).abs() < 1e-7),
                "{found:?} for {expected}"
            );
        };
        near(Some(shared), common);
        near(done(Mesh::union, true), a.volume() + b.volume() - common);
        near(done(Mesh::difference, is_moved), a.volume() - common);
    }
    let [placed, moved] = &areas;
    for (placed, moved) in placed.iter().zip(moved) {
        if let (Some(placed), Some(moved)) = (placed, moved) {
            assert!((placed - moved).abs() < 1e-6, "area {moved}, in place {placed}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn boxes_that_share_parts_of_faces_have_their_volumes(a in whole_box(), b in whole_box(), motion in motion()) {
        let common = (0..3).map(|i| {
            let end = (a[0][i] + a[1][i]).min(b[0][i] + b[1][i]);
            f64::from(end.saturating_sub(a[0][i].max(b[0][i])))
        });
        let common = common.product();
        let [a, b] = [a, b].map(|[corner, size]| cuboid(corner.map(f64::from), size.map(f64::from)));
        check_pair(&a, &b, Some(common), &motion);
    }

    #[test]
    fn prisms_turned_about_one_axis_on_one_floor_have_their_volumes(
        n in 3..9usize,
        part in 0.05..0.95,
        height in 1..3u8,
        motion in motion(),
    ) {
        // What both have in common has 2n sides, which touch one circle.
        let step = TAU / n as f64;
        let turn = part * step;
        let radius = libm::cos(0.5 * step);
        let sides = libm::tan(0.5 * turn) + libm::tan(0.5 * (step - turn));
        let common = n as f64 * radius * radius * sides;
        let [a, b] = [turned_prism(n, 0.0, 1.0), turned_prism(n, turn, f64::from(height))];
        check_pair(&a, &b, Some(common), &motion);
    }

    #[test]
    fn cut_and_fill_of_earth_within_the_same_walls_balance(
        cells in [2..5usize, 2..5usize],
        heights in vec(1.0..2.0, 98),
        motion in motion(),
    ) {
        let [before, after] = [earth(cells[0], &heights[..49]), earth(cells[1], &heights[49..])];
        check_pair(&before, &after, None, &motion);
        let cut = Mesh::difference(&[&before, &after], TOLERANCE).unwrap();
        let fill = Mesh::difference(&[&after, &before], TOLERANCE).unwrap();
        let balance = volume(&cut) - volume(&fill);
        prop_assert!((balance - (before.volume() - after.volume())).abs() < 1e-8);
    }
}

/// A box against a wall of another, and one whose wall it shares in part, turned and far away.
#[test]
fn walls_that_coincide_but_for_rounding_are_none() {
    let large = cuboid([0.0; 3], [2.0; 3]);
    let against = cuboid([2.0, 0.5, 0.5], [1.0; 3]);
    let beside = cuboid([2.0, 1.5, 1.0], [2.0, 1.0, 3.0]);
    for turn in 0..40 {
        let axis = DVec3::new(1.0, 2.0, 0.1 * f64::from(turn)).normalize();
        let turned = DAffine3::from_axis_angle(axis, 0.3 + f64::from(turn));
        let far = DAffine3::from_translation(DVec3::new(100.0, -20.0, 7.0) * f64::from(turn % 3));
        let placed = |mesh: &Mesh| mesh.transformed(&(far * turned));
        for (other, area) in [(&against, 28.0), (&beside, 24.0 + 22.0 - 2.0 * 0.5)] {
            let [a, b] = [&large, other].map(placed);
            let whole = Mesh::union(&[&a, &b], TOLERANCE).unwrap().unwrap();
            let check = whole.check(TOLERANCE);
            assert!(check.is_closed && check.components == 1, "{turn}: {check:?}");
            assert!((whole.area() - area).abs() < 1e-9, "{turn}: {}", whole.area());
            assert_eq!(Mesh::intersection(&[&a, &b], TOLERANCE).unwrap(), None, "{turn}");
            let again = Mesh::difference(&[&whole, &b], TOLERANCE).unwrap().unwrap();
            assert!((again.area() - 24.0).abs() < 1e-9, "{turn}: {}", again.area());
        }
    }
}

/// A ball, whose triangles are slivers at its poles, with itself.
#[test]
fn a_mesh_with_itself_is_itself_or_nothing() {
    for tolerance in [0.05, 0.02] {
        let ball = NurbsSurface::sphere(Frame::XY, 0.7).unwrap();
        let ball = tessellate(&ball, tolerance, 100_000).unwrap();
        let whole = ball.volume();
        for operation in [Mesh::union, Mesh::intersection] {
            let same = operation(&[&ball, &ball], TOLERANCE).unwrap();
            assert!((volume(&same) - whole).abs() <= 1e-12 * whole);
        }
        assert_eq!(Mesh::difference(&[&ball, &ball], TOLERANCE).unwrap(), None);
    }
}
