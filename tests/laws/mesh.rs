//! Laws of meshes.

use std::f64::consts::PI;

use glam::{DAffine3, DVec3, DVec4};
use proptest::{prop_assert, prop_assert_eq, proptest};
use virote_kernel::{
    Axis, CountError, GeomError, Grid, KnotVector, Mesh, NurbsCurve, NurbsSurface, grid_mesh,
    polygon_mesh, tessellate, tessellate_curve,
};

use crate::some::{curve, sphere, surface};

const MOST: usize = 1_000_000;

fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let leg = b - a;
    let f = ((p - a).dot(leg) / leg.length_squared().max(1e-300)).clamp(0.0, 1.0);
    p.distance(a + leg * f)
}

fn distance_to_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let n = (b - a).cross(c - a);
    let is_beside = |(a, b): (DVec3, DVec3)| (b - a).cross(p - a).dot(n) < 0.0;
    if n.length() > 0.0 && ![(a, b), (b, c), (c, a)].into_iter().any(is_beside) {
        return ((p - a).dot(n) / n.length()).abs();
    }
    distance_to_segment(p, a, b).min(distance_to_segment(p, b, c)).min(distance_to_segment(p, c, a))
}

/// The largest distance of surface points from the mesh, sampled at odd places.
fn deviation(surface: &NurbsSurface, mesh: &Mesh) -> f64 {
    let triangles: Vec<[DVec3; 3]> = mesh.corners().collect();
    let samples =
        surface.points_on_grid(&surface.domain_u().steps(17), &surface.domain_v().steps(13));
    let to_mesh = |&point: &DVec3| {
        let distances = triangles.iter().map(|&triangle| distance_to_triangle(point, triangle));
        distances.fold(f64::INFINITY, f64::min)
    };
    samples.iter().map(to_mesh).fold(0.0, f64::max)
}

/// Whether every edge inside the mesh has two triangles that run along it in opposite directions.
fn is_watertight_up_to(mesh: &Mesh, same: f64) -> bool {
    let snap = |p: DVec3| (p / same).to_array().map(|x| x.round() as i64);
    let edges: Vec<[[i64; 3]; 2]> = mesh
        .corners()
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]].map(|edge| edge.map(snap)))
        .collect();
    let count = |edge: [[i64; 3]; 2]| edges.iter().filter(|&&other| other == edge).count();
    edges.iter().all(|&[a, b]| count([a, b]) == 1 && count([b, a]) == 1)
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(24))]

    #[test]
    fn a_tessellation_keeps_its_tolerance(s in surface(), tolerance in 0.2..1.0) {
        let mesh = tessellate(&s, tolerance, MOST).unwrap();
        let deviation = deviation(&s, &mesh);
        prop_assert!(deviation <= tolerance, "{deviation} > {tolerance}");
    }

    #[test]
    fn a_polygon_keeps_its_tolerance(curve in curve(), tolerance in 0.001..0.5) {
        let polygon = tessellate_curve(&curve, tolerance, MOST).unwrap();
        for point in curve.sample(501) {
            let legs = polygon.windows(2).map(|leg| distance_to_segment(point, leg[0], leg[1]));
            prop_assert!(legs.fold(f64::INFINITY, f64::min) <= tolerance);
        }
    }

    #[test]
    fn a_grid_mesh_has_its_counts(s in surface(), n in 1..9usize, m in 1..9usize) {
        let mesh = grid_mesh(&s, n, m, MOST, 1).unwrap();
        prop_assert!(mesh.n_vertices() == (n + 1) * (m + 1));
        prop_assert!(mesh.n_triangles() == 2 * n * m);
        prop_assert!(mesh.normals().len() == mesh.n_vertices());
    }
}

#[test]
fn a_sphere_mesh_is_closed_and_faces_outward() {
    let sphere = sphere(DVec3::ZERO, 2.0);
    let mesh = grid_mesh(&sphere, 16, 8, MOST, 1).unwrap();
    // Both rows of cells at the poles lose one of their two triangles.
    assert_eq!(mesh.n_triangles(), 2 * 16 * 8 - 2 * 16);
    assert!(is_watertight_up_to(&mesh, 1e-9));
    for (vertex, normal) in mesh.vertices().iter().zip(mesh.normals()) {
        assert!(normal.distance(*vertex / 2.0) < 1e-12);
    }
    for ([a, b, c], triangle) in mesh.corners().zip(mesh.triangles()) {
        let facing = (b - a).cross(c - a);
        assert!(triangle.iter().all(|&i| facing.dot(mesh.normals()[i as usize]) > 0.0));
    }
}

#[test]
fn a_grid_mesh_is_the_same_by_any_number_of_threads() {
    let sphere = sphere(DVec3::ZERO, 2.0);
    let alone = grid_mesh(&sphere, 501, 400, MOST, 1).unwrap();
    assert_eq!(alone.n_triangles(), 2 * 501 * 400 - 2 * 501);
    for n_threads in [2, 3, 7] {
        assert!(grid_mesh(&sphere, 501, 400, MOST, n_threads).unwrap() == alone);
    }
}

#[test]
fn the_mesh_of_a_sphere_tends_to_its_area_and_volume() {
    let mesh = tessellate(&sphere(DVec3::ONE, 1.0), 1e-4, MOST).unwrap();
    assert!(mesh.area() < 4.0 * PI && 4.0 * PI - mesh.area() < 4e-3);
    assert!(mesh.volume() < 4.0 / 3.0 * PI && 4.0 / 3.0 * PI - mesh.volume() < 4e-3);
}

#[test]
fn a_mirror_keeps_the_outside_outside() {
    let mesh = tessellate(&sphere(DVec3::ZERO, 1.0), 1e-2, MOST).unwrap();
    let mirror = DAffine3::from_scale(DVec3::new(-1.0, 2.0, 3.0));
    let mirrored = mesh.transformed(&mirror);
    assert!((mirrored.volume() / (6.0 * mesh.volume()) - 1.0).abs() < 1e-12);
    for (vertex, normal) in mirrored.vertices().iter().zip(mirrored.normals()) {
        let outward = *vertex / DVec3::new(1.0, 4.0, 9.0);
        assert!(normal.distance(outward.normalize()) < 1e-12);
    }
}

#[test]
fn a_plane_needs_no_more_than_its_corners() {
    let plane = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X * 2.0 + DVec3::Y);
    let mesh = tessellate(&plane.unwrap(), 1e-9, MOST).unwrap();
    assert_eq!((mesh.n_vertices(), mesh.n_triangles()), (4, 2));
}

#[test]
fn a_tolerance_beyond_the_ceiling_is_refused() {
    let got = tessellate(&sphere(DVec3::ZERO, 1.0), 1e-12, 10_000);
    assert!(matches!(got, Err(GeomError::Count(CountError::TooManyVertices { most: 10_000, .. }))));
    assert!(matches!(
        grid_mesh(&sphere(DVec3::ZERO, 1.0), usize::MAX, 3, 10_000, 1),
        Err(GeomError::Count(CountError::TooManyVertices { .. }))
    ));
}

#[test]
fn appended_meshes_lie_side_by_side() {
    let ball = tessellate(&sphere(DVec3::ZERO, 1.0), 1e-2, MOST).unwrap();
    let other = tessellate(&sphere(DVec3::X * 5.0, 1.0), 1e-2, MOST).unwrap();
    let both = Mesh::merged(&[ball.clone(), other.clone()], 1 << 20).unwrap();
    assert_eq!(both.n_triangles(), ball.n_triangles() + other.n_triangles());
    assert!((both.volume() - ball.volume() - other.volume()).abs() < 1e-12);
}

/// Every triangle is counter-clockwise seen from the side of its corners' normals.
#[track_caller]
fn check_facing(mesh: &Mesh) {
    assert!(!mesh.triangles().is_empty());
    for (triangle, [a, b, c]) in mesh.triangles().iter().zip(mesh.corners()) {
        let facing = (b - a).cross(c - a);
        for &corner in triangle {
            assert!(0.0 < facing.dot(mesh.normals()[corner as usize]), "triangle {triangle:?}");
        }
    }
}

#[test]
fn triangles_face_their_normals() {
    let ball = sphere(DVec3::ZERO, 1.0);
    check_facing(&grid_mesh(&ball, 9, 7, MOST, 1).unwrap());
    check_facing(&tessellate(&ball, 1e-2, MOST).unwrap());
}

proptest! {
    /// However much wider than the ring the tolerance is.
    #[test]
    fn a_flat_ring_does_not_fold(
        inner in 0.1..1.99_f64,
        sweep in 0.1..6.2_f64,
        tolerance in 0.01..2.0_f64,
    ) {
        let radius = NurbsCurve::line(DVec3::X * inner, DVec3::X * 2.0).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        let ring = NurbsSurface::revolved(&radius, axis, sweep).unwrap();
        check_facing(&tessellate(&ring, tolerance, MOST).unwrap());
    }
}

/// Inner corners lie halfway between outer ones, and the outer chords within the inner circle.
#[test]
fn narrow_rings_do_not_fold() {
    for (inner, sweep, tolerance) in
        [(1.96, 4.65, 0.105), (1.9435, 1.56, 0.187), (1.9999, 6.2, 2.0)]
    {
        let radius = NurbsCurve::line(DVec3::X * inner, DVec3::X * 2.0).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        let ring = NurbsSurface::revolved(&radius, axis, sweep).unwrap();
        check_facing(&tessellate(&ring, tolerance, MOST).unwrap());
    }
}

/// At its last corner Su × Sv is (c - 1)² - (c - 2)², which is negative below c = 3/2: there it folds, however small cells are.
#[test]
fn a_corner_that_folds_by_itself_is_cut_no_finer_for_it() {
    for c in [1.55, 1.5, 1.49, 1.48, 1.45] {
        let corner = |i: usize, j: usize| DVec4::new(i as f64, j as f64, 0.0, 1.0);
        let last = DVec4::new(c, c, 0.0, 1.0);
        let net = Grid::from_fn(3, 3, |i, j| if (i, j) == (2, 2) { last } else { corner(i, j) });
        let knots = [(); 2].map(|()| KnotVector::uniform_clamped(2, 3, 1.0).unwrap());
        let [knots_u, knots_v] = knots;
        let patch = NurbsSurface::new(knots_u, knots_v, net).unwrap();
        assert!(tessellate(&patch, 0.01, 10_000).is_ok(), "{c}");
    }
}

#[test]
fn vertices_that_no_triangle_uses_are_left_out() {
    let mesh = grid_mesh(&sphere(DVec3::ZERO, 1.0), 9, 7, MOST, 1).unwrap();
    let mut is_used = vec![false; mesh.n_vertices()];
    mesh.triangles().iter().flatten().for_each(|&corner| is_used[corner as usize] = true);
    assert!(is_used.into_iter().all(|is_used| is_used));
    assert_eq!((mesh.normals().len(), mesh.uvs().len()), (mesh.n_vertices(), mesh.n_vertices()));
}

/// The image of a star about the origin, corner k at radius `radii[k]`, and the area of the star.
fn star(radii: &[f64], map: DAffine3) -> (Vec<DVec3>, f64) {
    let step = 2.0 * PI / radii.len() as f64;
    let flat = |(k, r): (usize, &f64)| {
        let angle = step * k as f64;
        DVec3::new(r * libm::cos(angle), r * libm::sin(angle), 0.0)
    };
    let places: Vec<DVec3> = radii.iter().enumerate().map(flat).collect();
    let area: f64 =
        (0..places.len()).map(|k| 0.5 * places[k].cross(places[(k + 1) % places.len()]).z).sum();
    (places.into_iter().map(|place| map.transform_point3(place)).collect(), area)
}

proptest! {
    #[test]
    fn the_triangles_of_a_face_cover_it_once(
        radii in proptest::collection::vec(0.2..3.0_f64, 3..24),
        turn in 0.0..6.0_f64,
        at in -50.0..50.0_f64,
    ) {
        let map = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), turn);
        let map = DAffine3::from_translation(DVec3::new(at, -at, 2.0)) * map;
        let (vertices, area) = star(&radii, map);
        let face: Vec<usize> = (0..vertices.len()).collect();
        let mesh = polygon_mesh(vertices, &[face], MOST).unwrap();
        prop_assert!((mesh.area() - area).abs() <= 1e-11 * area, "{} is not {area}", mesh.area());
        prop_assert_eq!(mesh.faces().collect::<Vec<_>>(), vec![(0..radii.len() as u32).collect::<Vec<_>>()]);
        let turned = mesh.transformed(&DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0)));
        let mut back = turned.faces().next().unwrap();
        back[1..].reverse();
        prop_assert_eq!(back, (0..radii.len() as u32).collect::<Vec<_>>());
    }
}
