//! Laws of the curvature of surfaces.

use glam::{DAffine3, DQuat, DVec3};
use proptest::{prop_assert, prop_assume, proptest};
use virote_kernel::{Grid, NurbsSurface, Surface, SurfaceShape, Tolerance};

use crate::some::{fraction, point, sphere, surface};

/// A place of a surface where its tangents span a plane: its shape, and how large curvatures could
/// be for the size of the derivatives.
fn shape_and_size(s: &NurbsSurface, u: f64, v: f64) -> Option<(SurfaceShape, f64)> {
    let d = s.derivatives_at(u, v, 2);
    let (su, sv) = (d.get(1, 0), d.get(0, 1));
    let sine = su.cross(sv).length() / (su.length() * sv.length());
    if sine.is_nan() || sine < 1e-2 {
        return None;
    }
    let seconds = [
        d.get(2, 0).length() / su.length_squared(),
        d.get(1, 1).length() / (su.length() * sv.length()),
        d.get(0, 2).length() / sv.length_squared(),
    ];
    let size = seconds.into_iter().fold(0.0, f64::max) / (sine * sine);
    Some((Surface::from(s.clone()).shape_at(u, v).unwrap(), size))
}

fn swapped(s: &NurbsSurface) -> NurbsSurface {
    let (points, weights) = (s.points().transposed(), s.weights().transposed());
    NurbsSurface::rational(s.knots_v().clone(), s.knots_u().clone(), &points, &weights).unwrap()
}

proptest! {
    #[test]
    fn rigid_motions_keep_curvatures(
        s in surface(), f in fraction(), g in fraction(), axis in point(), angle in -3.0..3.0, by in point(),
    ) {
        prop_assume!(axis.length() > 0.1);
        let (u, v) = (s.domain_u().at(f), s.domain_v().at(g));
        let found = shape_and_size(&s, u, v);
        prop_assume!(found.is_some());
        let (shape, size) = found.unwrap();
        let turn = DQuat::from_axis_angle(axis.normalize(), angle);
        let map = DAffine3::from_rotation_translation(turn, by);
        let moved = Surface::from(s.transformed(&map)).shape_at(u, v).unwrap();
        prop_assert!((moved.gaussian() - shape.gaussian()).abs() < 1e-9 * size * size);
        prop_assert!((moved.mean() - shape.mean()).abs() < 1e-9 * size);
        prop_assert!(moved.normal().distance(turn * shape.normal()) < 1e-9);
    }

    #[test]
    fn orientation_turns_the_sign_of_curvatures_alone(s in surface(), f in fraction(), g in fraction()) {
        let (u, v) = (s.domain_u().at(f), s.domain_v().at(g));
        let found = shape_and_size(&s, u, v);
        prop_assume!(found.is_some());
        let (shape, size) = found.unwrap();
        let turned = Surface::from(swapped(&s)).shape_at(v, u).unwrap();
        prop_assert!((turned.gaussian() - shape.gaussian()).abs() < 1e-11 * size * size);
        prop_assert!((turned.mean() + shape.mean()).abs() < 1e-11 * size);
        let ([a, b], [c, d]) = (turned.curvatures(), shape.curvatures());
        prop_assert!((a + d).abs() < 1e-11 * size && (b + c).abs() < 1e-11 * size);
    }

    #[test]
    fn curvatures_shrink_as_the_surface_grows(s in surface(), f in fraction(), g in fraction(), by in 0.01..100.0) {
        let (u, v) = (s.domain_u().at(f), s.domain_v().at(g));
        let found = shape_and_size(&s, u, v);
        prop_assume!(found.is_some());
        let (shape, size) = found.unwrap();
        let grown = s.transformed(&DAffine3::from_scale(DVec3::splat(by)));
        let grown = Surface::from(grown).shape_at(u, v).unwrap();
        prop_assert!((grown.gaussian() * by * by - shape.gaussian()).abs() < 1e-11 * size * size);
        prop_assert!((grown.mean() * by - shape.mean()).abs() < 1e-11 * size);
    }

    #[test]
    fn normal_curvatures_follow_euler(s in surface(), f in fraction(), g in fraction(), angle in 0.0..7.0) {
        let (u, v) = (s.domain_u().at(f), s.domain_v().at(g));
        let found = shape_and_size(&s, u, v);
        prop_assume!(found.is_some());
        let (shape, size) = found.unwrap();
        let principal = shape.principal(Tolerance::DEFAULT);
        let (d1, d2) = (principal.d1, principal.d2);
        prop_assert!(d1.dot(d2).abs() < 1e-14 && (d1.length() - 1.0).abs() < 1e-14);
        prop_assert!(d1.cross(d2).distance(shape.normal()) < 1e-13);
        prop_assert!(principal.k1 <= principal.k2);
        let (sine, cosine) = libm::sincos(angle);
        let found = shape.normal_curvature(d1 * cosine + d2 * sine, Tolerance::DEFAULT).unwrap();
        let expected = principal.k1 * cosine * cosine + principal.k2 * sine * sine;
        prop_assert!((found - expected).abs() < 1e-9 * size);
    }

    /// Meusnier: a parameter line bends by the normal curvature of its direction.
    #[test]
    fn parameter_lines_bend_with_the_surface(s in surface(), f in fraction(), g in fraction()) {
        let (u, v) = (s.domain_u().at(f), s.domain_v().at(g));
        let found = shape_and_size(&s, u, v);
        prop_assume!(found.is_some());
        let (shape, size) = found.unwrap();
        let d = s.derivatives_at(u, v, 2);
        for (first, second) in [(d.get(1, 0), d.get(2, 0)), (d.get(0, 1), d.get(0, 2))] {
            let bending = second.dot(shape.normal()) / first.length_squared();
            let found = shape.normal_curvature(first, Tolerance::DEFAULT).unwrap();
            prop_assert!((found - bending).abs() < 1e-10 * size);
        }
    }

    #[test]
    fn a_sphere_bends_alike_everywhere_its_poles_included(
        center in point(), radius in 0.01..100.0, f in fraction(), g in fraction(),
    ) {
        let ball = Surface::from(sphere(center, radius));
        for v in [0.0, 0.05 + 0.9 * g, 1.0] {
            let shape = ball.shape_at(f, v).unwrap();
            let rounding = 1e-11 * (1.0 + center.length() / radius);
            prop_assert!((shape.gaussian() * radius * radius - 1.0).abs() < rounding);
            prop_assert!((shape.mean() * radius + 1.0).abs() < rounding);
        }
    }

    /// z = xy.
    #[test]
    fn a_saddle_has_its_closed_form(x in -3.0..3.0_f64, y in -3.0..3.0_f64) {
        let corner = |x: f64, y: f64| DVec3::new(x, y, x * y);
        let s = NurbsSurface::bilinear(corner(-3.0, -3.0), corner(-3.0, 3.0), corner(3.0, -3.0), corner(3.0, 3.0));
        let shape = Surface::from(s.unwrap()).shape_at((x + 3.0) / 6.0, (y + 3.0) / 6.0).unwrap();
        let w: f64 = 1.0 + x * x + y * y;
        prop_assert!((shape.gaussian() + 1.0 / (w * w)).abs() < 1e-13);
        prop_assert!((shape.mean() + x * y / (w * w.sqrt())).abs() < 1e-13);
    }
}

/// A paraboloid of revolution over the disc, as a fan about its top: z = −k(x² + y²)/2, with the
/// meridians straight in plan and any speed along the edge.
#[test]
fn the_top_of_an_elliptic_paraboloid_has_both_of_its_curvatures() {
    // A quarter of z = −(x² + 3y²)/2 about the top: r·(cos, sin) by a rational quadratic, r ≤ 1.
    let (c, w) = (std::f64::consts::FRAC_1_SQRT_2, [1.0, std::f64::consts::FRAC_1_SQRT_2, 1.0]);
    let plan = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    // Heights over the rim as a quadratic form of a rational quadratic: degree 4 along u, found at
    // five places of the blossom; here by raising the rim to degree 4.
    let square =
        |i: usize, j: usize, of: fn((f64, f64)) -> f64| w[i] * w[j] * of(plan[i]) * of(plan[j]);
    let binomial = [1.0, 4.0, 6.0, 4.0, 1.0];
    let two = [1.0, 2.0, 1.0];
    let mut rim = [[0.0; 4]; 5];
    for i in 0..3 {
        for j in 0..3 {
            let share = two[i] * two[j] / binomial[i + j];
            rim[i + j][0] += share * w[i] * w[j] * plan[i].0;
            rim[i + j][1] += share * w[i] * w[j] * plan[i].1;
            rim[i + j][2] -= share * 0.5 * (square(i, j, |p| p.0) + 3.0 * square(i, j, |p| p.1));
            rim[i + j][3] += share * w[i] * w[j];
        }
    }
    assert!((c - w[1]).abs() < 1e-16);
    let weights = Grid::from_fn(5, 3, |i, _| rim[i][3]);
    let points = Grid::from_fn(5, 3, |i, j| {
        let [x, y, z, w] = rim[i];
        let (leg, height) = ([0.0, 0.5, 1.0][j], [0.0, 0.0, 1.0][j]);
        DVec3::new(leg * x, leg * y, height * z) / w
    });
    let knots = |degree| virote_kernel::KnotVector::bezier(degree).unwrap();
    let s = NurbsSurface::rational(knots(4), knots(2), &points, &weights).unwrap();
    let s = Surface::from(s);
    for u in [0.0, 0.3, 0.5, 1.0] {
        let point = s.point_at(u, 0.7).unwrap();
        assert!((point.z + 0.5 * (point.x * point.x + 3.0 * point.y * point.y)).abs() < 1e-15);
        let principal = s.shape_at(u, 0.0).unwrap().principal(Tolerance::DEFAULT);
        // Su × Sv points down, where the centres are.
        let sign = s.normal_at(u, 0.0).unwrap().z;
        let [k1, k2] = if sign < 0.0 { [1.0, 3.0] } else { [-3.0, -1.0] };
        assert!((principal.k1 - k1).abs() < 1e-12 && (principal.k2 - k2).abs() < 1e-12);
        let along_x = if sign < 0.0 { principal.d1 } else { principal.d2 };
        assert!(along_x.cross(DVec3::X).length() < 1e-12);
    }
}

#[test]
fn the_apex_of_a_cone_has_no_curvature() {
    let rim = [DVec3::X, DVec3::ONE - DVec3::Z, DVec3::Y];
    let points = Grid::from_fn(3, 2, |i, j| if j == 0 { rim[i] } else { DVec3::Z });
    let cone = Surface::from(NurbsSurface::bezier(&points).unwrap());
    assert!(cone.shape_at(0.5, 0.5).unwrap().gaussian().abs() < 1e-15);
    assert!(cone.shape_at(0.5, 1.0).is_err());
}
