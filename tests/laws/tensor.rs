//! Laws of tensor products of every curve form: corners and their tangents, hulls, affine maps,
//! lines and planes, locality, Bézier nets as splines, weights, and smoothness at knots.

use glam::DVec3;
use proptest::{
    collection::vec,
    prelude::{Just, Strategy},
    prop_assert, prop_assume, proptest,
};
use virote_kernel::{
    Direction, Ends, FirstPass, Grid, Interpolator, KnotVector, LineFit, NurbsSurface,
};

use crate::some::{affine_map, are_near, fraction, knots, point, surface};

/// A net of sizes within these limits.
fn net(least: usize, most: usize) -> impl Strategy<Value = Grid<DVec3>> {
    (least..=most, least..=most).prop_flat_map(|(n, m)| {
        (Just((n, m)), vec(point(), n * m))
            .prop_map(|((n, m), points)| Grid::new(n, m, points).unwrap())
    })
}

fn clamped(degree: usize, net: &Grid<DVec3>) -> NurbsSurface {
    let knots = |n| KnotVector::uniform_clamped(degree, n, (n - degree) as f64).unwrap();
    NurbsSurface::polynomial(knots(net.n_rows()), knots(net.n_columns()), net).unwrap()
}

fn coons(net: &Grid<DVec3>) -> NurbsSurface {
    let knots = |n| KnotVector::uniform(3, n).unwrap();
    NurbsSurface::polynomial(knots(net.n_rows()), knots(net.n_columns()), net).unwrap()
}

/// Through the points, at the parameters 0, 1, 2, … in both directions.
fn through(net: &Grid<DVec3>) -> NurbsSurface {
    let fit = |n: usize| {
        let parameters: Vec<f64> = (0..n).map(|i| i as f64).collect();
        LineFit::Through(Interpolator::new(&parameters, 3, Ends::Natural).unwrap())
    };
    let (u, v) = (fit(net.n_rows()), fit(net.n_columns()));
    FirstPass::new(net, &u).unwrap().second(&v).unwrap()
}

/// Every tensor product that is made of a net alone.
fn of_every_form(net: &Grid<DVec3>) -> [NurbsSurface; 4] {
    [NurbsSurface::bezier(net).unwrap(), clamped(2, net), coons(net), through(net)]
}

fn place(s: &NurbsSurface, f: f64, g: f64) -> (f64, f64) {
    (s.domain_u().at(f), s.domain_v().at(g))
}

/// The rows and columns of the net that have a say at a place.
fn support(s: &NurbsSurface, u: f64, v: f64) -> [std::ops::RangeInclusive<usize>; 2] {
    let along = |knots: &KnotVector, t: f64| knots.support(knots.span_at(t));
    [along(s.knots_u(), u), along(s.knots_v(), v)]
}

proptest! {
    #[test]
    fn a_clamped_net_ends_in_its_corners_with_its_first_legs_as_tangents(s in surface()) {
        let s = s.clamped(Direction::U).clamped(Direction::V);
        let (points, weights) = (s.points(), s.weights());
        let (n, m) = (points.n_rows() - 1, points.n_columns() - 1);
        // p / (u_{p+1} − u_p) · w₁/w₀ · (P₁ − P₀), and likewise at the end.
        let speed = |knots: &KnotVector, at_end: bool| {
            let (p, u) = (knots.degree(), knots.as_slice());
            let k = if at_end { u.len() - p - 2 } else { p };
            p as f64 / (u[k + 1] - u[k])
        };
        for (i, j) in [(0, 0), (0, m), (n, 0), (n, m)] {
            let end = |knots: &KnotVector, at_end: bool| {
                if at_end { knots.domain().end() } else { knots.domain().start() }
            };
            let (u, v) = (end(s.knots_u(), 0 < i), end(s.knots_v(), 0 < j));
            let [at, along_u, along_v] = s.tangents_at(u, v);
            prop_assert!(are_near(at, points.get(i, j), 1e-14));
            let leg = |k: usize, l: usize, knots: &KnotVector, at_end: bool| {
                let leg = points.get(k, l) - points.get(i, j);
                let sign = if at_end { -1.0 } else { 1.0 };
                leg * (sign * speed(knots, at_end) * weights.get(k, l) / weights.get(i, j))
            };
            let beside = |k: usize| if 0 < k { k - 1 } else { 1 };
            prop_assert!(are_near(along_u, leg(beside(i), j, s.knots_u(), 0 < i), 1e-11));
            prop_assert!(are_near(along_v, leg(i, beside(j), s.knots_v(), 0 < j), 1e-11));
        }
    }

    #[test]
    fn each_patch_lies_in_the_hull_of_its_own_points(
        s in surface(), f in fraction(), g in fraction(), direction in point(),
    ) {
        let (u, v) = place(&s, f, g);
        let [rows, columns] = support(&s, u, v);
        let points = s.points();
        let heights: Vec<f64> = rows
            .flat_map(|i| columns.clone().map(move |j| (i, j)))
            .map(|(i, j)| points.get(i, j).dot(direction))
            .collect();
        let (low, high) = heights.iter().fold((f64::MAX, f64::MIN), |(a, b), &h| (a.min(h), b.max(h)));
        let height = s.point_at(u, v).dot(direction);
        prop_assert!((low - 1e-11..=high + 1e-11).contains(&height), "{low} {height} {high}");
    }

    #[test]
    fn making_and_moving_commute_for_every_form(
        net in net(4, 6), map in affine_map(), f in fraction(), g in fraction(),
    ) {
        let moved = net.map(|&p| map.transform_point3(p));
        for (before, after) in of_every_form(&net).into_iter().zip(of_every_form(&moved)) {
            let (u, v) = place(&before, f, g);
            let expected = map.transform_point3(before.point_at(u, v));
            prop_assert!(are_near(after.point_at(u, v), expected, 1e-11));
        }
    }

    #[test]
    fn a_net_on_a_line_makes_a_surface_within_its_segment(
        a in point(), along in point(), places in vec(0.0..1.0, 16..=16), f in fraction(), g in fraction(),
    ) {
        prop_assume!(along.length() > 0.1);
        let net = Grid::new(4, 4, places).unwrap().map(|&place| a + along * place);
        for s in [NurbsSurface::bezier(&net).unwrap(), clamped(2, &net), coons(&net)] {
            let (u, v) = place(&s, f, g);
            let arm = s.point_at(u, v) - a;
            prop_assert!(arm.cross(along).length() < 1e-12 * (1.0 + a.length()) * along.length());
            prop_assert!((-1e-12..=1.0 + 1e-12).contains(&(arm.dot(along) / along.length_squared())));
        }
    }

    #[test]
    fn a_net_in_a_plane_makes_a_plane_surface(
        net in net(4, 6), normal in point(), f in fraction(), g in fraction(),
    ) {
        prop_assume!(normal.length() > 0.1);
        let normal = normal.normalize();
        let flat = net.map(|&p| p - normal * p.dot(normal));
        for s in of_every_form(&flat) {
            let (u, v) = place(&s, f, g);
            prop_assert!(s.point_at(u, v).dot(normal).abs() < 1e-10);
        }
    }

    /// Linear precision: over the abscissae of Greville a net of a bilinear function is the function.
    #[test]
    fn a_bilinear_net_over_the_abscissae_is_its_function(
        knots_u in knots(), knots_v in knots(), c in [point(), point(), point(), point()],
        f in fraction(), g in fraction(),
    ) {
        let function = |u: f64, v: f64| c[0] + c[1] * u + c[2] * v + c[3] * (u * v);
        let (us, vs) = (knots_u.greville(), knots_v.greville());
        let net = Grid::from_fn(us.len(), vs.len(), |i, j| function(us[i], vs[j]));
        let s = NurbsSurface::polynomial(knots_u, knots_v, &net).unwrap();
        let (u, v) = place(&s, f, g);
        prop_assert!(are_near(s.point_at(u, v), function(u, v), 1e-13));
    }

    #[test]
    fn a_control_point_moves_only_its_own_patches(
        s in surface(), f in fraction(), g in fraction(), i in 0..99usize, j in 0..99usize, to in point(),
    ) {
        let points = s.points();
        let (i, j) = (i % points.n_rows(), j % points.n_columns());
        let changed = Grid::from_fn(points.n_rows(), points.n_columns(), |k, l| {
            if (k, l) == (i, j) { to } else { points.get(k, l) }
        });
        let changed = NurbsSurface::rational(
            s.knots_u().clone(), s.knots_v().clone(), &changed, &s.weights(),
        ).unwrap();
        let (u, v) = place(&s, f, g);
        let within = |knots: &KnotVector, i: usize, t: f64| {
            (knots.as_slice()[i]..=knots.as_slice()[i + knots.degree() + 1]).contains(&t)
        };
        if !within(s.knots_u(), i, u) || !within(s.knots_v(), j, v) {
            prop_assert!(are_near(s.point_at(u, v), changed.point_at(u, v), 1e-14));
        }
    }

    #[test]
    fn a_point_of_a_coons_net_moves_sixteen_patches_at_most(
        net in net(8, 9), i in 0..8usize, j in 0..8usize, to in point(),
    ) {
        let changed = Grid::from_fn(net.n_rows(), net.n_columns(), |k, l| {
            if (k, l) == (i, j) { to } else { net.get(k, l) }
        });
        let (before, after) = (coons(&net), coons(&changed));
        let [n, m] = before.n_patches();
        let moves = |(k, l): (usize, usize)| {
            let (u, v) = (k as f64 + 0.5, l as f64 + 0.5);
            before.point_at(u, v) != after.point_at(u, v)
        };
        let n_moved = (0..n).flat_map(|k| (0..m).map(move |l| (k, l))).filter(|&at| moves(at)).count();
        prop_assert!(n_moved <= 16, "{n_moved}");
    }

    #[test]
    fn a_bezier_net_is_a_spline_with_knots_at_its_ends_only(net in net(2, 6)) {
        let knots = |n: usize| KnotVector::uniform_clamped(n - 1, n, 1.0).unwrap();
        let spline =
            NurbsSurface::polynomial(knots(net.n_rows()), knots(net.n_columns()), &net).unwrap();
        prop_assert!(spline == NurbsSurface::bezier(&net).unwrap());
        prop_assert!(spline.n_patches() == [1, 1]);
    }

    #[test]
    fn a_growing_weight_pulls_the_surface_to_its_point(
        net in net(4, 4), i in 1..3usize, j in 1..3usize, f in 0.1..0.9, g in 0.1..0.9,
    ) {
        let distance = |weight: f64| {
            let knots = || KnotVector::bezier(3).unwrap();
            let weights = Grid::from_fn(4, 4, |k, l| if (k, l) == (i, j) { weight } else { 1.0 });
            let s = NurbsSurface::rational(knots(), knots(), &net, &weights).unwrap();
            s.point_at(f, g).distance(net.get(i, j))
        };
        prop_assert!(distance(1e3) <= distance(1.0) + 1e-12);
        prop_assert!(distance(1e9) < 1e-4);
    }

    #[test]
    fn a_weight_of_zero_takes_its_point_away(
        s in surface(), i in 0..99usize, j in 0..99usize, to in point(), f in fraction(), g in fraction(),
    ) {
        let (points, weights) = (s.points(), s.weights());
        let (i, j) = (i % points.n_rows(), j % points.n_columns());
        let weights = Grid::from_fn(points.n_rows(), points.n_columns(), |k, l| {
            if (k, l) == (i, j) { 0.0 } else { weights.get(k, l) }
        });
        let without = |at: DVec3| {
            let points = Grid::from_fn(points.n_rows(), points.n_columns(), |k, l| {
                if (k, l) == (i, j) { at } else { points.get(k, l) }
            });
            NurbsSurface::rational(s.knots_u().clone(), s.knots_v().clone(), &points, &weights)
        };
        // A corner alone has all the weight there, so that nothing would be left.
        let made = [without(points.get(i, j)), without(to)];
        prop_assume!(made.iter().all(Result::is_ok));
        let [here, there] = made.map(Result::unwrap);
        let (u, v) = place(&s, f, g);
        prop_assert!(are_near(here.point_at(u, v), there.point_at(u, v), 1e-13));
    }

    /// A spline of degree p is C^(p − s) where a knot stands s times, and no smoother.
    #[test]
    fn smoothness_at_a_knot_is_the_degree_less_its_multiplicity(
        s in surface(), along_u in 0..2, which in 0..9usize, g in fraction(),
    ) {
        let s = if along_u == 0 { s } else { s.swapped() };
        let (p, domain) = (s.degree_u(), s.domain_u());
        let inner: Vec<(f64, usize)> = s.knots_u().distinct().into_iter()
            .filter(|&(t, _)| domain.start() < t && t < domain.end()).collect();
        prop_assume!(!inner.is_empty());
        let (t, times) = inner[which % inner.len()];
        let v = s.domain_v().at(g);
        let [left, right] = s.split(Direction::U, t).unwrap();
        let [left, right] = [left.derivatives_at(t, v, p), right.derivatives_at(t, v, p)];
        let size = |k: usize| {
            (0..=k).map(|k| left.get(k, 0).length() + right.get(k, 0).length()).fold(1.0, f64::max)
        };
        for k in 0..=p - times {
            prop_assert!(left.get(k, 0).distance(right.get(k, 0)) < 1e-10 * size(k), "order {k}");
        }
        let next = p - times + 1;
        prop_assert!(left.get(next, 0).distance(right.get(next, 0)) > 1e-9 * size(next));
    }
}
