//! Laws of edits of surfaces: other representations, parts, and common bases.

use glam::DVec3;
use proptest::{
    collection::vec,
    prelude::{Just, Strategy, any},
    prop_assert, prop_assert_eq, prop_oneof, proptest,
};
use virote_kernel::{
    DegreeError, Direction, DomainError, GeomError, Grid, Interval, JointError, KnotVector,
    NurbsSurface, Side, join_patches, make_surfaces_compatible,
};

use crate::some::{affine_map, are_near, fraction, point, sphere, surface};

fn direction() -> impl Strategy<Value = Direction> {
    prop_oneof![Just(Direction::U), Just(Direction::V)]
}

/// The largest distance of points of one parameter, over the domain of the second, as a fraction of the size.
fn distance(whole: &NurbsSurface, part: &NurbsSurface) -> f64 {
    let places = |domain: Interval| -> Vec<f64> { domain.steps(13) };
    let mut most: f64 = 0.0;
    for u in places(part.domain_u()) {
        for v in places(part.domain_v()) {
            let (a, b) = (whole.point_at(u, v), part.point_at(u, v));
            most = most.max(a.distance(b) / (1.0 + a.length()));
        }
    }
    most
}

proptest! {
    #[test]
    fn knots_leave_a_surface_in_place(
        s in surface(),
        along in direction(),
        places in vec(0.01..0.99, 0..6),
    ) {
        let knots: Vec<f64> = places.iter().map(|&f| s.domain(along).at(f)).collect();
        let refined = s.insert_knots(along, &knots).unwrap();
        prop_assert_eq!(refined.knots(along).n_points(), s.knots(along).n_points() + knots.len());
        prop_assert_eq!(refined.knots(along.other()), s.knots(along.other()));
        prop_assert!(distance(&s, &refined) < 1e-12);
    }

    #[test]
    fn elevation_leaves_a_surface_in_place(s in surface(), along in direction(), more in 0..=3usize) {
        let degree = s.knots(along).degree() + more;
        let elevated = s.elevate_degree(along, degree).unwrap();
        prop_assert_eq!(elevated.knots(along).degree(), degree);
        prop_assert!(distance(&s, &elevated) < 1e-12);
    }

    #[test]
    fn patches_are_the_surface(s in surface()) {
        let patches = s.decompose();
        prop_assert_eq!([patches.n_rows(), patches.n_columns()], s.n_patches());
        for patch in &patches {
            prop_assert_eq!(patch.n_patches(), [1, 1]);
            prop_assert_eq!(patch.knots_u().n_points(), s.degree_u() + 1);
            prop_assert!(distance(&s, patch) < 1e-12);
        }
    }

    #[test]
    fn both_parts_of_a_split_stay_in_place(s in surface(), along in direction(), f in 0.01..0.99) {
        let t = s.domain(along).at(f);
        let [before, behind] = s.split(along, t).unwrap();
        prop_assert!((before.domain(along).end() - t).abs() <= 1e-12 * s.domain(along).length());
        prop_assert!(before.domain(along).end() <= behind.domain(along).start());
        prop_assert!(distance(&s, &before) < 1e-12);
        prop_assert!(distance(&s, &behind) < 1e-12);
    }

    #[test]
    fn a_part_stays_in_place(s in surface(), along in direction(), f in 0.0..0.45, g in 0.55..1.0) {
        let domain = s.domain(along);
        let interval = Interval::new(domain.at(f), domain.at(g)).unwrap();
        let part = s.trimmed(along, interval).unwrap();
        prop_assert_eq!(part.domain(along), interval);
        prop_assert!(distance(&s, &part) < 1e-12);
    }

    #[test]
    fn clamping_leaves_a_surface_in_place(s in surface(), along in direction()) {
        let clamped = s.clamped(along);
        prop_assert_eq!(clamped.domain(along), s.domain(along));
        prop_assert!(distance(&s, &clamped) < 1e-12);
    }

    #[test]
    fn reversed_and_swapped_surfaces_have_the_same_points(
        s in surface(), along in direction(), f in fraction(), g in fraction()
    ) {
        let at = |s: &NurbsSurface, f, g| s.point_at(s.domain_u().at(f), s.domain_v().at(g));
        let (back_f, back_g) = match along {
            Direction::U => (1.0 - f, g),
            Direction::V => (f, 1.0 - g),
        };
        let point = at(&s, f, g);
        prop_assert!(are_near(at(&s.reversed(along), back_f, back_g), point, 1e-12));
        prop_assert!(are_near(at(&s.swapped(), g, f), point, 1e-14));
        prop_assert_eq!(s.swapped().swapped(), s.clone());
        let twice = s.reversed(along).reversed(along);
        prop_assert_eq!(twice.control_points(), s.control_points());
        let domain = Interval::new(-2.0, 5.0).unwrap();
        prop_assert!(are_near(at(&s.reparametrized(along, domain), f, g), point, 1e-12));
    }

    #[test]
    fn edits_commute_with_affine_maps(s in surface(), along in direction(), map in affine_map(), f in 0.1..0.9) {
        let t = s.domain(along).at(f);
        let before = s.transformed(&map).insert_knots(along, &[t]).unwrap();
        let after = s.insert_knots(along, &[t]).unwrap().transformed(&map);
        prop_assert!(distance(&before, &after) < 1e-12);
    }

    #[test]
    fn surfaces_on_a_common_basis_stay_in_place(a in surface(), b in surface(), c in surface()) {
        let all = [a, b, c];
        let common = make_surfaces_compatible(&all).unwrap();
        for (s, other) in all.iter().zip(&common) {
            for along in Direction::BOTH {
                prop_assert_eq!(other.knots(along), common[0].knots(along));
            }
            let moved = Direction::BOTH.iter().fold(s.clone(), |s, &along| {
                s.reparametrized(along, all[0].domain(along))
            });
            prop_assert!(distance(&moved, other) < 1e-11);
        }
    }
}

/// A surface of two patches along u that meet at a knot.
fn two_patches(knot: f64, times: usize, scale: f64) -> NurbsSurface {
    let inner = vec![knot * scale; times];
    let knots = [vec![0.0; 4], inner, vec![scale; 4]].concat();
    let knots_u = KnotVector::new(3, knots).unwrap();
    let n = knots_u.n_points();
    let points = Grid::from_fn(n, 2, |i, j| DVec3::new(i as f64, j as f64, (i % 2) as f64));
    NurbsSurface::polynomial(knots_u, KnotVector::bezier(1).unwrap(), &points).unwrap()
}

fn inner_knots_of_both(a: NurbsSurface, b: NurbsSurface) -> Vec<f64> {
    let common = make_surfaces_compatible(&[a.clone(), b.clone()]).unwrap();
    assert_eq!(common[0].knots_u(), common[1].knots_u());
    let moved = b.reparametrized(Direction::U, a.domain_u());
    assert!(distance(&a, &common[0]) < 1e-8 && distance(&moved, &common[1]) < 1e-8);
    let knots = common[0].knots_u().as_slice();
    knots[4..knots.len() - 4].to_vec()
}

#[test]
fn knots_that_only_rounding_or_a_small_slip_tells_apart_become_one() {
    let half = || two_patches(0.5, 1, 1.0);
    assert_eq!(inner_knots_of_both(half(), two_patches(0.5 + 1e-9, 1, 1.0)), [0.5]);
    assert_eq!(inner_knots_of_both(half(), two_patches(0.5 + 1e-6, 1, 1.0)).len(), 2);
    assert_eq!(inner_knots_of_both(half(), two_patches(0.5 + 1e-9, 1, 1e6)), [0.5]);
    assert_eq!(inner_knots_of_both(half(), two_patches(0.5, 3, 1.0)), [0.5; 3]);
    let tenths = inner_knots_of_both(two_patches(0.3, 1, 1.0), two_patches(0.1 * 3.0, 1, 1.0));
    assert_eq!(tenths, [0.3]);
}

#[test]
fn multiplicities_of_knots_that_become_one_do_not_add_up() {
    let (a, b) = (two_patches(0.744, 3, 1.0), two_patches(0.744 + 1e-9, 1, 1.0));
    assert_eq!(inner_knots_of_both(a, b), [0.744; 3]);
}

#[test]
fn knots_of_one_surface_stay_apart_and_clusters_do_not_grow_from_neighbour_to_neighbour() {
    let knots = [vec![0.0; 4], vec![0.5, 0.5 + 1e-9], vec![1.0; 4]].concat();
    let knots_u = KnotVector::new(3, knots).unwrap();
    let points = Grid::from_fn(6, 2, |i, j| DVec3::new(i as f64, j as f64, (i * i) as f64));
    let near = NurbsSurface::polynomial(knots_u, KnotVector::bezier(1).unwrap(), &points).unwrap();
    assert_eq!(inner_knots_of_both(near, two_patches(0.5, 1, 1.0)), [0.5, 0.5 + 1e-9]);

    let steps: Vec<NurbsSurface> =
        (0..8).map(|i| two_patches(0.5 + 1.5e-9 * f64::from(i), 1, 1.0)).collect();
    let common = make_surfaces_compatible(&steps).unwrap();
    let knots = common[0].knots_u().as_slice();
    assert_eq!(knots.len() - 8, 4);
}

#[test]
fn an_elevated_and_refined_sphere_stays_round() {
    let mut ball = sphere(DVec3::new(1.0, 2.0, 3.0), 5.0);
    for along in Direction::BOTH {
        ball = ball.elevate_degree(along, 4).unwrap();
        ball = ball.insert_knots(along, &[0.1, 0.3, 0.7]).unwrap();
    }
    for f in Interval::UNIT.steps(17) {
        for g in Interval::UNIT.steps(13) {
            let radius = ball.point_at(f, g).distance(DVec3::new(1.0, 2.0, 3.0));
            assert!((radius - 5.0).abs() < 2e-14, "{radius} at ({f}, {g})");
        }
    }
}

#[test]
fn cuts_outside_or_at_the_ends_are_refused() {
    let ball = sphere(DVec3::ZERO, 1.0);
    let at_end = |result: Result<[NurbsSurface; 2], GeomError>| {
        assert!(matches!(result, Err(GeomError::Domain(DomainError::ParameterAtEnd { .. }))));
    };
    at_end(ball.split(Direction::U, 0.0));
    at_end(ball.split(Direction::V, 1.0));
    let outside = ball.split(Direction::V, 1.5);
    assert!(matches!(outside, Err(GeomError::Domain(DomainError::ParameterOutside { .. }))));
    let narrow = Interval::new(0.5, 0.5 + 1e-14).unwrap();
    let narrow = ball.trimmed(Direction::U, narrow);
    assert!(matches!(narrow, Err(GeomError::Domain(DomainError::NarrowInterval { .. }))));
    let lower = ball.elevate_degree(Direction::U, 1);
    assert_eq!(lower, Err(GeomError::Degree(DegreeError::DegreeTooLow { from: 2, to: 1 })));
}

fn free_points(n: usize, m: usize) -> impl Strategy<Value = Grid<DVec3>> {
    vec(point(), n * m).prop_map(move |points| Grid::new(n, m, points).unwrap())
}

proptest! {
    #[test]
    fn joining_undoes_decomposition_of_a_surface(s in surface()) {
        let joined = join_patches(&s.decompose(), 1e-9).unwrap();
        prop_assert!(distance(&s, &joined) < 1e-9);
        for along in Direction::BOTH {
            let clamped = s.clamped(along);
            prop_assert!(joined.knots(along).n_points() <= clamped.knots(along).n_points());
        }
    }

    #[test]
    fn joining_undoes_splitting_of_a_surface(s in surface(), along in direction(), f in 0.01..0.99) {
        let parts = s.split(along, s.domain(along).at(f)).unwrap().to_vec();
        let grid = match along {
            Direction::U => Grid::new(2, 1, parts).unwrap(),
            Direction::V => Grid::new(1, 2, parts).unwrap(),
        };
        let joined = join_patches(&grid, 1e-9).unwrap();
        prop_assert!(distance(&s, &joined) < 1e-10);
        let n = s.clamped(along).knots(along).n_points();
        prop_assert!(joined.knots(along).n_points() <= n);
    }

    #[test]
    fn a_continuation_meets_with_its_order(
        (s, free) in surface().prop_flat_map(|s| {
            let n = s.knots_u().n_points();
            (Just(s), (1..=3usize).prop_flat_map(move |m| free_points(n, m)))
        }),
        order in 0..=2usize,
        is_start in any::<bool>(),
        is_swapped in any::<bool>(),
        f in fraction(),
    ) {
        let (s, free, across) = match is_swapped {
            true => (s.swapped(), free.transposed(), Direction::U),
            false => (s, free, Direction::V),
        };
        let side = if is_start { Side::Left } else { Side::Right };
        // Weights that go on may leave the positive numbers: that is told.
        let Ok(next) = s.continued(across, side, order, &free) else {
            prop_assert!(s.is_rational());
            return Ok(());
        };
        prop_assert_eq!(next.knots(across.other()), s.knots(across.other()));
        let along = s.domain(across.other()).at(f);
        let beside = |s: &NurbsSurface, t: f64, side: Side| match across {
            Direction::U => s.isocurve_v(along).derivatives_beside(t, side, order),
            Direction::V => s.isocurve_u(along).derivatives_beside(t, side, order),
        };
        let domain = s.domain(across);
        let (own, others) = match side {
            Side::Left => (beside(&s, domain.start(), Side::Right), beside(&next, 1.0, Side::Left)),
            Side::Right => (beside(&s, domain.end(), Side::Left), beside(&next, 0.0, Side::Right)),
        };
        for (k, (a, b)) in own.iter().zip(&others).enumerate() {
            prop_assert!(are_near(*a, *b, 1e-8), "order {k}: {a} {b}");
        }
    }

    #[test]
    fn the_levels_of_corner_cutting_end_at_the_point(
        (n, m) in (2..6usize, 2..6usize), seed in vec(point(), 36), f in fraction(), g in fraction()
    ) {
        let net = Grid::from_fn(n, m, |i, j| seed[6 * i + j]);
        let s = NurbsSurface::bezier(&net).unwrap();
        let levels = s.de_casteljau(f, g).unwrap();
        prop_assert_eq!(levels.len(), n.max(m));
        prop_assert_eq!(&levels[0], &net);
        prop_assert!(are_near(levels[n.max(m) - 1].get(0, 0), s.point_at(f, g), 1e-12));
    }

    #[test]
    fn a_border_is_closed_and_lies_on_the_edges(s in surface(), f in fraction()) {
        let border = s.border(1e-6).unwrap();
        prop_assert!(are_near(border.start(), border.end(), 1e-12));
        let (u, v) = (s.domain_u(), s.domain_v());
        let first = s.point_at(u.at(f), v.start());
        prop_assert!(are_near(border.point_at(u.at(f)), first, 1e-9));
        let second = s.point_at(u.end(), v.at(f));
        prop_assert!(are_near(border.point_at(u.end() + f * v.length()), second, 1e-9));
        let total = border.domain().length();
        prop_assert!((total - 2.0 * (u.length() + v.length())).abs() < 1e-9);
    }
}

#[test]
fn four_patches_of_a_bicubic_spline_join_with_simple_knots() {
    let knots = KnotVector::uniform_clamped(3, 5, 2.0).unwrap();
    let points = Grid::from_fn(5, 5, |i, j| {
        DVec3::new(i as f64, j as f64, if (i + j) % 3 == 0 { 1.0 } else { 0.0 })
    });
    let s = NurbsSurface::polynomial(knots.clone(), knots, &points).unwrap();
    let joined = join_patches(&s.decompose(), 1e-9).unwrap();
    assert_eq!(joined.knots_u(), s.knots_u());
    assert_eq!(joined.knots_v(), s.knots_v());
}

#[test]
fn patches_apart_name_the_gap() {
    let s = sphere(DVec3::ZERO, 1.0);
    let [south, north] = s.split(Direction::V, 0.5).unwrap();
    let raised = north.transformed(&glam::DAffine3::from_translation(DVec3::Z * 0.25));
    let grid = Grid::new(1, 2, vec![south, raised]).unwrap();
    match join_patches(&grid, 1e-6) {
        Err(GeomError::Joint(JointError::PatchGap {
            along: "v",
            before: [0, 0],
            next: [0, 1],
            gap,
            ..
        })) => {
            assert!((gap - 0.25).abs() < 1e-12);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn sides_run_through_at_different_speeds_are_no_one_surface() {
    let knots = || KnotVector::bezier(1).unwrap();
    let points = |x: f64| Grid::from_fn(2, 2, |i, j| DVec3::new(x + i as f64, j as f64, 0.0));
    let weights = |w: f64| Grid::from_fn(2, 2, |_, j| if j == 0 { 1.0 } else { w });
    let patch =
        |x: f64, w: f64| NurbsSurface::rational(knots(), knots(), &points(x), &weights(w)).unwrap();
    let unlike = Grid::new(2, 1, vec![patch(0.0, 1.0), patch(1.0, 2.0)]).unwrap();
    assert!(matches!(
        join_patches(&unlike, 1e-6),
        Err(GeomError::Joint(JointError::UnlikeWeights { .. }))
    ));
    let alike = Grid::new(2, 1, vec![patch(0.0, 2.0), patch(1.0, 2.0)]).unwrap();
    assert!(join_patches(&alike, 1e-6).is_ok());
}

#[test]
fn the_border_of_a_sphere_leaves_out_its_poles() {
    let border = sphere(DVec3::ZERO, 1.0).border(1e-6).unwrap();
    assert!(border.start().distance(border.end()) < 1e-12);
    assert!((border.domain().length() - 2.0).abs() < 1e-12);
}
