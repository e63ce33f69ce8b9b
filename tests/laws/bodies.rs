//! Laws of areas and volumes, and of surfaces that go on in one another.

use std::{f64::consts::PI, sync::Arc};

use glam::{DAffine3, DQuat, DVec3};
use proptest::{prelude::ProptestConfig, prop_assert, prop_assert_eq, prop_assume, proptest};
use virote_kernel::{
    DeviationReference, Direction, Edge, FunctionFailure, Grid, KnotVector, NurbsCurve,
    NurbsSurface, ParametricSurface, Surface, SurfaceFunction, Tolerance, area_mass, volume_mass,
};

use crate::some::{point, sphere, surface};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// A surface as a function that tells its derivatives.
#[derive(Debug)]
struct AsFunction(NurbsSurface);

impl SurfaceFunction for AsFunction {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        Ok(self.0.derivatives_at(u, v, order))
    }
}

fn as_function(s: &NurbsSurface) -> Surface {
    let function = Arc::new(AsFunction(s.clone()));
    Surface::from(ParametricSurface::new(s.domain_u(), s.domain_v(), function).unwrap())
}

/// The exact torus about the z axis, u around the axis and v around the tube.
fn torus(major: f64, minor: f64) -> NurbsSurface {
    let around = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let around = around.map(|(x, y)| (f64::from(x), f64::from(y)));
    let weight = |i: usize| if i.is_multiple_of(2) { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
    let points = Grid::from_fn(9, 9, |i, j| {
        let (rho, z) = (major + minor * around[j].0, minor * around[j].1);
        DVec3::new(rho * around[i].0, rho * around[i].1, z)
    });
    let weights = Grid::from_fn(9, 9, |i, j| weight(i) * weight(j));
    let knots = || {
        let inner = [0.25, 0.25, 0.5, 0.5, 0.75, 0.75];
        KnotVector::new(2, [&[0.0; 3][..], &inner, &[1.0; 3]].concat()).unwrap()
    };
    NurbsSurface::rational(knots(), knots(), &points, &weights).unwrap()
}

fn area(s: &NurbsSurface) -> f64 {
    Surface::from(s.clone()).area().unwrap().0
}

proptest! {
    // Each area is a long sum.
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn parts_have_the_area_of_the_whole(s in surface(), f in 0.1..0.9, g in 0.1..0.9) {
        let whole = area(&s);
        for (along, f) in [(Direction::U, f), (Direction::V, g)] {
            let t = s.domain(along).at(f);
            let parts = s.split(along, t).unwrap();
            prop_assert!((area(&parts[0]) + area(&parts[1]) - whole).abs() < 1e-8 * whole);
            let finer = s.insert_knots(along, &[t]).unwrap();
            prop_assert!((area(&finer) - whole).abs() < 1e-8 * whole);
        }
    }

    #[test]
    fn areas_move_and_grow_with_their_surface(s in surface(), axis in point(), by in point(), scale in 0.1..10.0) {
        prop_assume!(axis.length() > 0.1);
        let whole = area(&s);
        let turn = DQuat::from_axis_angle(axis.normalize(), 1.0);
        let moved = s.transformed(&DAffine3::from_rotation_translation(turn, by));
        prop_assert!((area(&moved) - whole).abs() < 1e-8 * whole);
        let grown = s.transformed(&DAffine3::from_scale(DVec3::splat(scale)));
        prop_assert!((area(&grown) - whole * scale * scale).abs() < 1e-8 * whole * scale * scale);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_ball_has_its_closed_forms_wherever_it_is(center in point(), r in 0.1..10.0_f64) {
        let ball = [Surface::from(sphere(center, r))];
        let (skin, inside) = (area_mass(&ball).unwrap(), volume_mass(&ball, TOLERANCE).unwrap());
        prop_assert!((skin.amount / (4.0 * PI * r * r) - 1.0).abs() < 1e-13);
        prop_assert!((inside.amount / (4.0 / 3.0 * PI * r * r * r) - 1.0).abs() < 1e-12);
        prop_assert!(inside.centroid.distance(center) < 1e-12 * (r + center.length()));
        prop_assert!(skin.centroid.distance(center) < 1e-12 * (r + center.length()));
        let moment = inside.amount * r * r * 0.4;
        for i in 0..3 {
            prop_assert!((inside.inertia.col(i)[i] / moment - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn a_torus_follows_pappus(major in 2.0..5.0, minor in 0.1..1.9) {
        let ring = [Surface::from(torus(major, minor))];
        let inside = volume_mass(&ring, TOLERANCE).unwrap();
        prop_assert!((area_mass(&ring).unwrap().amount / (4.0 * PI * PI * major * minor) - 1.0).abs() < 1e-12);
        prop_assert!((inside.amount / (2.0 * PI * PI * major * minor * minor) - 1.0).abs() < 1e-11);
        let about_axis = inside.amount * (major * major + 0.75 * minor * minor);
        prop_assert!((inside.inertia.z_axis.z / about_axis - 1.0).abs() < 1e-10);
    }

    #[test]
    fn a_surface_and_its_function_answer_alike(f in 0.02..0.98, g in 0.02..0.98) {
        let (ring, ball) = (torus(3.0, 1.0), sphere(DVec3::ONE, 2.0));
        for s in [ring, ball] {
            let (exact, function) = (Surface::from(s.clone()), as_function(&s));
            let (a, b) = (exact.shape_at(f, g).unwrap(), function.shape_at(f, g).unwrap());
            prop_assert!((a.gaussian() - b.gaussian()).abs() < 1e-12);
            prop_assert!((a.mean() - b.mean()).abs() < 1e-12);
            prop_assert_eq!(exact.kind_at(f, g, TOLERANCE).unwrap(), function.kind_at(f, g, TOLERANCE).unwrap());
        }
    }

    /// A cut inside of a piece leaves nothing to see, in whatever form the parts are.
    #[test]
    fn parts_of_a_surface_go_on_in_one_another(s in surface(), f in 0.1..0.9) {
        let t = s.knots_u().span_interval(s.knots_u().span_at(s.domain_u().at(f))).at(f);
        let [before, after] = s.split(Direction::U, t).unwrap();
        let higher = after.elevate_degree(Direction::V, s.degree_v() + 1).unwrap();
        let before = Surface::from(before);
        for after in [after, higher] {
            let met = before.continuity_with(Edge::U1, &after.into(), Edge::U0, TOLERANCE).unwrap();
            prop_assert_eq!((met.c, met.c_homogeneous), (3, 3));
            prop_assert!(met.gap < 1e-12 * 20.0);
        }
    }

    #[test]
    fn inner_knots_are_as_smooth_as_their_multiplicity_says(s in surface()) {
        let order = |knots: &KnotVector| {
            let domain = knots.domain();
            let inner = knots.distinct().into_iter().filter(|&(t, _)| domain.start() < t && t < domain.end());
            inner.map(|(_, times)| knots.degree() as i32 - times as i32).min().unwrap_or(3)
        };
        let least = order(s.knots_u()).min(order(s.knots_v())).min(3);
        let found = Surface::from(s).continuity(TOLERANCE).unwrap();
        prop_assert!(least <= found.c && least <= found.g, "{least} {found:?}");
    }

    #[test]
    fn gaps_and_angles_are_measured(gap in 1e-5..1.0, angle in 0.01..3.1_f64) {
        // Two squares, the second turned about the edge of the first and moved along z at one end.
        let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let floor = NurbsSurface::bilinear(corner(-1.0, 0.0), corner(-1.0, 1.0), corner(0.0, 0.0), corner(0.0, 1.0)).unwrap();
        let other = floor.transformed(&DAffine3::from_translation(DVec3::X));
        let turned = other.transformed(&DAffine3::from_rotation_y(-angle));
        let floor = Surface::from(floor);
        let met = floor.continuity_with(Edge::U1, &turned.clone().into(), Edge::U0, TOLERANCE).unwrap();
        prop_assert_eq!((met.c, met.g), (0, 0));
        prop_assert!((met.angle - angle).abs() < 1e-12);
        let away = turned.transformed(&DAffine3::from_translation(DVec3::new(0.0, 0.0, gap)));
        let met = floor.continuity_with(Edge::U1, &away.into(), Edge::U0, TOLERANCE).unwrap();
        prop_assert_eq!((met.c, met.g), (-1, -1));
        prop_assert!((met.gap - gap).abs() < 1e-12);
    }
}

/// Gauss and Bonnet: ∬K dA is 2π times the Euler characteristic, 2 of a sphere and 0 of a torus.
#[test]
fn total_curvatures_are_topological() {
    for (s, expected) in [(sphere(DVec3::ONE, 3.0), 4.0 * PI), (torus(3.0, 1.0), 0.0)] {
        let s = Surface::from(s);
        let mut sum = 0.0;
        // The rule of midpoints on each of the 4 × 4 pieces of the torus, 2 × 4 of the sphere.
        let n = 400;
        for i in 0..n {
            for j in 0..n {
                let (u, v) =
                    ((f64::from(i) + 0.5) / f64::from(n), (f64::from(j) + 0.5) / f64::from(n));
                let [_, along_u, along_v] = s.tangents_at(u, v).unwrap();
                sum += s.shape_at(u, v).unwrap().gaussian() * along_u.cross(along_v).length();
            }
        }
        sum /= f64::from(n * n);
        assert!((sum - expected).abs() < 1e-3, "{sum} {expected}");
    }
}

#[test]
fn closed_primitives_are_smooth_across_their_seams_and_knots() {
    for s in [sphere(DVec3::ZERO, 2.0), torus(3.0, 1.0)] {
        let found = Surface::from(s).continuity(TOLERANCE).unwrap();
        // The circle of nine points is C1 and, seen without its parameters, as smooth as a circle.
        assert_eq!((found.c, found.c_homogeneous, found.g), (1, 0, 3), "{found:?}");
    }
}

#[test]
fn a_larger_ball_is_as_far_away_as_it_is_larger() {
    let [small, large] = [2.0, 2.25].map(|radius| Surface::from(sphere(DVec3::ONE, radius)));
    let small = DeviationReference::of_surface(&small).unwrap();
    let found = large.deviation_from(&small).unwrap();
    assert!((found.max - 0.25).abs() < 1e-12 && (found.mean - 0.25).abs() < 1e-12, "{found:?}");
    let points = [DVec3::ONE, DVec3::ONE + 5.0 * DVec3::Z];
    let found = small.deviation_of(&points).unwrap().unwrap();
    assert!((found.max - 3.0).abs() < 1e-12 && (found.mean - 2.5).abs() < 1e-12, "{found:?}");
    assert!(found.at.distance(points[1]) < 1e-15);
}

#[test]
fn a_plate_that_is_pointed_at_both_ends_is_known_at_any_height() {
    for height in [0.0, 1e-3, 0.7, 4.0, 123.456] {
        let corners = [(-45.0, 0.0), (-20.0, 9.0), (20.0, 9.0), (45.0, 0.0)];
        let side = |sign: f64| {
            NurbsCurve::bezier(&corners.map(|(x, y)| DVec3::new(x, sign * y, height))).unwrap()
        };
        let plate = NurbsSurface::ruled(&side(1.0), &side(-1.0)).unwrap();
        let found = area_mass(&[plate.into()]).unwrap();
        assert!((found.amount - 837.0).abs() < 1e-10, "{}", found.amount);
        assert!(found.relative_error < 1e-12, "{}", found.relative_error);
        assert!(found.centroid.distance(DVec3::Z * height) < 1e-12, "{}", found.centroid);
    }
}
