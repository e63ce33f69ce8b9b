//! Laws of the nearest point: against brute force, and where searches break.

use glam::{DAffine3, DVec3};
use proptest::{prelude::ProptestConfig, prop_assert, proptest};
use virote_kernel::{CircleForm, Frame, Grid, KnotVector, NurbsCurve, NurbsSurface};

use crate::some::{curve, point, surface};

const TOLERANCE: f64 = 1e-6;

/// Numbers on 0..1 in no order: multiples of irrational numbers.
fn scattered(n: usize) -> impl Iterator<Item = DVec3> {
    let steps = DVec3::new(0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_97);
    (1..=n).map(move |i| (steps * i as f64).fract())
}

/// The least distance of samples, each of the best improved by halving steps.
fn by_force(curve: &NurbsCurve, samples: &[(f64, DVec3)], p: DVec3) -> f64 {
    let domain = curve.domain();
    let mut best: Vec<(f64, f64)> =
        samples.iter().map(|&(t, point)| (point.distance(p), t)).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    best.truncate(4);
    let refined = best.into_iter().map(|(mut least, mut t)| {
        let mut step = domain.length() / samples.len() as f64;
        for _ in 0..50 {
            for next in [t - step, t + step] {
                let next = next.clamp(domain.start(), domain.end());
                let distance = curve.point_at(next).distance(p);
                if distance < least {
                    (least, t) = (distance, next);
                }
            }
            step *= 0.5;
        }
        least
    });
    refined.fold(f64::INFINITY, f64::min)
}

/// The same of a surface.
fn by_force_on(surface: &NurbsSurface, samples: &[([f64; 2], DVec3)], p: DVec3) -> f64 {
    let domains = [surface.domain_u(), surface.domain_v()];
    let mut best: Vec<(f64, [f64; 2])> =
        samples.iter().map(|&(at, point)| (point.distance(p), at)).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    best.truncate(4);
    let refined = best.into_iter().map(|(mut least, mut at)| {
        let mut step = 2.0 / (samples.len() as f64).sqrt();
        for _ in 0..45 {
            for (i, j) in [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, 1), (-1, 1), (1, -1)] {
                let moved = |at: f64, k: i32, domain: virote_kernel::Interval| {
                    let by = f64::from(k) * step * domain.length();
                    (at + by).clamp(domain.start(), domain.end())
                };
                let next = [moved(at[0], i, domains[0]), moved(at[1], j, domains[1])];
                let distance = surface.point_at(next[0], next[1]).distance(p);
                if distance < least {
                    (least, at) = (distance, next);
                }
            }
            step *= 0.6;
        }
        least
    });
    refined.fold(f64::INFINITY, f64::min)
}

fn samples(surface: &NurbsSurface, n: usize) -> Vec<([f64; 2], DVec3)> {
    let (us, vs) = (surface.domain_u().steps(n), surface.domain_v().steps(n));
    let pairs = us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v]));
    pairs.map(|[u, v]| ([u, v], surface.point_at(u, v))).collect()
}

#[track_caller]
fn check(surface: &NurbsSurface, samples: &[([f64; 2], DVec3)], p: DVec3) {
    let (foot, least) = (surface.closest(p), by_force_on(surface, samples, p));
    let [u, v] = foot.parameters;
    assert!(surface.domain_u().contains(u) && surface.domain_v().contains(v));
    assert!((surface.point_at(u, v).distance(p) - foot.distance).abs() <= 1e-12);
    assert!(foot.distance <= least + 1e-10, "{p}: {} at {u}, {v}, not {least}", foot.distance);
}

/// Twelve by twelve points of a wave.
fn wave(weight: impl Fn(usize, usize) -> f64) -> NurbsSurface {
    let n = 12;
    let height = |i: usize, j: usize| 2.0 * libm::sin(1.1 * i as f64) * libm::cos(0.9 * j as f64);
    let points = Grid::from_fn(n, n, |i, j| DVec3::new(i as f64, j as f64, height(i, j)));
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    NurbsSurface::rational(knots.clone(), knots, &points, &Grid::from_fn(n, n, weight)).unwrap()
}

/// A profile of points in the plane y = 0 turned once about the z-axis.
fn revolved(knots: KnotVector, profile: &[(DVec3, f64)]) -> NurbsSurface {
    let (r, h) = (0.5_f64.sqrt(), 1.0);
    let around =
        [(h, 0.0), (h, h), (0.0, h), (-h, h), (-h, 0.0), (-h, -h), (0.0, -h), (h, -h), (h, 0.0)];
    let of_u = |i: usize| if i.is_multiple_of(2) { 1.0 } else { r };
    let point = |i: usize, j: usize| {
        let DVec3 { x, z, .. } = profile[j].0;
        DVec3::new(x * around[i].0, x * around[i].1, z)
    };
    let weights = Grid::from_fn(9, profile.len(), |i, j| of_u(i) * profile[j].1);
    let quarters = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    let turn = KnotVector::new(2, quarters).unwrap();
    NurbsSurface::rational(turn, knots, &Grid::from_fn(9, profile.len(), point), &weights).unwrap()
}

fn sphere() -> NurbsSurface {
    let r = 0.5_f64.sqrt();
    let at = |x: f64, z: f64, weight: f64| (DVec3::new(x, 0.0, z), weight);
    let arc = [
        at(0.0, -1.0, 1.0),
        at(1.0, -1.0, r),
        at(1.0, 0.0, 1.0),
        at(1.0, 1.0, r),
        at(0.0, 1.0, 1.0),
    ];
    let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0]).unwrap();
    revolved(knots, &arc)
}

/// The tube of radius 1 around a circle of radius 3.
fn torus() -> NurbsSurface {
    let r = 0.5_f64.sqrt();
    let at = |x: f64, z: f64, weight: f64| (DVec3::new(3.0 + x, 0.0, z), weight);
    let tube = [
        at(1.0, 0.0, 1.0),
        at(1.0, 1.0, r),
        at(0.0, 1.0, 1.0),
        at(-1.0, 1.0, r),
        at(-1.0, 0.0, 1.0),
        at(-1.0, -1.0, r),
        at(0.0, -1.0, 1.0),
        at(1.0, -1.0, r),
        at(1.0, 0.0, 1.0),
    ];
    let quarters = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    revolved(KnotVector::new(2, quarters).unwrap(), &tube)
}

/// Places beside the lines where patches meet are on the surface, and their own nearest ones, up to rounding: far
/// below the root of the rounding of squares of distances.
#[test]
fn places_beside_knots_are_nearest_to_themselves() {
    let center = DVec3::new(3000.0, 2000.0, 4000.0);
    let circle = NurbsCurve::ellipse(Frame::XY.at(center), [300.0; 2], CircleForm::NinePoint);
    let pipe = NurbsSurface::extruded(&circle.expect("a circle"), DVec3::new(300.0, 0.0, 1000.0));
    let turn = DAffine3::from_axis_angle(DVec3::new(0.3, 0.7, -0.2).normalize(), 1.1);
    let pipe = pipe.expect("a pipe").transformed(&turn);
    for k in 0..60 {
        let (beside, v) = (f64::from(k) * 1.7e-10, 0.5 + f64::from(k % 7) * 3e-10);
        for u in [beside, 1.0 - beside, 0.25 + beside, 0.5 - beside] {
            let foot = pipe.closest(pipe.point_at(u, v));
            assert!(
                foot.distance < 2e-11,
                "{u:?} {v:?}: {} at {:?}",
                foot.distance,
                foot.parameters
            );
        }
    }
}

#[test]
fn no_point_of_a_winding_curve_is_nearer() {
    let n = 100;
    let at = |i: usize| DVec3::new(i as f64, ((7 * i) % 11) as f64, ((5 * i) % 13) as f64);
    let points: Vec<DVec3> = (0..n).map(at).collect();
    let weights: Vec<f64> = (0..n).map(|i| 1.0 + 0.1 * (i % 7) as f64).collect();
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    let curve = NurbsCurve::rational(knots, &points, &weights).unwrap();
    let samples: Vec<(f64, DVec3)> =
        curve.domain().steps(3000).into_iter().map(|t| (t, curve.point_at(t))).collect();
    let (low, size) = (DVec3::new(-15.0, -3.0, -3.0), DVec3::new(130.0, 17.0, 19.0));
    for at in scattered(1000) {
        let p = low + size * at;
        let (foot, least) = (curve.closest(p, TOLERANCE), by_force(&curve, &samples, p));
        assert!(foot.distance <= least + 1e-10, "{p}: {} not {least}", foot.distance);
        assert_eq!(foot.count, 1, "{p}: {foot:?}");
    }
}

/// Around each of its points nearly all of a spiral is nearly equally far, as far as the tolerance tells.
#[test]
fn a_point_of_a_spiral_is_found_on_it_at_any_tolerance() {
    for (n, growth) in [(41, 1.0 / 1500.0), (41, 1.0), (300, 1e-3)] {
        let point = |i: usize| {
            let (radius, angle) = (growth * i as f64, 40f64.to_radians() * i as f64);
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
        };
        let points: Vec<DVec3> = (0..n).map(point).collect();
        let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
        let spiral = NurbsCurve::polynomial(knots, &points).unwrap();
        for i in 0..=60 {
            let t = f64::from(i) / 600.0;
            for tolerance in [1e-3, 1e-6, 1e-9] {
                let foot = spiral.closest(spiral.point_at(t), tolerance);
                let what = format!("{n} points, {t}, {tolerance}");
                assert!(foot.distance < 1e-12, "{what}: {}", foot.distance);
            }
        }
    }
}

#[test]
fn no_point_of_a_wave_is_nearer_beside_it_either() {
    for surface in [wave(|_, _| 1.0), wave(|i, j| 1.0 + 0.3 * ((3 * i + 5 * j) % 7) as f64)] {
        let samples = samples(&surface, 100);
        for at in scattered(200) {
            check(
                &surface,
                &samples,
                DVec3::new(-3.0, -3.0, -4.0) + DVec3::new(17.0, 17.0, 8.0) * at,
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn no_point_of_a_surface_is_nearer(surface in surface(), p in point()) {
        check(&surface, &samples(&surface, 60), p);
    }

    #[test]
    fn no_point_of_a_curve_is_nearer(curve in curve(), p in point()) {
        let samples: Vec<(f64, DVec3)> =
            curve.domain().steps(2000).into_iter().map(|t| (t, curve.point_at(t))).collect();
        let (foot, least) = (curve.closest(p, TOLERANCE), by_force(&curve, &samples, p));
        prop_assert!(foot.distance <= least + 1e-10, "{} not {least}", foot.distance);
    }

    #[test]
    fn a_point_of_a_surface_is_its_own_foot(surface in surface(), u in 0.0..1.0, v in 0.0..1.0) {
        let p = surface.point_at(surface.domain_u().at(u), surface.domain_v().at(v));
        prop_assert!(surface.closest(p).distance <= 1e-12);
    }
}

#[test]
fn the_centre_of_a_sphere_has_feet_everywhere() {
    assert!((sphere().closest(DVec3::ZERO).distance - 1.0).abs() <= 1e-15);
    let foot = sphere().closest(DVec3::new(1e-9, 0.0, 0.0));
    assert!((foot.distance - (1.0 - 1e-9)).abs() <= 1e-13);
}

#[test]
fn the_axis_of_a_torus_has_feet_all_around() {
    for height in [0.0, 0.5, 2.0] {
        let foot = torus().closest(DVec3::new(0.0, 0.0, height));
        let expected = (9.0 + height * height).sqrt() - 1.0;
        assert!((foot.distance - expected).abs() <= 1e-13, "{height}: {foot:?}");
    }
    // The circle in the middle of the tube.
    assert!((torus().closest(DVec3::new(0.0, 3.0, 0.0)).distance - 1.0).abs() <= 1e-14);
}

#[test]
fn a_ring_of_feet_askew_to_the_parameters_ends_the_search() {
    // z = x² + y² on a square: from a height h above 1/2 a whole circle is √(h − 1/4) away.
    let at = |i: usize, j: usize| {
        let of = |k: usize| [1.0, -1.0, 1.0][k];
        DVec3::new(i as f64 - 1.0, j as f64 - 1.0, of(i) + of(j))
    };
    let bowl = NurbsSurface::bezier(&Grid::from_fn(3, 3, at)).unwrap();
    for h in [0.5, 0.5 + 1e-6, 0.75, 1.0] {
        let foot = bowl.closest(DVec3::new(0.0, 0.0, h));
        assert!((foot.distance - (h - 0.25).sqrt()).abs() <= 1e-12, "{h}: {foot:?}");
    }
}

#[test]
fn poles_and_seams_are_told_by_the_starts_of_the_domains() {
    let pole = sphere().closest(DVec3::new(0.0, 0.0, 3.0));
    assert!(pole.parameters[0] <= 0.0 && 1.0 <= pole.parameters[1]);
    assert!(pole.point.distance(DVec3::Z) <= 1e-15);
    let seam = sphere().closest(DVec3::new(5.0, 0.0, 0.0));
    assert!(seam.parameters[0] < 1e-9 && (seam.parameters[1] - 0.5).abs() < 1e-9);
    let (both, outside) = (torus().closest(DVec3::new(9.0, 0.0, 0.0)), 5.0);
    assert!(both.parameters[0] < 1e-9 && both.parameters[1] < 1e-9);
    assert!((both.distance - outside).abs() <= 1e-14);
}

#[test]
fn a_twisted_bilinear_surface_has_its_foot() {
    // z = x y on the unit square.
    let saddle = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE).unwrap();
    let samples = samples(&saddle, 60);
    for at in scattered(200) {
        check(&saddle, &samples, DVec3::splat(-1.0) + DVec3::splat(3.0) * at);
    }
    // Normal to it at (1/2, 1/4): (−1/4, −1/2, 1).
    let (foot, normal) = (DVec3::new(0.5, 0.25, 0.125), DVec3::new(-0.25, -0.5, 1.0));
    let found = saddle.closest(foot + 0.2 * normal);
    assert!(found.point.distance(foot) <= 1e-14);
}

#[test]
fn far_points_have_their_feet() {
    for (p, foot) in
        [(DVec3::new(1e6, 0.0, 0.0), DVec3::X), (DVec3::new(0.0, 0.0, -1e6), -DVec3::Z)]
    {
        let found = sphere().closest(p);
        assert!(found.point.distance(foot) <= 1e-8, "{p}: {found:?}");
        assert!((found.distance - (1e6 - 1.0)).abs() <= 1e-9, "{p}: {found:?}");
    }
    // So far away that squares have no place among the numbers, and all of it is as near.
    let far = sphere().closest(DVec3::new(0.0, -1e200, 0.0)).distance;
    assert!((far / 1e200 - 1.0).abs() <= 1e-15);
}

#[test]
fn a_curve_with_a_cusp_and_one_with_many_turns() {
    // (t², t³) about its cusp: nothing but the cusp is nearer to a point behind it.
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let cusp = NurbsCurve::bezier(&[
        at(1.0, -1.0),
        at(-1.0 / 3.0, 1.0),
        at(-1.0 / 3.0, -1.0),
        at(1.0, 1.0),
    ])
    .unwrap();
    for p in [at(-1.0, 0.0), at(-1e-9, 0.0), DVec3::ZERO] {
        let foot = cusp.closest(p, TOLERANCE);
        assert!((foot.distance - p.length()).abs() <= 1e-12, "{p}: {foot:?}");
        assert_eq!(foot.count, 1, "{p}: {foot:?}");
    }
    // Seven turns of a helix about an axis: from it a foot on each of them.
    let n = 57;
    let turn = |i: usize| {
        let angle = std::f64::consts::FRAC_PI_4 * i as f64;
        DVec3::new(libm::cos(angle), libm::sin(angle), 0.1 * i as f64)
    };
    let points: Vec<DVec3> = (0..n).map(turn).collect();
    let knots = KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    let ribbon = NurbsCurve::polynomial(knots, &points).unwrap();
    let samples: Vec<(f64, DVec3)> =
        ribbon.domain().steps(3000).into_iter().map(|t| (t, ribbon.point_at(t))).collect();
    for at in scattered(300) {
        let p = DVec3::new(-1.5, -1.5, -1.0) + DVec3::new(3.0, 3.0, 8.0) * at;
        let (foot, least) = (ribbon.closest(p, TOLERANCE), by_force(&ribbon, &samples, p));
        assert!(foot.distance <= least + 1e-10, "{p}: {} not {least}", foot.distance);
    }
}

#[test]
fn a_foot_beside_a_knot_or_the_seam_is_one_place() {
    // A parabola in two pieces, with the foot a little beside the knot between them.
    let at = |x: f64| DVec3::new(x, x * x, 0.0);
    let parabola = NurbsCurve::bezier(&[at(-1.0), DVec3::new(0.0, -1.0, 0.0), at(1.0)]).unwrap();
    let cut = parabola.insert_knots(&[0.5]).unwrap();
    for beside in [0.0, 1e-5, -1e-4, 1e-3] {
        let p = at(beside) + 0.25 * DVec3::new(2.0 * beside, -1.0, 0.0);
        let foot = cut.closest(p, TOLERANCE);
        assert_eq!(foot.count, 1, "{beside}: {foot:?}");
        assert!((foot.parameter - (0.5 + 0.5 * beside)).abs() <= 1e-12);
    }
    let form = virote_kernel::CircleForm::NinePoint;
    let circle = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, form).unwrap();
    for angle in [0.0, 1e-4, -1e-4] {
        let p = 2.0 * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        assert_eq!(circle.closest(p, TOLERANCE).count, 1);
    }
}

#[test]
fn all_of_a_circle_far_away_is_as_near_to_a_point_of_its_axis() {
    for (n, place) in scattered(60).enumerate() {
        let far = libm::exp10((n % 6) as f64);
        let center = (place - DVec3::splat(0.5)) * far;
        let normal = DVec3::new(place.z - 0.5, place.x - 0.5, place.y + 0.1);
        let frame = Frame::from_normal(center, normal, None).expect("a plane");
        let radius = 0.2 + place.y;
        let circle = NurbsCurve::arc(frame, radius, 0.0, std::f64::consts::TAU).expect("a circle");
        let height = 2.0 * place.z;
        let foot = circle.closest(center + frame.z() * height, TOLERANCE);
        assert_eq!(foot.stretch, Some(circle.domain()));
        assert!((foot.distance - libm::hypot(radius, height)).abs() <= 1e-14 * (1.0 + far), "{n}");
        assert_eq!(foot.count, 1);
    }
}

#[test]
fn the_nearest_place_of_a_curve_within_the_tolerance_is_its_own() {
    for size in [1e-6, 0.5e-6, 1e-8, 1e-40, 1e-150] {
        let circle = NurbsCurve::arc(Frame::XY, size, 0.0, std::f64::consts::TAU).unwrap();
        let foot = circle.closest(DVec3::new(3.0, 4.0, 0.0) * size, 1e-6);
        assert!((foot.distance / size - 4.0).abs() < 1e-14, "{size:e}: {foot:?}");
        assert!(foot.point.distance(DVec3::new(0.6, 0.8, 0.0) * size) < 1e-14 * size, "{size:e}");
    }
}

/// Where parameter lines are slanted against a thin surface, no part of it can be left out by the squares of
/// distances alone.
#[test]
fn a_point_of_a_slanted_sliver_is_its_own_foot() {
    let (o, x) = (DVec3::ZERO, 2.0 * DVec3::X);
    for width in [0.1, 1e-3, 1e-5] {
        let tip = x + DVec3::Y * width;
        let sliver = NurbsSurface::bilinear(o, tip, x, tip).unwrap();
        for at in scattered(60) {
            let p = sliver.point_at(at.x, at.y);
            assert!(sliver.closest(p).distance <= 1e-12, "{p} of {width}");
            let above = sliver.closest(p + 0.3 * DVec3::Z).distance;
            assert!((above - 0.3).abs() <= 1e-12, "{p} of {width}: {above}");
        }
    }
}
