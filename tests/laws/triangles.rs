//! Laws of how many triangles meshes have, and of the promise that they keep all the same.

use std::f64::consts::PI;

use glam::DVec3;
use proptest::{collection::vec, prop_assert, proptest};
use virote_kernel::{
    DeviationReference, Frame, Grid, KnotVector, Mesh, MeshDistance, NurbsSurface, Surface,
    tessellate,
};

const MOST: usize = 1_000_000;

/// How far the mesh is from the surface, and the surface from the mesh.
fn deviations(surface: &NurbsSurface, mesh: &Mesh) -> [f64; 2] {
    let surface = Surface::from(surface.clone());
    let of_mesh =
        mesh.deviation_from(&DeviationReference::of_surface(&surface).unwrap()).unwrap().unwrap();
    let nearest = DeviationReference::Mesh(MeshDistance::new(mesh).unwrap());
    [of_mesh.max, surface.deviation_from(&nearest).unwrap().max]
}

/// The mesh keeps to its tolerance with no more triangles than some times what equal cells take
/// along whose sides the surface bends alike; of the tolerance at least half is used.
#[track_caller]
fn check(surface: &NurbsSurface, tolerance: f64, needed: f64, margin: f64) {
    let mesh = tessellate(surface, tolerance, MOST).unwrap();
    let found = deviations(surface, &mesh);
    assert!(found.iter().all(|found| *found <= tolerance), "{found:?}");
    assert!(0.5 * tolerance < found[0], "{found:?}");
    let most = margin * needed;
    assert!((mesh.n_triangles() as f64) < most, "{} of {most}", mesh.n_triangles());
}

#[test]
fn a_cylinder_is_one_row_of_triangles() {
    let tube = NurbsSurface::cone(Frame::XY, [2.0, 2.0], 5.0).unwrap();
    let step = 2.0 * libm::acos(1.0 - 0.01 / 2.0);
    check(&tube, 0.01, 2.0 * 2.0 * PI / step, 1.3);
}

#[test]
fn a_sphere_has_few_more_triangles_than_its_cells_need() {
    // Square cells of side a at the equator are (a² + a²)·r / 8 away.
    let (radius, tolerance) = (10.0, 0.005);
    let cell = 4.0 * tolerance / radius;
    let ball = NurbsSurface::sphere(Frame::XY, radius).unwrap();
    check(&ball, tolerance, 2.0 * (2.0 * PI) * PI / cell, 1.35);
}

#[test]
fn a_torus_has_few_more_triangles_than_its_outside_needs() {
    // Outside the cells are (13·a² + 3·b²) / 8 away.
    let tolerance = 0.02;
    let cell = 4.0 * tolerance / (13.0_f64 * 3.0).sqrt();
    let ring = NurbsSurface::torus(Frame::XY, 10.0, 3.0).unwrap();
    check(&ring, tolerance, 2.0 * (2.0 * PI) * (2.0 * PI) / cell, 1.35);
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(12))]

    #[test]
    fn rational_surfaces_keep_to_their_tolerance_both_ways(
        noise in vec((-0.6..0.6, -0.6..0.6, -1.0..1.0, 0.2..5.0), 36),
        tolerance in 0.004..0.5,
    ) {
        let knots = KnotVector::uniform_clamped(3, 6, 1.0).unwrap();
        let net = Grid::from_fn(6, 6, |i, j| {
            let (x, y, z, _) = noise[6 * i + j];
            DVec3::new(i as f64 + x, j as f64 + y, z)
        });
        let weights = Grid::from_fn(6, 6, |i, j| noise[6 * i + j].3);
        let surface = NurbsSurface::rational(knots.clone(), knots, &net, &weights).unwrap();
        let mesh = tessellate(&surface, tolerance, MOST).unwrap();
        let found = deviations(&surface, &mesh);
        prop_assert!(found.iter().all(|found| *found <= tolerance), "{found:?} at {tolerance}");
    }
}
