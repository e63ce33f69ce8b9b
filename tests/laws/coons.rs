//! Laws of surfaces within boundaries: the boundaries are met, whatever their degrees, knots and
//! weights, and surfaces that are the same in theory are.

use glam::DVec3;
use proptest::{array::uniform4, collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{Blend, CrossFields, Direction, Grid, Interval, NurbsCurve, NurbsSurface};

use crate::some::{affine_map, are_near, curve, fraction, point};

/// Size of the models made here.
const SIZE: f64 = 30.0;

/// A curve with its ends moved to two places: by a linear function of the parameter, which a
/// curve of any weights takes up exactly.
fn between(c: &NurbsCurve, from: DVec3, to: DVec3) -> NurbsCurve {
    let (c, domain) = (c.clamped(), c.domain());
    let (low, high) = (from - c.start(), to - c.end());
    // The line on the curve's own weights, as a curve, added to it.
    let line = NurbsCurve::line(low, high).unwrap().reparametrized(domain);
    let weights: Vec<DVec3> = c.weights().iter().map(|&w| DVec3::new(w, 0.0, 0.0)).collect();
    let factor = NurbsCurve::polynomial(c.knots().clone(), &weights).unwrap();
    let shift = line.reweighted(&factor).unwrap();
    let both = virote_kernel::make_compatible(&[c, shift]).unwrap();
    let points = both[0].points().into_iter().zip(both[1].points()).map(|(p, q)| p + q);
    NurbsCurve::rational(both[0].knots().clone(), &points.collect::<Vec<_>>(), &both[0].weights())
        .unwrap()
}

/// Two curves along u and two along v that share their ends.
fn boundary() -> impl Strategy<Value = [NurbsCurve; 4]> {
    ([curve(), curve(), curve(), curve()], uniform4(point())).prop_map(|(curves, corners)| {
        let [c0, c1, d0, d1] = curves;
        let [p00, p01, p10, p11] = corners;
        [
            between(&c0, p00, p10),
            between(&c1, p01, p11),
            between(&d0, p00, p01),
            between(&d1, p10, p11),
        ]
    })
}

/// The distance of the four edges from the given curves.
fn misses([c0, c1, d0, d1]: &[NurbsCurve; 4], s: &NurbsSurface) -> f64 {
    let (us, vs) = (s.domain_u(), s.domain_v());
    let at = |c: &NurbsCurve, f: f64| c.point_at(c.domain().at(f));
    (0..=40).map(|i| f64::from(i) / 40.0).fold(0.0, |worst: f64, f| {
        let (u, v) = (us.at(f), vs.at(f));
        worst
            .max(s.point_at(u, vs.start()).distance(at(c0, f)))
            .max(s.point_at(u, vs.end()).distance(at(c1, f)))
            .max(s.point_at(us.start(), v).distance(at(d0, f)))
            .max(s.point_at(us.end(), v).distance(at(d1, f)))
    })
}

proptest! {
    #[test]
    fn a_coons_surface_meets_its_boundaries_and_is_its_formula(
        curves in boundary(), f in fraction(), g in fraction(),
    ) {
        let [c0, c1, d0, d1] = &curves;
        for across in [Blend::Linear, Blend::Cubic] {
            let surface = NurbsSurface::coons([c0, c1], [d0, d1], across).unwrap();
            prop_assert!(misses(&curves, &surface) < 1e-12 * SIZE);
            let blend = |t: f64| match across {
                Blend::Linear => t,
                Blend::Cubic => t * t * (3.0 - 2.0 * t),
            };
            let (a, b) = (blend(f), blend(g));
            let at = |c: &NurbsCurve, f: f64| c.point_at(c.domain().at(f));
            let ruled_u = at(c0, f).lerp(at(c1, f), b);
            let ruled_v = at(d0, g).lerp(at(d1, g), a);
            let corners = c0.start().lerp(c0.end(), a).lerp(c1.start().lerp(c1.end(), a), b);
            let formula = ruled_u + ruled_v - corners;
            let found = surface.point_at(surface.domain_u().at(f), surface.domain_v().at(g));
            prop_assert!(found.distance(formula) < 1e-11 * SIZE);
        }
    }

    #[test]
    fn making_a_coons_surface_and_moving_commute(
        curves in boundary(), map in affine_map(), f in fraction(), g in fraction(),
    ) {
        let [c0, c1, d0, d1] = &curves;
        let moved = curves.clone().map(|c| c.transformed(&map));
        let [e0, e1, h0, h1] = &moved;
        let before = NurbsSurface::coons([c0, c1], [d0, d1], Blend::Linear).unwrap();
        let after = NurbsSurface::coons([e0, e1], [h0, h1], Blend::Linear).unwrap();
        let (u, v) = (before.domain_u().at(f), before.domain_v().at(g));
        let p = map.transform_point3(before.point_at(u, v));
        prop_assert!(after.point_at(u, v).distance(p) < 1e-11 * SIZE * SIZE);
    }

    #[test]
    fn polynomial_coons_surfaces_have_the_knots_of_their_boundaries(
        corners in uniform4(point()), inner in uniform4(vec(point(), 2..=5)),
    ) {
        let [p00, p01, p10, p11] = corners;
        let clamped = |from: DVec3, inner: &[DVec3], to: DVec3| {
            let points: Vec<DVec3> = [from].into_iter().chain(inner.iter().copied()).chain([to]).collect();
            let knots = virote_kernel::KnotVector::uniform_clamped(3, points.len(), (points.len() - 3) as f64);
            NurbsCurve::polynomial(knots.unwrap(), &points).unwrap()
        };
        // Of equal counts along u and along v: Coons of clamped boundaries is a clamped surface.
        let along_u = [clamped(p00, &inner[0], p10), clamped(p01, &inner[0], p11)];
        let along_v = [clamped(p00, &inner[2], p01), clamped(p10, &inner[2], p11)];
        let surface = NurbsSurface::coons([&along_u[0], &along_u[1]], [&along_v[0], &along_v[1]], Blend::Linear).unwrap();
        prop_assert!(surface.knots_u() == along_u[0].knots());
        prop_assert!(surface.knots_v() == along_v[0].knots());
        prop_assert!(!surface.is_rational());
        // Theorem 3.1 of Linkeová for clamped nets: the boundary rows of the net are the boundaries'.
        let net = surface.points();
        for (i, point) in along_u[0].points().into_iter().enumerate() {
            prop_assert!(are_near(net.get(i, 0), point, 1e-13));
        }
    }

    #[test]
    fn with_straight_sides_it_is_ruled_and_with_four_bilinear(
        c0 in curve(), corners in uniform4(point()), f in fraction(), g in fraction(),
    ) {
        let [p00, p01, p10, p11] = corners;
        let (low, high) = (between(&c0, p00, p10), between(&c0, p01, p11));
        let side = |a: DVec3, b: DVec3| NurbsCurve::line(a, b).unwrap();
        let coons = NurbsSurface::coons([&low, &high], [&side(p00, p01), &side(p10, p11)], Blend::Linear).unwrap();
        let ruled = NurbsSurface::ruled(&low, &high).unwrap();
        let u = low.domain().at(f);
        prop_assert!(coons.point_at(u, g).distance(ruled.point_at(u, g)) < 1e-12 * SIZE);

        let four = NurbsSurface::coons(
            [&side(p00, p10), &side(p01, p11)], [&side(p00, p01), &side(p10, p11)], Blend::Linear,
        ).unwrap();
        let bilinear = NurbsSurface::bilinear(p00, p01, p10, p11).unwrap();
        prop_assert!(four.knots_u() == bilinear.knots_u() && four.knots_v() == bilinear.knots_v());
        prop_assert!(four.point_at(f, g).distance(bilinear.point_at(f, g)) < 1e-13 * SIZE);
    }

    #[test]
    fn bicubic_bezier_boundaries_make_the_inner_points_of_linkeova_3_39(
        edge in vec(point(), 12),
    ) {
        // V00 V10 V20 V30 along the first u-curve, and so on.
        let p = &edge;
        let bezier = |points: [DVec3; 4]| NurbsCurve::bezier(&points).unwrap();
        let (v00, v30, v03, v33) = (p[0], p[3], p[8], p[11]);
        let c0 = bezier([v00, p[1], p[2], v30]);
        let c1 = bezier([v03, p[9], p[10], v33]);
        let d0 = bezier([v00, p[4], p[5], v03]);
        let d1 = bezier([v30, p[6], p[7], v33]);
        let surface = NurbsSurface::coons([&c0, &c1], [&d0, &d1], Blend::Linear).unwrap();
        let (u, v) = ([&c0, &c1].map(NurbsCurve::points), [&d0, &d1].map(NurbsCurve::points));
        let inner = |i: usize, j: usize| {
            let (a, b) = (i as f64 / 3.0, j as f64 / 3.0);
            u[0][i].lerp(u[1][i], b) + v[0][j].lerp(v[1][j], a)
                - v00.lerp(v30, a).lerp(v03.lerp(v33, a), b)
        };
        let net = surface.points();
        for i in 0..4 {
            for j in 0..4 {
                prop_assert!(net.get(i, j).distance(inner(i, j)) < 1e-13 * SIZE);
            }
        }
    }

    #[test]
    fn a_bicubic_patch_is_made_again_of_its_own_boundary_data(
        points in vec(point(), 36), f in fraction(), g in fraction(), wide in 0.5..4.0, deep in 0.5..4.0,
    ) {
        // A surface of degrees (5, 5) has cross fields of degree 5, and the sum takes all of them.
        let source = NurbsSurface::bezier(&Grid::new(6, 6, points).unwrap()).unwrap();
        let source = source
            .reparametrized(Direction::U, Interval::new(1.0, 1.0 + wide).unwrap())
            .reparametrized(Direction::V, Interval::new(-2.0, deep - 2.0).unwrap());
        let (us, vs) = (source.domain_u(), source.domain_v());
        let [d0, d1, c0, c1] = source.edges();
        let fields = own_fields(&source);
        for corner in [[0, 0], [0, 1], [1, 0], [1, 1]] {
            let twists = fields.twists(corner);
            prop_assert!(twists.of_cross_u.distance(twists.of_cross_v) < 1e-10 * SIZE);
        }
        let surface = NurbsSurface::coons_bicubic([&c0, &c1], [&d0, &d1], &fields).unwrap();
        prop_assert!(misses(&[c0, c1, d0, d1], &surface) < 1e-12 * SIZE);
        // And the derivatives across.
        let (u, v) = (us.at(f), vs.at(g));
        for (at_u, at_v) in [(u, vs.start()), (u, vs.end()), (us.start(), v), (us.end(), v)] {
            let (found, given) = (surface.derivatives_at(at_u, at_v, 2), source.derivatives_at(at_u, at_v, 2));
            prop_assert!(found.get(1, 0).distance(given.get(1, 0)) < 1e-10 * SIZE);
            prop_assert!(found.get(0, 1).distance(given.get(0, 1)) < 1e-10 * SIZE);
        }
        for (at_u, at_v) in [(us.start(), vs.start()), (us.start(), vs.end()), (us.end(), vs.start()), (us.end(), vs.end())] {
            let (found, given) = (surface.derivatives_at(at_u, at_v, 2), source.derivatives_at(at_u, at_v, 2));
            prop_assert!(found.get(1, 1).distance(given.get(1, 1)) < 1e-9 * SIZE);
        }
    }

    #[test]
    fn averaged_twists_agree_and_leave_the_ends_of_the_fields(points in vec(point(), 36)) {
        let source = NurbsSurface::bezier(&Grid::new(6, 6, points).unwrap()).unwrap();
        let mut fields = own_fields(&source);
        // Fields of degree 1 with the same ends.
        let straight = NurbsCurve::line(fields.cross_u[0].start(), fields.cross_u[0].end()).unwrap();
        fields.cross_u[0] = straight.clone();
        let means = [[0, 0], [1, 0]].map(|corner| fields.twists(corner).mean());
        let kept = [[0, 1], [1, 1]].map(|corner| fields.twists(corner));
        let corrected = fields.clone().with_mean_twists(&[[0, 0], [1, 0]]).unwrap();
        for (corner, mean) in [[0, 0], [1, 0]].into_iter().zip(means) {
            let twists = corrected.twists(corner);
            prop_assert!(twists.of_cross_u.distance(mean) < 1e-12 * SIZE);
            prop_assert!(twists.of_cross_v.distance(mean) < 1e-12 * SIZE);
        }
        for (corner, before) in [[0, 1], [1, 1]].into_iter().zip(kept) {
            let after = corrected.twists(corner);
            prop_assert!(after.of_cross_u.distance(before.of_cross_u) < 1e-12 * SIZE);
            prop_assert!(after.of_cross_v.distance(before.of_cross_v) < 1e-12 * SIZE);
        }
        prop_assert!(corrected.cross_u[0].start().distance(straight.start()) < 1e-13 * SIZE);
        prop_assert!(corrected.cross_u[0].end().distance(straight.end()) < 1e-13 * SIZE);
    }
}

/// The derivatives of a Bézier surface across its boundaries, as curves.
fn own_fields(s: &NurbsSurface) -> CrossFields {
    let net = s.points();
    let (n, m) = (net.n_rows() - 1, net.n_columns() - 1);
    let on = |points: Vec<DVec3>, domain: Interval| {
        NurbsCurve::bezier(&points).unwrap().reparametrized(domain)
    };
    let across_v = |j: usize| {
        let slope =
            |i: usize| (net.get(i, j + 1) - net.get(i, j)) * (m as f64 / s.domain_v().length());
        on((0..=n).map(slope).collect(), s.domain_u())
    };
    let across_u = |i: usize| {
        let slope =
            |j: usize| (net.get(i + 1, j) - net.get(i, j)) * (n as f64 / s.domain_u().length());
        on((0..=m).map(slope).collect(), s.domain_v())
    };
    CrossFields { cross_u: [across_v(0), across_v(m - 1)], cross_v: [across_u(0), across_u(n - 1)] }
}

#[test]
fn four_arcs_of_one_circle_fill_it() {
    use std::f64::consts::FRAC_PI_2;
    let arc =
        |k: f64| NurbsCurve::arc(virote_kernel::Frame::XY, 2.0, k * FRAC_PI_2, FRAC_PI_2).unwrap();
    let [low, right, high, left] = [0.0, 1.0, 2.0, 3.0].map(arc);
    let curves = [low, high.reversed(), left.reversed(), right];
    let [c0, c1, d0, d1] = &curves;
    let surface = NurbsSurface::coons([c0, c1], [d0, d1], Blend::Linear).unwrap();
    // One denominator along each direction, which the blending function adds a degree to.
    assert_eq!([surface.degree_u(), surface.degree_v()], [3, 3]);
    assert!(misses(&curves, &surface) < 1e-14);
    for i in 0..=20 {
        for j in 0..=20 {
            let p = surface.point_at(f64::from(i) / 20.0, f64::from(j) / 20.0);
            assert!(p.length() < 2.0 + 1e-14 && p.z == 0.0);
        }
    }
}

#[test]
fn curves_of_different_weights_meet_over_the_product_of_their_denominators() {
    let conic = |weight: f64, z: f64| {
        let points = [DVec3::new(0.0, z, 0.0), DVec3::new(1.0, z, 2.0), DVec3::new(2.0, z, 0.0)];
        let knots = virote_kernel::KnotVector::bezier(2).unwrap();
        NurbsCurve::rational(knots, &points, &[1.0, weight, 1.0]).unwrap()
    };
    let (low, high) = (conic(0.5, 0.0), conic(3.0, 4.0));
    let side = |x: f64| NurbsCurve::line(DVec3::new(x, 0.0, 0.0), DVec3::new(x, 4.0, 0.0)).unwrap();
    let curves = [low, high, side(0.0), side(2.0)];
    let [c0, c1, d0, d1] = &curves;
    let surface = NurbsSurface::coons([c0, c1], [d0, d1], Blend::Linear).unwrap();
    // 2 + 2 of the denominators, 1 of the blending function; along v nothing is rational.
    assert_eq!([surface.degree_u(), surface.degree_v()], [5, 1]);
    assert!(misses(&curves, &surface) < 1e-14);
    // Halfway it is halfway between the conics: a homogeneous sum is not.
    let middle = surface.point_at(0.5, 0.5);
    let formula = (c0.point_at(0.5) + c1.point_at(0.5)) / 2.0;
    assert!(middle.distance(formula) < 1e-14);
}
