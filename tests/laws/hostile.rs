//! Whatever a constructor accepts can be asked anything: answers or errors, no panic and no hang.

use glam::{DAffine3, DVec3};
use proptest::{collection::vec, prelude::Strategy, proptest, sample::select};
use virote_kernel::{
    Curve, Grid, Interval, KnotVector, Mesh, NurbsCurve, NurbsSurface, Side, Tolerance, grid_mesh,
    make_compatible, tessellate, tessellate_curve,
};

fn number() -> impl Strategy<Value = f64> {
    let tame = [0.0, -0.0, 1.0, 1.0, 1.0, 2.0, 0.5, -1.0, 1e-13];
    let wild = [1e-300, 5e-324, 1e300, -1e300, 1e8, f64::NAN, f64::INFINITY];
    (select(tame.to_vec()), select(wild.to_vec()), 0..12u32)
        .prop_map(|(tame, wild, which)| if which == 0 { wild } else { tame })
}

/// Sorted most of the time, so that many are accepted.
fn numbers(n: usize) -> impl Strategy<Value = Vec<f64>> {
    (vec(number(), n), 0..8u32).prop_map(|(mut numbers, which)| {
        if which > 0 {
            numbers.sort_by(f64::total_cmp);
        }
        numbers
    })
}

fn points(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}

fn ask_shape(curve: &Curve) {
    let (domain, tolerance) = (curve.domain(), Tolerance::DEFAULT);
    for t in [domain.start(), domain.end(), domain.at(0.3), f64::NAN, 1e300, -1e300] {
        if let Ok(local) = curve.local_at(t, Side::Left) {
            let _ = (local.frame(), local.torsion(), local.osculating_circle());
            let _ = (local.normal_plane(), local.signed_curvature(DVec3::Z, tolerance.angle));
        }
        let _ = curve.place_kind_at(t, tolerance);
    }
    let _ = (curve.is_straight(tolerance), curve.is_planar(tolerance), curve.is_closed(1e-6));
    let _ = (curve.continuity(tolerance), curve.continuity_with(curve, tolerance));
}

fn ask_curve(curve: &NurbsCurve) {
    ask_shape(&curve.clone().into());
    let domain = curve.domain();
    for t in [domain.start(), domain.end(), domain.at(0.3), f64::NAN, 1e300, -1e300] {
        let _ = (curve.point_at(t), curve.derivatives_at(t, 4));
        let _ = (curve.tangent_at(t, Side::Left), curve.tangent_at(t, Side::Right));
        let _ = (curve.split(t), curve.insert_knots(&[t, t]));
    }
    let _ = (curve.length(domain), curve.bounds(), curve.elevate_degree(curve.degree() + 2));
    let _ = (curve.decompose(), curve.clamped(), curve.trimmed(Interval::UNIT));
    let _ = (curve.reversed(), curve.reparametrized(Interval::UNIT).length(Interval::UNIT));
    let _ = tessellate_curve(curve, 1e-3, 1000);
    let _ = make_compatible(&[curve.clone(), curve.reversed()]);
    if let Ok(ruled) = NurbsSurface::ruled(curve, &curve.reversed()) {
        ask_surface(&ruled);
    }
}

fn ask_surface(surface: &NurbsSurface) {
    let (domain_u, domain_v) = (surface.domain_u(), surface.domain_v());
    for (u, v) in [(domain_u.start(), domain_v.end()), (domain_u.at(0.3), domain_v.at(0.5))] {
        let _ = (surface.point_at(u, v), surface.derivatives_at(u, v, 3));
        let _ = (surface.normal_at(u, v), surface.isocurve_u(u), surface.isocurve_v(v));
    }
    let _ = (surface.edges(), surface.bounds(), tessellate(surface, 1e-2, 1000));
    if let Ok(mesh) = grid_mesh(surface, 3, 2, 1000, 1) {
        let _ = (
            mesh.area(),
            mesh.volume(),
            mesh.bounds(),
            Mesh::merged(&[mesh.clone(), mesh.clone()], usize::MAX),
        );
        let _ = mesh.transformed(&DAffine3::from_scale(DVec3::new(1.0, 0.0, -1.0)));
    }
}

proptest! {
    #[test]
    fn curves_of_any_numbers(
        degree in 0..5usize, knots in numbers(11), places in vec(number(), 30), weights in vec(number(), 10),
    ) {
        let n_points = 10 - degree;
        if let Ok(knots) = KnotVector::for_points(degree, n_points, knots) {
            let points = &points(&places)[..n_points];
            let weights = &weights[..n_points];
            let curves = [
                NurbsCurve::polynomial(knots.clone(), points),
                NurbsCurve::rational(knots.clone(), points, weights),
                NurbsCurve::new(
                    knots,
                    points.iter().zip(weights).map(|(point, &weight)| point.extend(weight)).collect(),
                ),
            ];
            curves.iter().flatten().for_each(ask_curve);
        }
    }

    #[test]
    fn surfaces_of_any_numbers(
        degree in 0..3usize, knots in numbers(6), places in vec(number(), 75), weights in vec(number(), 25),
    ) {
        let n = 5 - degree;
        if let Ok(knots) = KnotVector::for_points(degree, n, knots) {
            let points = Grid::new(n, n, points(&places)[..n * n].to_vec()).unwrap();
            let weights = Grid::new(n, n, weights[..n * n].to_vec()).unwrap();
            let surfaces = [
                NurbsSurface::polynomial(knots.clone(), knots.clone(), &points),
                NurbsSurface::rational(knots.clone(), knots, &points, &weights),
            ];
            surfaces.iter().flatten().for_each(ask_surface);
        }
    }

    #[test]
    fn meshes_of_any_numbers(places in vec(number(), 9), normals in vec(number(), 9), i in 0..4u32) {
        let mesh = Mesh::new(points(&places), points(&normals), Vec::new(), vec![[0, 1, i], [2, 1, 0]]);
        if let Ok(mesh) = mesh {
            let _ = (mesh.check(Tolerance::DEFAULT), mesh.check_solid(Tolerance::DEFAULT));
            let _ = (mesh.area_centroid(), mesh.volume_centroid());
            let _ = mesh.with_colors(points(&normals));
        }
    }
}
