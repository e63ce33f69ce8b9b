//! Laws of meshes within a tolerance: nothing is further away than asked for, nothing is missed,
//! nothing is torn.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;
use proptest::{prop_assert, proptest};
use virote_kernel::{
    Axis, Direction, Face, FacePart, Frame, GeomError, Grid, InputError, KnotVector, Mesh,
    NurbsCurve, NurbsSurface, Surface, TessellationOptions, Tolerance, distance_to_polyline,
    tessellate, tessellate_all, tessellate_finely,
    work::{self, MemoryGauge, StopToken, Watch},
};

use crate::some::{point, sphere};

const MOST: usize = 1_000_000;

/// How far triangles are from the surface, and the surface from the triangles, at many places.
fn deviation(surface: &NurbsSurface, mesh: &Mesh) -> f64 {
    let step = (mesh.n_triangles() / 100).max(1);
    let places = [[0.5, 0.5], [0.0, 0.5], [0.5, 0.0], [0.33, 0.33], [0.1, 0.2], [0.7, 0.2]];
    let on_mesh = mesh.corners().step_by(step).flat_map(|[a, b, c]| {
        places.map(|[x, y]| surface.closest(a + (b - a) * x + (c - a) * y).distance)
    });
    let (us, vs) = (surface.domain_u().steps(23), surface.domain_v().steps(19));
    let points = surface.points_on_grid(&us, &vs);
    let on_surface = points.iter().map(|&point| mesh.distance_to(point).unwrap());
    on_mesh.chain(on_surface).fold(0.0, f64::max)
}

#[track_caller]
fn check(surface: &NurbsSurface, tolerance: f64) -> Mesh {
    let mesh = tessellate(surface, tolerance, MOST).unwrap();
    let found = deviation(surface, &mesh);
    assert!(found <= tolerance, "{found} is more than {tolerance}");
    mesh
}

/// Every triangle has an area and every normal is a unit vector.
#[track_caller]
fn check_parts(mesh: &Mesh) {
    assert_eq!(mesh.normals().len(), mesh.n_vertices());
    assert!(mesh.normals().iter().all(|normal| (normal.length() - 1.0).abs() < 1e-9));
    for [a, b, c] in mesh.corners() {
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let height = (b - a).cross(c - a).length() / longest;
        assert!(1e-9 * longest < height, "the triangle {a} {b} {c} has no area");
    }
}

fn wave(n: usize) -> NurbsSurface {
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    let net = Grid::from_fn(n, n, |i, j| {
        let (x, y) = (i as f64 / (n - 1) as f64, j as f64 / (n - 1) as f64);
        DVec3::new(10.0 * x, 10.0 * y, libm::sin(9.0 * x) * libm::cos(7.0 * y))
    });
    NurbsSurface::polynomial(knots.clone(), knots, &net).unwrap()
}

/// A net of 40 × 40 in the plane with one point above it.
fn bump() -> NurbsSurface {
    let knots = KnotVector::uniform_clamped(3, 40, 1.0).unwrap();
    let net = Grid::from_fn(40, 40, |i, j| {
        DVec3::new(i as f64, j as f64, if (i, j) == (21, 17) { 3.0 } else { 0.0 })
    });
    NurbsSurface::polynomial(knots.clone(), knots, &net).unwrap()
}

#[test]
fn the_triangles_keep_to_the_tolerance_they_were_asked_for() {
    check_parts(&check(&sphere(DVec3::ZERO, 10.0), 0.02));
    check_parts(&check(&NurbsSurface::torus(Frame::XY, 5.0, 2.0).unwrap(), 0.02));
    check_parts(&check(&wave(9), 0.01));
}

#[test]
fn t1_an_isolated_bump_is_found_at_its_height() {
    let mesh = check(&bump(), 0.1);
    let top = mesh.vertices().iter().map(|vertex| vertex.z).fold(0.0, f64::max);
    assert!((top - 4.0 / 3.0).abs() < 0.1, "{top}");
    // Most of it is a plane, which takes few triangles.
    assert!(mesh.n_triangles() < 8000, "{}", mesh.n_triangles());
}

#[test]
fn a_flat_part_beside_a_bump_needs_its_corners_only() {
    let corners = [[0.45, 0.6], [0.62, 0.6], [0.62, 0.9], [0.45, 0.9]];
    let [a, b, c, d] = corners.map(|[u, v]| DVec3::new(u, v, 0.0));
    let sides = [(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| NurbsCurve::line(from, to));
    let loops = vec![sides.into_iter().collect::<Result<Vec<_>, _>>().unwrap()];
    let face = Face::of_parts(Arc::new(bump()), &[FacePart { loops }], Tolerance::DEFAULT);
    let mesh = face.unwrap().mesh(&TessellationOptions::within(1e-4), MOST).unwrap();
    assert_eq!(mesh.n_triangles(), 2);
}

#[test]
fn t4_poles_have_no_triangles_without_area() {
    let ball = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    check_parts(&check(&ball, 1e-2));
    let cone = NurbsSurface::cone(Frame::XY, [2.0, 0.0], 3.0).unwrap();
    check_parts(&check(&cone, 1e-2));
}

#[test]
fn t5_the_area_of_a_thin_sliver_converges() {
    // Twenty times as long as wide, over a parabola: the area of z = x² / 20 over [0, 20] × [0, 1].
    let net = [0.0, 10.0, 20.0].map(|x| [0.0, 1.0].map(|y| (x, y)));
    let net = Grid::from_fn(3, 2, |i, j| {
        DVec3::new(net[i][j].0, net[i][j].1, if i == 2 { 20.0 } else { 0.0 })
    });
    let sliver = NurbsSurface::bezier(&net).unwrap();
    let slope = 2.0_f64;
    let length = 10.0 / 2.0 * (slope * (1.0 + slope * slope).sqrt() + libm::asinh(slope));
    let errors = [0.1, 0.01, 0.001].map(|tolerance| length - check(&sliver, tolerance).area());
    assert!(errors.iter().all(|&error| 0.0 <= error), "{errors:?}");
    assert!(errors[1] < 0.2 * errors[0] && errors[2] < 0.2 * errors[1], "{errors:?}");
}

#[test]
fn t6_closed_surfaces_have_their_euler_numbers() {
    let euler = |surface: &NurbsSurface| {
        let check = check(surface, 0.05).check(Tolerance::DEFAULT);
        assert!(check.is_closed && check.is_manifold && check.is_oriented);
        assert_eq!(check.degenerate, 0);
        check.euler
    };
    assert_eq!(euler(&NurbsSurface::sphere(Frame::XY, 3.0).unwrap()), 2);
    assert_eq!(euler(&NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap()), 0);
}

#[test]
fn planes_need_their_corners_only() {
    let corners = |p: [[f64; 2]; 4]| p.map(|[x, y]| DVec3::new(x, y, 2.0 * x - y));
    let n = |[a, b, c, d]: [DVec3; 4], tolerance: f64| {
        let plane = NurbsSurface::bilinear(a, b, c, d).unwrap();
        tessellate(&plane, tolerance, MOST).unwrap().n_triangles()
    };
    assert_eq!(n(corners([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]]), 1e-9), 2);
    // The middle of a trapezoid is not where that of its triangles is, but in its plane.
    assert_eq!(n(corners([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [2.0, 1.0]]), 1e-9), 2);
}

#[test]
fn weights_that_differ_much_hide_nothing() {
    let weights = [1.0, 100.0, 1.0, 7.0, 50.0, 1.0, 3.0, 100.0, 20.0];
    let net =
        Grid::from_fn(3, 3, |i, j| DVec3::new(i as f64, j as f64, ((2 * i + 3 * j) % 4) as f64));
    let knots = KnotVector::bezier(2).unwrap();
    let weights = Grid::new(3, 3, weights.to_vec()).unwrap();
    check(&NurbsSurface::rational(knots.clone(), knots, &net, &weights).unwrap(), 0.01);
}

#[test]
fn no_edge_is_longer_than_asked_for() {
    for max_edge in [0.3, 1.0] {
        let limits = TessellationOptions { max_edge, ..TessellationOptions::within(0.1) };
        let mesh = tessellate_finely(&wave(9), &limits, MOST).unwrap();
        for [a, b, c] in mesh.corners() {
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            assert!(longest <= max_edge, "{longest} is more than {max_edge}");
        }
    }
}

#[test]
fn the_normal_turns_no_further_than_asked_for() {
    for degrees in [5.0, 15.0] {
        let angle = degrees * PI / 180.0;
        let limits = TessellationOptions { angle, ..TessellationOptions::within(1.0) };
        for surface in [wave(9), NurbsSurface::torus(Frame::XY, 5.0, 2.0).unwrap()] {
            let mesh = tessellate_finely(&surface, &limits, MOST).unwrap();
            let normals = mesh.normals();
            for &[a, b, c] in mesh.triangles() {
                let [a, b, c] = [a, b, c].map(|i| normals[i as usize]);
                let turn = a.angle_between(b).max(b.angle_between(c)).max(c.angle_between(a));
                assert!(turn <= angle + 1e-9, "{turn} is more than {angle}");
            }
        }
    }
}

#[test]
fn meshes_are_the_same_for_any_number_of_threads() {
    let near: Vec<Surface> = (0..5)
        .map(|i| wave(4 + i))
        .chain([NurbsSurface::torus(Frame::XY, 5.0, 2.0).unwrap(), sphere(DVec3::ZERO, 3.0)])
        .map(Surface::from)
        .collect();
    for surfaces in [&near[..], &near[..1], &near[5..6]] {
        for angle in [0.2, PI] {
            let of = |n_threads| {
                let limits =
                    TessellationOptions { angle, n_threads, ..TessellationOptions::within(0.01) };
                let meshes = tessellate_all(surfaces, &limits, MOST).unwrap();
                let bits = |v: &DVec3| v.to_array().map(f64::to_bits);
                let of_mesh = |mesh: &Mesh| {
                    let points: Vec<_> = mesh.vertices().iter().map(bits).collect();
                    let normals: Vec<_> = mesh.normals().iter().map(bits).collect();
                    (points, normals, mesh.triangles().to_vec())
                };
                meshes.iter().map(of_mesh).collect::<Vec<_>>()
            };
            let alone = of(1);
            assert!(alone == of(2) && alone == of(7));
        }
    }
}

#[test]
fn limits_that_allow_nothing_are_refused() {
    let ball = sphere(DVec3::ZERO, 1.0);
    let limits = TessellationOptions::within(0.1);
    for limits in [
        TessellationOptions { tolerance: 0.0, ..limits },
        TessellationOptions { tolerance: f64::INFINITY, ..limits },
        TessellationOptions { tolerance: f64::NAN, ..limits },
        TessellationOptions { angle: -1.0, ..limits },
        TessellationOptions { angle: f64::NAN, ..limits },
        TessellationOptions { max_edge: 0.0, ..limits },
        TessellationOptions { max_edge: f64::NAN, ..limits },
    ] {
        let refused = tessellate_finely(&ball, &limits, MOST);
        assert!(
            matches!(refused, Err(GeomError::Input(InputError::NotPositive { .. }))),
            "{limits:?}"
        );
    }
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(16))]

    #[test]
    fn bilinear_surfaces_keep_to_their_tolerance(a in point(), b in point(), c in point(), d in point()) {
        let surface = NurbsSurface::bilinear(a, b, c, d).unwrap();
        let mesh = tessellate(&surface, 0.1, MOST).unwrap();
        let found = deviation(&surface, &mesh);
        prop_assert!(found <= 0.1, "{found}");
    }
}

/// The patches of the Utah teapot.
fn teapot() -> Vec<NurbsSurface> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/teapot.bpt");
    let text = std::fs::read_to_string(path).unwrap();
    let numbers = |line: &str| -> Vec<f64> {
        line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
    };
    let points: Vec<DVec3> = text
        .lines()
        .map(numbers)
        .filter(|numbers| numbers.len() == 3)
        .map(|numbers| DVec3::new(numbers[0], numbers[1], numbers[2]))
        .collect();
    let patch = |net: &[DVec3]| NurbsSurface::bezier(&Grid::new(4, 4, net.to_vec()).unwrap());
    points.chunks(16).map(|net| patch(net).unwrap()).collect()
}

fn meshed(surfaces: &[NurbsSurface], limits: &TessellationOptions) -> Mesh {
    let surfaces: Vec<Surface> = surfaces.iter().cloned().map(Surface::from).collect();
    let meshes = tessellate_all(&surfaces, limits, MOST).unwrap();
    for (surface, mesh) in surfaces.iter().zip(&meshes) {
        let Surface::Nurbs(surface) = surface else { continue };
        let found = deviation(surface, mesh);
        assert!(found <= limits.tolerance, "{found} is more than {}", limits.tolerance);
    }
    let mesh = Mesh::merged(&meshes, MOST).unwrap();
    check_parts(&mesh);
    mesh
}

/// The sides without a neighbour.
fn boundary(mesh: &Mesh) -> Vec<[DVec3; 2]> {
    let topology = mesh.topology(Tolerance::DEFAULT);
    let place = |vertex: u32| mesh.vertices()[vertex as usize];
    topology.boundary().iter().map(|ends| ends.map(place)).collect()
}

/// As smooth a surface with other degrees, knots and parameters, of which every edge is the same
/// curve.
fn rewritten(surface: &NurbsSurface) -> NurbsSurface {
    let degrees = [surface.degree_u() + 2, surface.degree_v() + 1];
    let elevated = surface.elevate_degree(Direction::U, degrees[0]).unwrap();
    let elevated = elevated.elevate_degree(Direction::V, degrees[1]).unwrap();
    let refined = elevated.insert_knots(Direction::U, &[0.3]).unwrap();
    refined.insert_knots(Direction::V, &[0.7]).unwrap()
}

#[test]
fn t2_the_teapot_is_open_only_where_its_patches_are() {
    let mesh = meshed(&teapot(), &TessellationOptions::within(0.1));
    let check = mesh.check(Tolerance::DEFAULT);
    assert_eq!(check.degenerate, 0);
    // Its parts, body with lid and bottom, handle and spout, are open at their rims only.
    let patches = teapot();
    let edges: Vec<[DVec3; 3]> = patches
        .iter()
        .flat_map(NurbsSurface::edges)
        .map(|edge| [0.0, 0.5, 1.0].map(|t| edge.point_at(t)))
        .collect();
    let is_near = |a: &DVec3, b: DVec3| a.distance(b) < 1e-6;
    let is_same = |a: &[DVec3; 3], b: &[DVec3; 3]| {
        is_near(&a[1], b[1])
            && (is_near(&a[0], b[0]) && is_near(&a[2], b[2])
                || is_near(&a[0], b[2]) && is_near(&a[2], b[0]))
    };
    let is_point = |edge: &[DVec3; 3]| is_near(&edge[0], edge[1]) && is_near(&edge[0], edge[2]);
    let free: Vec<&[DVec3; 3]> = edges
        .iter()
        .filter(|edge| {
            !is_point(edge) && edges.iter().filter(|other| is_same(edge, other)).count() == 1
        })
        .collect();
    assert_eq!(free.len(), 20);
    let open = boundary(&mesh);
    for edge in &free {
        assert!(open.iter().flatten().any(|&place| is_near(&edge[0], place)));
    }
    let lengths: f64 = open.iter().map(|[a, b]| a.distance(*b)).sum();
    let whole: f64 = patches
        .iter()
        .flat_map(NurbsSurface::edges)
        .filter(|edge| {
            let places = [0.0, 0.5, 1.0].map(|t| edge.point_at(t));
            free.iter().any(|free| is_same(free, &places))
        })
        .map(|edge| edge.length(edge.domain()))
        .sum();
    assert!(lengths <= whole && 0.95 * whole < lengths, "{lengths} of {whole}");
}

#[test]
fn t3_patches_written_otherwise_open_no_crack() {
    let limits = TessellationOptions::within(0.1);
    let original = boundary(&meshed(&teapot(), &limits));
    let mut patches = teapot();
    for patch in patches.iter_mut().step_by(2) {
        *patch = rewritten(patch);
    }
    let open = boundary(&meshed(&patches, &limits));
    let legs: Vec<DVec3> = original.iter().flatten().copied().collect();
    for place in open.iter().flatten() {
        let near = legs.chunks(2).map(|leg| distance_to_polyline(*place, leg).unwrap());
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 0.1, "{place} is {near} from where the teapot is open");
    }
    let length = |open: &[[DVec3; 2]]| open.iter().map(|[a, b]| a.distance(*b)).sum::<f64>();
    assert!((length(&open) / length(&original) - 1.0).abs() < 0.02);
}

#[test]
fn surfaces_whose_edge_runs_at_another_pace_share_its_vertices() {
    let height = |i: usize, j: usize| ((3 * i + 2 * j) % 5) as f64;
    let net = |first: usize| {
        Grid::from_fn(4, 4, |i, j| DVec3::new((first + i) as f64, j as f64, height(first + i, j)))
    };
    let left = NurbsSurface::bezier(&net(0)).unwrap();
    // Weights in a geometric sequence change the pace alone, and the rewriting the rest.
    let knots = KnotVector::bezier(3).unwrap();
    let weights = Grid::from_fn(4, 4, |_, j| [1.0, 3.0, 9.0, 27.0][j]);
    let right = NurbsSurface::rational(knots.clone(), knots, &net(3), &weights).unwrap();
    let right = rewritten(&right).reversed(Direction::V).swapped();
    let mesh = meshed(&[left, right], &TessellationOptions::within(0.01));
    let check = mesh.check(Tolerance::DEFAULT);
    assert_eq!((check.boundaries, check.components), (1, 1));
    let is_on_edge = |[a, b]: &[DVec3; 2]| [a, b].iter().all(|end| (end.x - 3.0).abs() < 1e-9);
    assert!(!boundary(&mesh).iter().any(is_on_edge));
    // Not only near: the same numbers.
    let on_edge = mesh.vertices().iter().filter(|vertex| (vertex.x - 3.0).abs() < 1e-9);
    let mut places: Vec<[u64; 3]> =
        on_edge.map(|vertex| vertex.to_array().map(f64::to_bits)).collect();
    places.sort_unstable();
    assert!(places.chunk_by(|a, b| a == b).all(|alike| 2 <= alike.len()));
}

#[test]
fn an_edge_alone_is_divided_as_beside_its_neighbour() {
    let arc = |radius: f64, z: f64| NurbsCurve::arc(Frame::XY.at(DVec3::Z * z), radius, 0.0, PI);
    let strip = |low: f64, high: f64| {
        NurbsSurface::ruled(&arc(2.0, low).unwrap(), &arc(2.0, high).unwrap()).unwrap()
    };
    let limits = TessellationOptions::within(0.001);
    let (low, high) = (strip(0.0, 1.0), strip(1.0, 3.0));
    let alone = tessellate_finely(&low, &limits, MOST).unwrap();
    let both = meshed(&[low, high], &limits);
    let on_edge = |mesh: &Mesh| -> Vec<DVec3> {
        mesh.vertices().iter().copied().filter(|vertex| (vertex.z - 1.0).abs() < 1e-12).collect()
    };
    let alone = on_edge(&alone);
    assert!(20 < alone.len());
    assert!(
        on_edge(&both).iter().all(|place| alone.iter().any(|other| place.distance(*other) < 1e-9))
    );
}

#[test]
fn t7_a_crease_is_a_chain_of_edges_with_a_normal_for_each_side() {
    let roof = [0.0, 1.0, 2.0, 3.0, 4.0].map(|x: f64| (x, 2.0 - (x - 2.0).abs()));
    let net = Grid::from_fn(5, 3, |i, j| DVec3::new(roof[i].0, j as f64, roof[i].1));
    let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0]).unwrap();
    let roof = NurbsSurface::polynomial(knots, KnotVector::bezier(2).unwrap(), &net).unwrap();
    let mesh = check(&roof, 1e-6);
    let ridge: Vec<usize> =
        (0..mesh.n_vertices()).filter(|&i| (mesh.vertices()[i].x - 2.0).abs() < 1e-12).collect();
    assert!(ridge.iter().all(|&i| (mesh.normals()[i].z - 0.5_f64.sqrt()).abs() < 1e-9));
    let leaning = |sign: f64| ridge.iter().filter(|&&i| 0.0 < sign * mesh.normals()[i].x).count();
    assert_eq!(leaning(1.0), leaning(-1.0));
    // No triangle reaches over the ridge.
    for corners in mesh.corners() {
        let sides = corners.map(|corner| corner.x - 2.0);
        let is_over = |sign: f64| sides.iter().any(|&side| 1e-9 < sign * side);
        assert!(!(is_over(1.0) && is_over(-1.0)));
    }
    let check = mesh.check(Tolerance::DEFAULT);
    assert_eq!((check.boundaries, check.components), (1, 1));
}

#[test]
fn faces_of_a_body_make_a_closed_mesh() {
    let frame = |z: f64| Frame::XY.at(DVec3::Z * z);
    let side = NurbsSurface::cone(frame(0.0), [2.0, 1.0], 3.0).unwrap();
    let cap = |radius: f64, z: f64| {
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        let leg = NurbsCurve::polyline(&[DVec3::new(radius, 0.0, z), DVec3::Z * z]).unwrap();
        NurbsSurface::revolved(&leg, axis, 2.0 * PI).unwrap()
    };
    let faces = [cap(2.0, 0.0).reversed(Direction::U), side, cap(1.0, 3.0)];
    let check = meshed(&faces, &TessellationOptions::within(0.01)).check(Tolerance::DEFAULT);
    assert!(check.is_closed && check.is_manifold && check.is_oriented, "{check:?}");
    assert_eq!(check.euler, 2);
}

#[test]
fn a_disc_needs_its_border_only() {
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    let leg = NurbsCurve::polyline(&[DVec3::X, DVec3::ZERO]).unwrap();
    let disc = NurbsSurface::revolved(&leg, axis, 2.0 * PI).unwrap();
    let mesh = tessellate(&disc, 1e-6, MOST).unwrap();
    // A leg of a polygon with n corners misses the circle by π² / 2n².
    assert!(mesh.n_triangles() < 20_000, "{}", mesh.n_triangles());
    assert!((mesh.area() - PI).abs() < 1e-5);
}

#[test]
fn a_mesh_ends_in_the_middle_of_its_rows() {
    let surface = wave(9);
    let meshed = |steps: u64| {
        let (gauge, stop) = (MemoryGauge::default(), StopToken::default());
        let watch = Watch { gauge, memory_bytes: usize::MAX, stop, steps };
        work::under(watch, || tessellate(&surface, 1e-4, MOST))
    };
    let (mesh, done) = meshed(u64::MAX);
    check_parts(&mesh.unwrap());
    // Not only before the rows of triangles, which come last.
    let (ended, _) = meshed(done.steps - 64);
    assert!(matches!(ended, Err(GeomError::Ended)), "{ended:?}");
}

#[test]
fn lines_of_a_mesh_that_is_too_fine_are_not_all_laid() {
    // Each direction has fewer lines than a mesh may have vertices, and both together have far more.
    let ball = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    let (gauge, stop) = (MemoryGauge::default(), StopToken::default());
    let watch = Watch { gauge, memory_bytes: usize::MAX, stop, steps: 100_000 };
    let (ended, done) = work::under(watch, || tessellate(&ball, 1e-11, MOST));
    assert!(matches!(ended, Err(GeomError::Ended)), "{ended:?}");
    assert!(done.steps < 110_000, "it leaves at once");
}
