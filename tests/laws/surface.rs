//! Laws of surfaces.

use glam::DVec3;
use proptest::{prop_assert, prop_assume, proptest};
use virote_kernel::{CircleForm, NurbsCurve, NurbsSurface};

use crate::some::{affine_map, are_near, curve, fraction, parameter, point, sphere, surface};

fn place(surface: &NurbsSurface, f: f64, g: f64) -> (f64, f64) {
    (surface.domain_u().at(f), surface.domain_v().at(g))
}

proptest! {
    #[test]
    fn affine_invariance(s in surface(), map in affine_map(), f in fraction(), g in fraction()) {
        let (u, v) = place(&s, f, g);
        let moved = map.transform_point3(s.point_at(u, v));
        prop_assert!(are_near(s.transformed(&map).point_at(u, v), moved, 1e-12));
    }

    #[test]
    fn isocurves_lie_on_the_surface(s in surface(), f in fraction(), g in fraction()) {
        let (u, v) = place(&s, f, g);
        let point = s.point_at(u, v);
        prop_assert!(are_near(s.isocurve_u(u).point_at(v), point, 1e-13));
        prop_assert!(are_near(s.isocurve_v(v).point_at(u), point, 1e-13));
    }

    #[test]
    fn edges_are_the_isocurves_of_the_ends(s in surface(), f in fraction()) {
        let [u0, u1, v0, v1] = s.edges();
        let (u, v) = place(&s, f, f);
        let (us, vs) = (s.domain_u(), s.domain_v());
        prop_assert!(are_near(u0.point_at(v), s.point_at(us.start(), v), 1e-13));
        prop_assert!(are_near(u1.point_at(v), s.point_at(us.end(), v), 1e-13));
        prop_assert!(are_near(v0.point_at(u), s.point_at(u, vs.start()), 1e-13));
        prop_assert!(are_near(v1.point_at(u), s.point_at(u, vs.end()), 1e-13));
    }

    #[test]
    fn partial_derivatives_are_those_of_isocurves(s in surface(), f in fraction(), g in fraction()) {
        let (u, v) = place(&s, f, g);
        let derivatives = s.derivatives_at(u, v, 3);
        let along_u = s.isocurve_v(v).derivatives_at(u, 3);
        let along_v = s.isocurve_u(u).derivatives_at(v, 3);
        for k in 0..=3 {
            prop_assert!(are_near(derivatives.get(k, 0), along_u[k], 1e-9));
            prop_assert!(are_near(derivatives.get(0, k), along_v[k], 1e-9));
        }
    }

    #[test]
    fn the_twist_is_the_limit_of_a_difference_quotient(s in surface(), f in 0.1..0.9, g in 0.1..0.9) {
        let span_u = s.knots_u().span_interval(s.knots_u().span_at(s.domain_u().at(f)));
        let span_v = s.knots_v().span_interval(s.knots_v().span_at(s.domain_v().at(g)));
        let (u, v, h) = (span_u.at(0.1 + 0.8 * f), span_v.at(g), 1e-5 * span_u.length());
        let along_v = |u: f64| s.derivatives_at(u, v, 1).get(0, 1);
        let quotient = (along_v(u + h) - along_v(u - h)) / (2.0 * h);
        let derivatives = s.derivatives_at(u, v, 3);
        let scale = 1.0 + derivatives.get(1, 1).length() + derivatives.get(3, 1).length()
            + along_v(u).length() / span_u.length();
        prop_assert!(derivatives.get(1, 1).distance(quotient) < 1e-7 * scale);
    }

    #[test]
    fn a_ruled_surface_runs_between_its_curves(a in curve(), b in curve(), f in fraction(), g in fraction()) {
        let ruled = NurbsSurface::ruled(&a, &b).unwrap();
        let u = ruled.domain_u().at(f);
        let (from, to) = (a.point_at(parameter(&a, f)), b.point_at(parameter(&b, f)));
        prop_assert!(are_near(ruled.point_at(u, 0.0), from, 1e-10));
        prop_assert!(are_near(ruled.point_at(u, 1.0), to, 1e-10));
        let between = ruled.point_at(u, g);
        prop_assert!((between - from).cross(to - from).length() < 1e-8);
        if !a.is_rational() && !b.is_rational() {
            prop_assert!(are_near(between, from.lerp(to, g), 1e-10));
        }
    }

    #[test]
    fn a_bilinear_surface_is_its_formula(corners in [point(), point(), point(), point()], u in fraction(), v in fraction()) {
        let [p00, p01, p10, p11] = corners;
        let surface = NurbsSurface::bilinear(p00, p01, p10, p11).unwrap();
        let formula = p00 * (1.0 - u) * (1.0 - v) + p01 * (1.0 - u) * v + p10 * u * (1.0 - v) + p11 * u * v;
        prop_assert!(are_near(surface.point_at(u, v), formula, 1e-14));
    }

    #[test]
    fn a_grid_has_the_points_and_normals_of_each_place(s in surface(), n in 1..7usize, m in 1..7usize) {
        let (us, vs) = (s.domain_u().steps(n), s.domain_v().steps(m));
        let points = s.points_on_grid(&us, &vs);
        let samples = s.samples_on_grid(&us, &vs, 2);
        for (i, &u) in us.iter().enumerate() {
            for (j, &v) in vs.iter().enumerate() {
                let point = s.point_at(u, v);
                prop_assert!(are_near(points.get(i, j), point, 1e-13));
                prop_assert!(are_near(samples.points.get(i, j), point, 1e-13));
                let normal = samples.normals.get(i, j);
                prop_assert!((normal.length() - 1.0).abs() < 1e-14);
                let derivatives = s.derivatives_at(u, v, 1);
                let product = derivatives.get(1, 0).cross(derivatives.get(0, 1));
                let size = derivatives.get(1, 0).length() * derivatives.get(0, 1).length();
                prop_assert!((normal * product.length()).distance(product) < 1e-12 * size);
            }
        }
    }

    #[test]
    fn normals_are_unit_and_normal(s in surface(), f in fraction(), g in fraction()) {
        let (u, v) = place(&s, f, g);
        let derivatives = s.derivatives_at(u, v, 1);
        let (su, sv) = (derivatives.get(1, 0), derivatives.get(0, 1));
        prop_assume!(su.cross(sv).length() > 1e-3 * su.length() * sv.length());
        let normal = s.normal_at(u, v).unwrap();
        prop_assert!((normal.length() - 1.0).abs() < 1e-14);
        prop_assert!(normal.dot(su).abs() < 1e-11 * su.length());
        prop_assert!(normal.dot(sv).abs() < 1e-11 * sv.length());
        prop_assert!(normal.dot(su.cross(sv)) > 0.0);
    }
}

#[test]
fn the_normals_of_a_sphere_point_outward_also_at_its_poles() {
    let center = DVec3::new(10.0, -20.0, 30.0);
    let sphere = sphere(center, 2.0);
    for i in 0..=40 {
        for j in 0..=40 {
            let (u, v) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
            let outward = (sphere.point_at(u, v) - center) / 2.0;
            let normal = sphere.normal_at(u, v).unwrap();
            assert!(normal.distance(outward) < 1e-12, "({u}, {v}): {normal} {outward}");
        }
    }
}

#[test]
fn a_fan_has_normals_where_its_edge_is_a_point() {
    let arc = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, CircleForm::NinePoint);
    let apex = NurbsCurve::bezier(&[DVec3::Z]).unwrap();
    let cone = NurbsSurface::ruled(&arc.unwrap(), &apex).unwrap();
    for i in 0..=30 {
        let u = f64::from(i) / 30.0;
        let below = cone.normal_at(u, 0.5).unwrap();
        assert!(cone.normal_at(u, 1.0).unwrap().distance(below) < 1e-12);
    }
}

#[test]
fn a_point_of_a_surface_has_no_normal() {
    let surface = NurbsSurface::bilinear(DVec3::ONE, DVec3::ONE, DVec3::ONE, DVec3::ONE).unwrap();
    assert!(surface.normal_at(0.5, 0.5).is_err());
    let samples = surface.samples_on_grid(&[0.0, 0.5], &[0.5], 1);
    assert!(samples.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-15));
}
