//! Laws of surfaces through networks.

use glam::DVec3;
use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{
    CircleForm, Ends, Gordon, Grid, Interpolator, Interval, KnotVector, Network, NurbsCurve,
    NurbsSurface, gordon,
};

use crate::some::point;

/// A polynomial surface of degree 3 whose isocurves are far apart.
fn sheet() -> impl Strategy<Value = NurbsSurface> {
    vec(point(), 30).prop_map(|points| {
        let at = |i: usize, j: usize| {
            glam::DVec3::new(20.0 * i as f64, 20.0 * j as f64, 0.0) + 0.3 * points[5 * i + j]
        };
        let knots = |n: usize| KnotVector::uniform_clamped(3, n, 1.0).unwrap();
        NurbsSurface::polynomial(knots(6), knots(5), &Grid::from_fn(6, 5, at)).unwrap()
    })
}

/// Parameters from 0 to 1 that keep apart.
fn parameters() -> impl Strategy<Value = Vec<f64>> {
    vec(0.3..1.0, 1..4).prop_map(|steps| {
        let total: f64 = steps.iter().sum();
        let mut sum = 0.0;
        let mut all = vec![0.0];
        all.extend(steps.iter().map(|step| {
            sum += step / total;
            sum
        }));
        let last = all.len() - 1;
        all[last] = 1.0;
        all
    })
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(32))]

    #[test]
    fn curves_of_a_network_are_isocurves(
        sheet in sheet(),
        at_u in parameters(),
        at_v in parameters(),
        are_given in proptest::prelude::any::<bool>(),
        is_lagrange in proptest::prelude::any::<bool>(),
    ) {
        let us: Vec<NurbsCurve> = at_v.iter().map(|&v| sheet.isocurve_v(v)).collect();
        let vs: Vec<NurbsCurve> = at_u.iter().map(|&u| sheet.isocurve_u(u)).collect();
        let at = if are_given { [Some(&at_u[..]), Some(&at_v[..])] } else { [None, None] };
        let network = Network { curves: [&us, &vs], at, is_lagrange, tolerance: 1e-6 };
        let made = gordon(network).unwrap();
        for f in [0.0, 0.13, 0.5, 0.77, 1.0] {
            for (&v, curve) in at_v.iter().zip(&us) {
                prop_assert!(made.surface.point_at(f, v).distance(curve.point_at(f)) < 1e-10);
            }
            for (&u, curve) in at_u.iter().zip(&vs) {
                prop_assert!(made.surface.point_at(u, f).distance(curve.point_at(f)) < 1e-10);
            }
        }
        prop_assert!(made.changes.iter().flatten().all(|change| change.deviation < 1e-10));
    }

    #[test]
    fn order_and_direction_of_the_others_do_not_matter(sheet in sheet(), at_u in parameters(), at_v in parameters(), flips in vec(proptest::prelude::any::<bool>(), 8)) {
        let us: Vec<NurbsCurve> = at_v.iter().map(|&v| sheet.isocurve_v(v)).collect();
        let vs: Vec<NurbsCurve> = at_u.iter().map(|&u| sheet.isocurve_u(u)).collect();
        let made = |us: &[NurbsCurve], vs: &[NurbsCurve]| {
            gordon(Network { curves: [us, vs], at: [None, None], is_lagrange: false, tolerance: 1e-6 }).unwrap()
        };
        let plain = made(&us, &vs).surface;
        let shuffled = |curves: &[NurbsCurve], flips: &[bool]| {
            let mut others: Vec<NurbsCurve> = curves[1..].iter().zip(flips).map(|(c, &flip)| if flip { c.reversed() } else { c.clone() }).collect();
            others.reverse();
            [&curves[..1], &others].concat()
        };
        let other = made(&shuffled(&us, &flips), &shuffled(&vs, &flips[4..]));
        for (u, v) in [(0.1, 0.3), (0.5, 0.9), (0.8, 0.6)] {
            prop_assert!(plain.point_at(u, v).distance(other.surface.point_at(u, v)) < 1e-9);
        }
    }
}

/// The bump of a guide between its ends: how far it stands off at a height from 0 to 2.
fn bump(height: f64) -> f64 {
    0.5 * height * (2.0 - height)
}

/// A parabola from z = 0 to z = 2 that stands off its chord by [`bump`] times `off`.
fn guide(foot: DVec3, off: DVec3) -> NurbsCurve {
    let points = [foot, foot + DVec3::Z + off, foot + 2.0 * DVec3::Z];
    NurbsCurve::polynomial(KnotVector::bezier(2).unwrap(), &points).unwrap()
}

fn circle(height: f64, radius: f64) -> NurbsCurve {
    let center = DVec3::Z * height;
    NurbsCurve::circle(center, radius, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap()
}

fn through(us: &[NurbsCurve], vs: &[NurbsCurve], tolerance: f64) -> Gordon {
    gordon(Network { curves: [us, vs], at: [None, None], is_lagrange: false, tolerance }).unwrap()
}

/// Between two guides of a closed direction each counts half, in front and behind.
#[test]
fn of_two_guides_around_each_counts_half_between_them() {
    let rings = [circle(0.0, 1.0), circle(2.0, 1.0)];
    for off in [DVec3::X, DVec3::new(0.0, 2.0, 0.0)] {
        let guides = [guide(DVec3::X, off), guide(-DVec3::X, DVec3::ZERO)];
        let made = through(&rings, &guides, 1e-6);
        assert_eq!(made.at[0], [0.0, 0.5, 1.0]);
        for v in [0.0, 0.25, 0.5, 0.9, 1.0] {
            let straight = |x: f64, y: f64| DVec3::new(x, y, 2.0 * v);
            let off = off * bump(2.0 * v);
            for (u, expected) in [
                (0.0, straight(1.0, 0.0) + off),
                (0.25, straight(0.0, 1.0) + 0.5 * off),
                (0.5, straight(-1.0, 0.0)),
                (0.75, straight(0.0, -1.0) + 0.5 * off),
                (1.0, straight(1.0, 0.0) + off),
            ] {
                let found = made.surface.point_at(u, v);
                assert!(found.distance(expected) < 1e-9, "{found} at {u}, {v}, not {expected}");
            }
        }
    }
}

/// Whichever way the other rings run: across two guides by the tangents at the first, across more
/// by the order of the meetings.
#[test]
fn rings_are_turned_to_the_way_of_the_first() {
    for n_guides in [2, 3, 5] {
        let foot = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / n_guides as f64;
            DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        let guides: Vec<NurbsCurve> =
            (0..n_guides).map(|k| guide(foot(k), 0.5 * foot(k))).collect();
        let rings = [0.0, 1.0, 2.0].map(|height| circle(height, 1.0 + 0.5 * bump(height)));
        let plain = through(&rings, &guides, 1e-6);
        let ways =
            |made: &Gordon| made.changes[0].iter().map(|change| change.is_reversed).collect();
        let ways: [Vec<bool>; 2] = [&plain, &{
            let turned = [rings[0].clone(), rings[1].reversed(), rings[2].clone()];
            let made = through(&turned, &guides, 1e-6);
            for (u, v) in [(0.1, 0.3), (0.4, 0.5), (0.8, 0.75)] {
                let (there, here) = (plain.surface.point_at(u, v), made.surface.point_at(u, v));
                assert!(there.distance(here) < 2e-6, "{n_guides} guides: {here}, not {there}");
            }
            made
        }]
        .map(ways);
        assert_eq!(ways[0], [false; 3], "{n_guides} guides");
        // The first one gives the way where there are two guides; of more their order does.
        assert_eq!(ways[1], [false, true, false], "{n_guides} guides");
    }
}

/// A drop: closed, with a corner at its seam of which the sides stand at right angles.
fn drop_at(height: f64) -> NurbsCurve {
    let points = [[0.0, 0.0], [3.0, 3.0], [-3.0, 3.0], [0.0, 0.0]];
    let points = points.map(|[x, y]| DVec3::new(x, y, height));
    NurbsCurve::polynomial(KnotVector::bezier(3).unwrap(), &points).unwrap()
}

#[test]
fn the_angle_at_a_seam_is_that_of_the_rings() {
    let rings = [drop_at(0.0), drop_at(2.0)];
    let guides = [0.0, 0.5].map(|t| {
        let points = rings.each_ref().map(|ring| ring.point_at(t));
        let guide = NurbsCurve::polynomial(KnotVector::bezier(1).unwrap(), &points).unwrap();
        guide.reparametrized(Interval::new(0.0, 0.5).unwrap())
    });
    let right = std::f64::consts::FRAC_PI_2;
    // From the corner along (1, 1) and back to it along (1, -1).
    let [along, across] = through(&rings, &guides, 1e-6).seams;
    assert!((along.unwrap() - right).abs() < 1e-9 && across.is_none(), "{along:?} {across:?}");
    let [along, across] = through(&guides, &rings, 1e-6).seams;
    assert!((across.unwrap() - right).abs() < 1e-9 && along.is_none(), "{along:?} {across:?}");
    let smooth = through(
        &[circle(0.0, 1.0), circle(2.0, 1.0)],
        &[guide(DVec3::X, DVec3::ZERO), guide(-DVec3::X, DVec3::ZERO)],
        1e-6,
    );
    assert!(smooth.seams[0].unwrap() < 1e-9);
}

/// Wavy curves over a sheet of which those across stand a gap higher, so that all are refitted.
fn wavy(gap: f64) -> [Vec<NurbsCurve>; 2] {
    let wave =
        |x: f64, y: f64, z: f64| DVec3::new(x, y, z + libm::sin(2.0 * x) + libm::cos(1.5 * y));
    let line = |at: &dyn Fn(f64) -> DVec3, pace: f64| {
        let parameters: Vec<f64> = (0..=60).map(|i| f64::from(i) / 60.0).collect();
        let places: Vec<DVec3> =
            parameters.iter().map(|&t| at(4.0 * (t + pace * t * (1.0 - t)))).collect();
        Interpolator::new(&parameters, 3, Ends::NotAKnot).unwrap().curve(&places).unwrap()
    };
    let paces = [0.0, 0.3, -0.2];
    let us =
        [0.0, 2.0, 4.0].into_iter().zip(paces).map(|(y, pace)| line(&|x| wave(x, y, 0.0), pace));
    let vs =
        [0.0, 2.0, 4.0].into_iter().zip(paces).map(|(x, pace)| line(&|y| wave(x, y, gap), pace));
    [us.collect(), vs.collect()]
}

/// A gap of two curves where they meet takes three quarters of itself from what their splines may
/// miss, but leaves two fifths: the surface is that of curves which meet, at so much less tolerance.
#[test]
fn a_gap_takes_its_part_of_the_tolerance() {
    let made = |gap: f64, tolerance: f64| {
        let [us, vs] = wavy(gap);
        let made = through(&us, &vs, tolerance);
        assert!((made.gap.0 - gap).abs() < 2e-6, "{}", made.gap.0);
        let all = || made.changes.iter().flatten();
        assert!(all().all(|change| change.deviation <= tolerance));
        assert!(all().all(|change| change.is_refitted));
        let surface = &made.surface;
        [surface.knots_u().n_points(), surface.knots_v().n_points()]
    };
    let tolerance = 1e-3;
    for part in [0.2_f64, 0.4, 0.5, 0.6, 0.8, 0.9, 0.98] {
        let without = made(0.0, tolerance * (1.0 - 0.75 * part).max(0.4));
        assert_eq!(made(part * tolerance, tolerance), without, "{part}");
    }
}

/// A curve may go far between two of its knots that are hardly apart: its corners there are on the surface, or there
/// is none.
#[test]
fn corners_at_neighbouring_parameters_are_kept() {
    let line = |ends: [[f64; 3]; 2]| NurbsCurve::polyline(&ends.map(DVec3::from_array)).unwrap();
    let vs = [
        line([[0.0, 0.0, 0.0], [0.0, 4.0, 0.0]]),
        line([[0.5, 0.0, 0.0], [2.0, 4.0, 0.0]]),
        line([[4.0, 0.0, 0.0], [4.0, 4.0, 0.0]]),
    ];
    let far = line([[0.0, 4.0, 0.0], [4.0, 4.0, 0.0]]);
    let mut n_made = 0;
    for apart in [0.1, 1e-3, 1e-5, 2e-6, 5e-7, 5e-8, 1e-9, 3e-12] {
        // Before and behind a step of √0.29 in the middle, and the same at the end.
        for knots in [[0.5, 0.5 + apart], [1.0 - 2.0 * apart, 1.0 - apart]] {
            let corners = [DVec3::X, DVec3::new(1.2, 0.0, 0.5)];
            let points = [DVec3::ZERO, corners[0], corners[1], DVec3::X * 4.0];
            let knots = KnotVector::new(1, vec![0.0, 0.0, knots[0], knots[1], 1.0, 1.0]).unwrap();
            let near = NurbsCurve::polynomial(knots, &points).unwrap();
            let curves = [&[near, far.clone()][..], &vs[..]];
            let network = Network { curves, at: [None, None], is_lagrange: false, tolerance: 1e-6 };
            let Ok(made) = gordon(network) else { continue };
            n_made += 1;
            for corner in corners {
                let distance = made.surface.closest(corner).distance;
                assert!(distance <= 1e-6, "{apart}: {distance}");
            }
        }
    }
    assert!(4 <= n_made, "{n_made}");
}
