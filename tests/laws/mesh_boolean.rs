//! Booleans of closed meshes: volumes of closed forms, the laws of sets, and what is refused.

use std::{f64::consts::PI, thread};

use glam::{DAffine3, DQuat, DVec3};
use proptest::{prelude::ProptestConfig, prop_assert, proptest};
use virote_kernel::{GeomError, Mesh, MeshError, Tolerance};

pub(crate) const TOLERANCE: Tolerance = Tolerance::DEFAULT;

pub(crate) fn cuboid(corner: [f64; 3], size: [f64; 3]) -> Mesh {
    let (corner, size) = (DVec3::from(corner), DVec3::from(size));
    let place = |i: u32| {
        corner + size * DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2))
    };
    let sides: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh::new((0..8).map(place).collect(), vec![], vec![], triangles).unwrap()
}

/// A right prism over the regular polygon of n corners, of height 2 about the middle, along z.
fn prism(n: u32, radius: f64) -> Mesh {
    let corner = |i: u32, z: f64| {
        let angle = 2.0 * PI * f64::from(i) / f64::from(n);
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
    };
    let mut vertices: Vec<DVec3> = (0..n).map(|i| corner(i, -1.0)).collect();
    vertices.extend((0..n).map(|i| corner(i, 1.0)));
    vertices.extend([DVec3::NEG_Z, DVec3::Z]);
    let side = |i: u32| {
        let j = (i + 1) % n;
        [[i, j, n + j], [i, n + j, n + i], [2 * n, j, i], [2 * n + 1, n + i, n + j]]
    };
    Mesh::new(vertices, vec![], vec![], (0..n).flat_map(side).collect()).unwrap()
}

/// A sphere of rings and sectors.
fn sphere(center: DVec3, radius: f64, n: u32) -> Mesh {
    let place = |ring: u32, sector: u32| {
        let polar = PI * f64::from(ring) / f64::from(n);
        let around = PI * f64::from(sector) / f64::from(n);
        let flat = libm::sin(polar);
        let direction = [flat * libm::cos(around), flat * libm::sin(around), libm::cos(polar)];
        center + radius * DVec3::from(direction)
    };
    let mut vertices = vec![center + radius * DVec3::Z];
    vertices.extend((1..n).flat_map(|ring| (0..2 * n).map(move |sector| place(ring, sector))));
    vertices.push(center - radius * DVec3::Z);
    let last = vertices.len() as u32 - 1;
    let name = |ring: u32, sector: u32| match ring {
        0 => 0,
        ring if ring == n => last,
        ring => 1 + (ring - 1) * 2 * n + sector % (2 * n),
    };
    let cell = |ring: u32, sector: u32| {
        let [a, b] = [name(ring, sector), name(ring, sector + 1)];
        let [c, d] = [name(ring + 1, sector), name(ring + 1, sector + 1)];
        [[a, c, d], [a, d, b]]
    };
    let cells = (0..n).flat_map(|ring| (0..2 * n).flat_map(move |sector| cell(ring, sector)));
    let triangles = cells.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    Mesh::new(vertices, vec![], vec![], triangles).unwrap()
}

pub(crate) fn volume(mesh: &Option<Mesh>) -> f64 {
    mesh.as_ref().map_or(0.0, Mesh::volume)
}

pub(crate) type Found = Result<Option<Mesh>, GeomError>;
pub(crate) type Operation = fn(&[&Mesh], Tolerance) -> Found;

#[track_caller]
fn check(operation: Operation, meshes: &[&Mesh], expected: f64) {
    let found = operation(meshes, TOLERANCE).unwrap();
    let got = volume(&found);
    assert!((got - expected).abs() <= 1e-10 * expected.max(1.0), "{got} for {expected}");
    if let Some(mesh) = &found {
        let check = mesh.check(TOLERANCE);
        assert!(check.is_closed && check.is_manifold && check.is_oriented, "{check:?}");
    }
}

#[test]
fn boxes_have_the_volumes_of_their_parts() {
    let (a, b) = (cuboid([0.0; 3], [2.0; 3]), cuboid([1.0; 3], [2.0; 3]));
    check(Mesh::union, &[&a, &b], 15.0);
    check(Mesh::intersection, &[&a, &b], 1.0);
    check(Mesh::difference, &[&a, &b], 7.0);
    check(Mesh::union, &[&a], 8.0);
    check(Mesh::difference, &[&a], 8.0);
}

#[test]
fn coincident_faces_are_one() {
    let a = cuboid([0.0; 3], [2.0; 3]);
    check(Mesh::union, &[&a, &cuboid([2.0, 0.0, 0.0], [1.0, 2.0, 2.0])], 12.0);
    check(Mesh::intersection, &[&a, &cuboid([2.0, 0.0, 0.0], [1.0, 2.0, 2.0])], 0.0);
    check(Mesh::union, &[&a, &cuboid([0.5, 0.5, 2.0], [1.0; 3])], 9.0);
    check(Mesh::difference, &[&a, &cuboid([0.5, 0.5, 1.0], [1.0; 3])], 7.0);
    check(Mesh::union, &[&a, &a], 8.0);
    check(Mesh::intersection, &[&a, &a, &a], 8.0);
    check(Mesh::difference, &[&a, &a], 0.0);
}

#[test]
fn what_differs_by_less_than_the_tolerance_is_one() {
    let a = sphere(DVec3::ZERO, 1.0, 12);
    for shift in [1e-8, 1e-7, 5e-7] {
        let moved = a.transformed(&DAffine3::from_translation(DVec3::splat(shift / 2.0)));
        check(Mesh::difference, &[&a, &moved], 0.0);
        check(Mesh::union, &[&a, &moved], a.volume());
    }
}

#[test]
fn a_hole_is_a_prism_and_a_void_a_shell_inside() {
    let (plate, hole) = (cuboid([-2.0, -2.0, -0.5], [4.0, 4.0, 1.0]), prism(60, 1.0));
    let base = 30.0 * libm::sin(2.0 * PI / 60.0);
    check(Mesh::difference, &[&plate, &hole], 16.0 - base);
    let drilled = Mesh::difference(&[&plate, &hole], TOLERANCE).unwrap().unwrap();
    assert_eq!(drilled.check(TOLERANCE).euler, 0);
    check(Mesh::union, &[&drilled, &hole], 16.0 + base);

    let (big, small) = (cuboid([0.0; 3], [3.0; 3]), cuboid([1.0; 3], [1.0; 3]));
    let hollow = Mesh::difference(&[&big, &small], TOLERANCE).unwrap().unwrap();
    assert_eq!(hollow.check(TOLERANCE).components, 2);
    check(Mesh::union, &[&hollow, &small], 27.0);
    check(Mesh::intersection, &[&hollow, &cuboid([0.0; 3], [1.5, 3.0, 3.0])], 13.5 - 0.5);
}

#[test]
fn a_lens_of_spheres_has_its_volume() {
    // Two unit spheres a distance d apart share π(4 + d)(2 − d)²/12.
    let n = 60;
    let (a, b) = (sphere(DVec3::ZERO, 1.0, n), sphere(DVec3::new(0.3, 0.5, 0.4), 1.0, n));
    let d = DVec3::new(0.3, 0.5, 0.4).length();
    let lens = PI * (4.0 + d) * (2.0 - d) * (2.0 - d) / 12.0;
    let common = volume(&Mesh::intersection(&[&a, &b], TOLERANCE).unwrap());
    // A mesh of chords of 3 degrees is inside by less than 1 − cos² 1.5° of the radius a sphere.
    assert!(common < lens && lens - common < 3e-3 * lens, "{common} for {lens}");
}

#[test]
fn sizes_scale_with_the_meshes() {
    for scale in [1e-60, 1e-3, 1.0, 1e3, 1e60] {
        let map = DAffine3::from_scale(DVec3::splat(scale));
        let (a, b) = (sphere(DVec3::ZERO, 1.0, 12), cuboid([0.1, 0.2, 0.3], [2.0; 3]));
        let within = TOLERANCE.with_distance(1e-6 * scale);
        let unit = volume(&Mesh::difference(&[&a, &b], TOLERANCE).unwrap());
        let found = Mesh::difference(&[&a.transformed(&map), &b.transformed(&map)], within);
        let back = found.unwrap().unwrap().transformed(&map.inverse());
        assert!((back.volume() - unit).abs() < 1e-12, "{} at {scale}", back.volume());
    }
}

#[test]
fn all_threads_find_the_same_bits() {
    let (a, b) = (sphere(DVec3::ZERO, 1.0, 16), sphere(DVec3::splat(0.4), 0.9, 15));
    let found = || Mesh::union(&[&a, &b], TOLERANCE).unwrap();
    let alone = found();
    thread::scope(|scope| {
        let others: Vec<_> = (0..4).map(|_| scope.spawn(found)).collect();
        others.into_iter().for_each(|other| assert_eq!(other.join().unwrap(), alone));
    });
}

#[test]
fn what_would_touch_itself_is_refused_with_the_place() {
    let a = cuboid([0.0; 3], [1.0; 3]);
    for (corner, place) in [([1.0, 1.0, 0.0], [1.0, 1.0]), ([1.0, 1.0, 1.0], [1.0, 1.0])] {
        let found = Mesh::union(&[&a, &cuboid(corner, [1.0; 3])], TOLERANCE);
        let Err(GeomError::Mesh(MeshError::TouchesItself { at })) = found else {
            unreachable!("{found:?}")
        };
        assert!((at.x - place[0]).abs() <= 0.0 && (at.y - place[1]).abs() <= 0.0, "{at}");
    }
}

#[track_caller]
fn refused(bad: &Mesh) -> MeshError {
    let good = cuboid([0.25; 3], [1.0; 3]);
    match Mesh::union(&[&good, bad], TOLERANCE) {
        Err(GeomError::Mesh(MeshError::OfSeveral { index: 1, fault })) => *fault,
        found => unreachable!("{found:?}"),
    }
}

fn merged(meshes: &[Mesh]) -> Mesh {
    Mesh::merged(meshes, 1000).unwrap()
}

fn inside_out(mesh: &Mesh) -> Mesh {
    mesh.with_turned(&vec![true; mesh.n_triangles()])
}

#[test]
fn meshes_that_enclose_places_twice_or_not_at_all_are_refused() {
    let a = cuboid([0.0; 3], [3.0; 3]);
    let open = Mesh::new(a.vertices().to_vec(), vec![], vec![], a.triangles()[1..].to_vec());
    assert!(matches!(refused(&open.unwrap()), MeshError::Open { edges: 3, .. }));
    assert!(matches!(refused(&inside_out(&a)), MeshError::Inverted { .. }));
    let (inner, beside) = (cuboid([1.0; 3], [1.0; 3]), cuboid([5.0; 3], [1.0; 3]));
    assert!(matches!(refused(&merged(&[a.clone(), inner])), MeshError::Doubled { .. }));
    let apart = merged(&[a.clone(), inside_out(&beside)]);
    assert!(matches!(refused(&apart), MeshError::Inverted { .. }));
    let corner = cuboid([2.0; 3], [2.0; 3]);
    assert!(matches!(refused(&merged(&[a.clone(), corner])), MeshError::CrossesItself { .. }));
    let shares_sides = cuboid([1.0, 0.0, 0.0], [3.0; 3]);
    let crossing = refused(&merged(&[a.clone(), shares_sides]));
    assert!(matches!(crossing, MeshError::CrossesItself { .. }), "{crossing}");
    let at_corner = merged(&[a, cuboid([3.0; 3], [1.0; 3])]);
    assert_eq!(refused(&at_corner), MeshError::Pinched { at: DVec3::splat(3.0) });
}

#[test]
fn a_hundred_holes_are_cut_at_once() {
    let plate = cuboid([-0.5, -0.5, -0.5], [10.0, 10.0, 1.0]);
    let holes: Vec<Mesh> = (0..100)
        .map(|i| {
            let place = DVec3::new(f64::from(i % 10), f64::from(i / 10), 0.0);
            prism(12, 0.3).transformed(&DAffine3::from_translation(place))
        })
        .collect();
    let all: Vec<&Mesh> = std::iter::once(&plate).chain(&holes).collect();
    // A regular polygon of twelve corners on the circle of radius r has the area 3r².
    check(Mesh::difference, &all, 100.0 - 100.0 * 3.0 * 0.09);
}

proptest! {
    // Each combines meshes some twenty times.
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_laws_of_sets_hold(
        turn in [-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0_f64],
        shift in [-0.8..0.8, -0.8..0.8, -0.8..0.8_f64],
        far in [-0.8..0.8, -0.8..0.8, -0.8..0.8_f64],
    ) {
        let turn = DQuat::from_array(turn).normalize();
        let map = DAffine3::from_rotation_translation(turn, DVec3::from(shift));
        let a = cuboid([-1.0; 3], [2.0; 3]);
        let b = prism(7, 0.9).transformed(&map);
        let c = sphere(DVec3::from(far), 1.1, 7);
        let v = |operation: Operation, meshes: &[&Mesh]| volume(&operation(meshes, TOLERANCE).unwrap());
        let near = |x: f64, y: f64| (x - y).abs() < 1e-9;

        prop_assert!(near(v(Mesh::union, &[&a, &b]), v(Mesh::union, &[&b, &a])));
        prop_assert!(near(v(Mesh::intersection, &[&a, &b]), v(Mesh::intersection, &[&b, &a])));
        let ab = Mesh::union(&[&a, &b], TOLERANCE).unwrap().unwrap();
        prop_assert!(near(v(Mesh::union, &[&ab, &c]), v(Mesh::union, &[&c, &b, &a])));
        // De Morgan, within a box around all.
        let world = cuboid([-4.0; 3], [8.0; 3]);
        let not = |mesh: &Mesh| Mesh::difference(&[&world, mesh], TOLERANCE).unwrap().unwrap();
        prop_assert!(near(v(Mesh::intersection, &[&not(&a), &not(&b)]), volume(&Some(not(&ab)))));
        // Three at once, by inclusion and exclusion.
        let pairs = [[&a, &b], [&b, &c], [&c, &a]].map(|pair| v(Mesh::intersection, &pair));
        let parts = a.volume() + b.volume() + c.volume() - pairs.iter().sum::<f64>()
            + v(Mesh::intersection, &[&a, &b, &c]);
        prop_assert!(near(v(Mesh::union, &[&a, &b, &c]), parts));
        // What is taken away and what is left are the whole.
        if let (Some(left), Some(taken)) = (
            Mesh::difference(&[&a, &b], TOLERANCE).unwrap(),
            Mesh::intersection(&[&a, &b], TOLERANCE).unwrap(),
        ) {
            prop_assert!(near(left.volume() + taken.volume(), a.volume()));
        }
    }
}
