//! Curves and surfaces whose control points vary: slopes against closed forms, and against central
//! differences of the curves and surfaces themselves.

use std::sync::Arc;

use glam::{DVec3, DVec4};
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy, prop_assert, prop_assume, proptest},
};
use virote_kernel::{
    Axis, CircleForm, CompatibleSections, Ends, Frame, Interpolator, Jet, NurbsCurve, NurbsSurface,
    Parametrization, PointSlopes, Region, RegionWay, SectionParameters, Side, SkinBuilder, Solid,
    Surface, Tolerance, VariedCurve, VariedRegion, VariedSolid, VariedSurface, interpolate_varied,
};

use crate::some;

/// Half the distance between the places of a central difference.
const STEP: f64 = 1e-5;

/// Of the size of what is compared; the error of a central difference of coordinates of size ten.
const NEAR: f64 = 1e-6;

/// Homogeneous slopes; weights change slowly.
fn slopes(n: usize) -> impl Strategy<Value = Vec<DVec4>> {
    vec((some::point(), -0.1..0.1), n)
        .prop_map(|all| all.iter().map(|(p, w)| p.extend(*w)).collect())
}

fn varied_curve() -> impl Strategy<Value = VariedCurve> {
    some::curve().prop_flat_map(|curve| {
        let n = curve.control_points().len();
        slopes(n).prop_map(move |own| {
            let slopes = PointSlopes::new(3, n, vec![(1, own)]).unwrap();
            VariedCurve::new(Arc::new(curve.clone()), slopes).unwrap()
        })
    })
}

fn varied_surface() -> impl Strategy<Value = VariedSurface> {
    some::surface().prop_flat_map(|surface| {
        let n = surface.control_points().as_slice().len();
        slopes(n).prop_map(move |own| {
            let slopes = PointSlopes::new(2, n, vec![(0, own)]).unwrap();
            VariedSurface::new(Arc::new(surface.clone()), slopes).unwrap()
        })
    })
}

fn central(ask: impl Fn(f64) -> f64) -> f64 {
    (ask(STEP) - ask(-STEP)) / (2.0 * STEP)
}

fn is_near(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= NEAR * (1.0 + size + a.abs())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// C, C' and C'' at a place that moves too.
    #[test]
    fn derivatives_of_a_curve_grow_by_their_slopes(varied in varied_curve(), at in 0.1..0.9) {
        let t = varied.curve().domain().at(at);
        // Not where a piece ends within the step.
        prop_assume!(varied.curve().knots().breaks().iter().all(|knot| 3.0 * STEP < (knot - t).abs()));
        let jet = Jet::with_slopes(t, &[0.0, 0.5, 1.0]).unwrap();
        let found = varied.derivatives_beside(&jet, Side::Right, 2).unwrap();
        let moved = |h: f64| varied.moved(&[(1, h)]).unwrap();
        for (order, vector) in found.iter().enumerate() {
            let by_all = |h: f64| moved(h).derivatives_at(t + 0.5 * h, order)[order];
            let by_place = |h: f64| varied.curve().derivatives_at(t + h, order)[order];
            for (axis, part) in vector.iter().enumerate() {
                let size = by_all(0.0).length() * 1e3;
                let slopes = part.slopes();
                prop_assert!(slopes[0].abs() <= 0.0);
                prop_assert!(is_near(slopes[1], central(|h| by_all(h)[axis]), size));
                prop_assert!(is_near(slopes[2], central(|h| by_place(h)[axis]), size));
            }
        }
    }

    #[test]
    fn the_length_grows_by_its_slopes(varied in varied_curve()) {
        let domain = varied.curve().domain();
        let Ok(found) = varied.length(domain) else { return Ok(()) };
        let expected = central(|h| varied.moved(&[(1, h)]).unwrap().length(domain));
        prop_assert!(is_near(found.slopes()[1], expected, found.value()), "{found:?} {expected}");
    }

    #[test]
    fn derivatives_of_a_surface_grow_by_their_slopes(
        varied in varied_surface(),
        u in 0.1..0.9,
        v in 0.1..0.9,
    ) {
        let surface = varied.surface();
        let [u, v] = [surface.domain_u().at(u), surface.domain_v().at(v)];
        let is_inside = |knots: Vec<f64>, t: f64| knots.iter().all(|knot| 3.0 * STEP < (knot - t).abs());
        prop_assume!(is_inside(surface.knots_u().breaks(), u) && is_inside(surface.knots_v().breaks(), v));
        let jets = [Jet::with_slopes(u, &[0.3, 1.0]).unwrap(), Jet::with_slopes(v, &[-0.2, 0.0]).unwrap()];
        let found = varied.derivatives_at(jets.each_ref(), 2).unwrap();
        for (k, l) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let by_all = |h: f64| {
                let moved = varied.moved(&[(0, h)]).unwrap();
                moved.derivatives_at(u + 0.3 * h, v - 0.2 * h, 1).get(k, l)
            };
            let by_u = |h: f64| surface.derivatives_at(u + h, v, 1).get(k, l);
            for (axis, coordinate) in found[k][l].iter().enumerate() {
                let size = by_all(0.0).length() * 1e3;
                let slopes = coordinate.slopes();
                prop_assert!(is_near(slopes[0], central(|h| by_all(h)[axis]), size));
                prop_assert!(is_near(slopes[1], central(|h| by_u(h)[axis]), size));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5))]

    #[test]
    fn the_area_grows_by_its_slopes(varied in varied_surface()) {
        let area = |h: f64| Surface::from(varied.moved(&[(0, h)]).unwrap()).area().unwrap();
        let Ok(found) = varied.area_slopes() else { return Ok(()) };
        // Where the surface folds neither the area nor its slope is known to many digits.
        prop_assume!(found.relative_error < 1e-9 && area(0.0).1 < 1e-11);
        let expected = central(|h| area(h).0);
        prop_assert!(is_near(found.slopes[0], expected, area(0.0).0), "{found:?} {expected}");
    }
}

/// Sections of a skin, their control points one behind the other.
const SECTIONS: usize = 5;

/// Control points of each.
const ACROSS: usize = 4;

/// How each control point moves with an unknown of its own.
const ALONG: DVec3 = DVec3::new(0.3, 1.0, -0.7);

/// Cubics beside one another, their control points beside those of a grid.
fn sections(points: &[DVec3]) -> Vec<NurbsCurve> {
    let place = |idx: usize| {
        let [i, j] = [idx / ACROSS, idx % ACROSS].map(|k| 3.0 * k as f64);
        DVec3::new(i, j, 0.0) + 0.1 * points[idx]
    };
    let section = |i: usize| (ACROSS * i..ACROSS * (i + 1)).map(place).collect::<Vec<DVec3>>();
    (0..SECTIONS).map(|i| NurbsCurve::bezier(&section(i)).unwrap()).collect()
}

/// The skin of these, and where they stand: by a rule, or at places of their own.
fn skin(points: &[DVec3], rule: Option<SectionParameters>) -> (NurbsSurface, Vec<f64>) {
    let sections = sections(points);
    let at = match rule {
        Some(rule) => CompatibleSections::new(&sections).unwrap().parameters(rule, false).unwrap(),
        None => vec![0.0, 0.2, 0.5, 0.7, 1.0],
    };
    let builder = SkinBuilder::new(sections, Tolerance::DEFAULT).unaligned();
    (builder.parameters_at(at.clone()).build().unwrap(), at)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// Places and first derivatives, by an unknown for each control point of the sections.
    #[test]
    fn skins_grow_with_the_control_points_of_their_sections(
        points in vec(some::point(), SECTIONS * ACROSS),
        (u, v) in (0.0..1.0, 0.1..0.9),
    ) {
        let n = points.len();
        let vary = |(i, section): (usize, NurbsCurve)| {
            let one = |j: usize| {
                let mut own = vec![DVec4::ZERO; ACROSS];
                own[j] = (0.1 * ALONG).extend(0.0);
                (ACROSS * i + j, own)
            };
            let slopes = PointSlopes::new(n, ACROSS, (0..ACROSS).map(one).collect()).unwrap();
            Arc::new(VariedCurve::new(Arc::new(section), slopes).unwrap())
        };
        let varied: Vec<_> = sections(&points).into_iter().enumerate().map(vary).collect();
        let [at_u, at_v] = [u, v].map(|t| Jet::with_slopes(t, &vec![0.0; n]).unwrap());
        let rules =
            [SectionParameters::Average, SectionParameters::Centripetal, SectionParameters::Places];
        for rule in rules.map(Some).into_iter().chain([None]) {
            let (plain, at) = skin(&points, rule);
            // Not where a piece ends within the step.
            prop_assume!(plain.knots_v().breaks().iter().all(|knot| 1e-3 < (knot - v).abs()));
            let plain = Arc::new(plain);
            let found = VariedSurface::through_sections(&plain, (3, &at, rule), &varied);
            let found = found.unwrap().expect("slopes by the sections");
            prop_assert!(found.given() == &plain);
            let all = found.derivatives_at([&at_u, &at_v], 1).unwrap();
            for moving in 0..n {
                let beside = |h: f64| {
                    let mut points = points.clone();
                    points[moving] += h * ALONG;
                    skin(&points, rule).0.derivatives_at(u, v, 1)
                };
                let [ahead, behind] = [STEP, -STEP].map(beside);
                for (k, l) in [(0, 0), (0, 1), (1, 0)] {
                    let expected = (ahead.get(k, l) - behind.get(k, l)) / (2.0 * STEP);
                    for axis in 0..3 {
                        let slope = all[k][l][axis].slopes()[moving];
                        prop_assert!(is_near(slope, expected[axis], 10.0), "{rule:?} {slope} {expected}");
                    }
                }
            }
        }
    }
}

/// A sphere whose radius grows: every control point goes outward as far as it is.
fn growing_ball(radius: f64) -> VariedSurface {
    let ball = NurbsSurface::sphere(Frame::XY, radius).unwrap();
    let points = ball.control_points().as_slice();
    let outward: Vec<DVec4> = points.iter().map(|p| (p.truncate() / radius).extend(0.0)).collect();
    let slopes = PointSlopes::new(1, points.len(), vec![(0, outward)]).unwrap();
    VariedSurface::new(Arc::new(ball), slopes).unwrap()
}

/// d(4πr²)/dr = 8πr, d(4/3·πr³)/dr = 4πr².
#[test]
fn a_ball_grows_by_its_area_and_its_area_by_eight_pi_r() {
    let (varied, pi) = (growing_ball(1.5), std::f64::consts::PI);
    let area = varied.area_slopes().unwrap().slopes[0];
    assert!((area - 12.0 * pi).abs() < 1e-10 * area, "{area}");
    let volume = varied.volume_slopes(DVec3::ZERO).unwrap().slopes[0].abs();
    assert!((volume - 9.0 * pi).abs() < 1e-10 * volume, "{volume}");
}

/// What encloses nothing anew holds as much about any point.
#[test]
fn the_volume_of_a_closed_surface_grows_alike_about_any_point() {
    let varied = growing_ball(0.7);
    let about = |x: f64| varied.volume_slopes(DVec3::new(x, -x, 2.0 * x)).unwrap().slopes[0];
    assert!((about(0.0) - about(3.0)).abs() < 1e-10);
}

/// What is moved takes its centre along; what grows about its centre leaves it where it is.
#[test]
fn the_centre_of_a_ball_goes_where_the_ball_goes() {
    let (still, center) = (growing_ball(1.5), DVec3::new(0.0, 0.0, 0.0));
    let ball = Arc::clone(still.surface());
    let points = ball.control_points().as_slice();
    let along = points.iter().map(|p| (DVec3::new(2.0, -1.0, 0.5) * p.w).extend(0.0)).collect();
    let slopes = PointSlopes::new(1, points.len(), vec![(0, along)]).unwrap();
    let moved = VariedSurface::new(ball, slopes).unwrap();
    let (pi, about) = (std::f64::consts::PI, DVec3::new(3.0, 1.0, -2.0));
    let sign = still.volume_slopes(about).unwrap().slopes[0].signum();
    for (axis, speed) in [(DVec3::X, 2.0), (DVec3::Y, -1.0), (DVec3::Z, 0.5)] {
        let of = |varied: &VariedSurface| {
            let volume = varied.volume_moment_slopes(about, center, axis).unwrap().slopes[0];
            let area = varied.area_moment_slopes(center, axis).unwrap().slopes[0];
            [sign * volume / (4.5 * pi), area / (9.0 * pi)]
        };
        for (moved, still) in of(&moved).into_iter().zip(of(&still)) {
            assert!((moved - speed).abs() < 1e-10 && still.abs() < 1e-10, "{moved} {still}");
        }
    }
}

/// A circle of radius r has the circumference 2πr; that of weights that change alike does not change.
#[test]
fn a_circle_grows_by_two_pi_r() {
    let circle =
        NurbsCurve::circle(DVec3::ZERO, 2.0, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap();
    let points = circle.control_points();
    let outward = points.iter().map(|p| (p.truncate() / 2.0).extend(0.0)).collect();
    let heavier = points.to_vec();
    let slopes = PointSlopes::new(2, points.len(), vec![(0, outward), (1, heavier)]).unwrap();
    let varied = VariedCurve::new(Arc::new(circle), slopes).unwrap();
    let found = varied.length(varied.curve().domain()).unwrap();
    assert!((found.slopes()[0] - std::f64::consts::TAU).abs() < 1e-12);
    assert!(found.slopes()[1].abs() < 1e-12);
}

/// A leg that has no length has none that grows in proportion: |h| has no derivative at 0.
#[test]
fn a_leg_without_length_has_no_slope() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::X];
    let curve = NurbsCurve::polyline(&points).unwrap();
    let slopes =
        PointSlopes::new(1, 3, vec![(0, vec![DVec4::ZERO, DVec4::ZERO, DVec4::Y])]).unwrap();
    let varied = VariedCurve::new(Arc::new(curve), slopes).unwrap();
    assert!(varied.length(varied.curve().domain()).is_err());
}

/// Points that go on along x, so that neighbours are apart, and how they move.
pub(crate) fn moving_points() -> impl Strategy<Value = (Vec<DVec3>, Vec<DVec4>)> {
    vec((some::point(), some::point()), 2..12).prop_map(|all| {
        let place =
            |(i, (p, _)): (usize, &(DVec3, DVec3))| DVec3::new(4.0 * i as f64, 0.0, 0.0) + 0.15 * p;
        let speed = |(_, slope): &(DVec3, DVec3)| (0.2 * slope).extend(0.0);
        (all.iter().enumerate().map(place).collect(), all.iter().map(speed).collect())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// By parameters and knots that move along, at every condition of the ends.
    #[test]
    fn a_spline_through_points_grows_with_them(
        (points, slopes) in moving_points(),
        ends in proptest::sample::select(vec![Ends::Bessel, Ends::Natural, Ends::Quadratic, Ends::NotAKnot, Ends::Averaged]),
        degree in 2_usize..6,
        is_chord in proptest::bool::ANY,
        at in 0.0..1.0,
    ) {
        let rule = if is_chord { Parametrization::Chord } else { Parametrization::Centripetal };
        let degree = if ends == Ends::Averaged { degree } else { 3 };
        let fit = |points: &[DVec3]| {
            Interpolator::new(&rule.parameters(points).unwrap(), degree, ends).unwrap()
        };
        let spline = |h: f64| {
            let moved: Vec<DVec3> = points.iter().zip(&slopes).map(|(p, s)| p + h * s.truncate()).collect();
            fit(&moved).curve(&moved).unwrap()
        };
        let all = PointSlopes::new(2, points.len(), vec![(1, slopes.clone())]).unwrap();
        let fit = fit(&points);
        let varied = interpolate_varied((&fit, ends), rule, &points, &all).unwrap().unwrap();
        prop_assert!(**varied.given() == spline(0.0));
        let jet = Jet::with_slopes(at, &[0.0, 0.0]).unwrap();
        let found = varied.derivatives_beside(&jet, Side::Right, 1).unwrap();
        let is_far = fit.knots().breaks().iter().all(|knot| 1e-3 < (knot - at).abs());
        for (order, vector) in found.iter().enumerate().take(if is_far { 2 } else { 1 }) {
            let expected = |axis: usize| central(|h| spline(h).derivatives_at(at, order)[order][axis]);
            for (axis, part) in vector.iter().enumerate() {
                prop_assert!(is_near(part.slopes()[1], expected(axis), 10.0), "{part:?} {}", expected(axis));
            }
        }
        let length = varied.length(fit.knots().domain()).unwrap();
        let expected = central(|h| spline(h).length(fit.knots().domain()));
        prop_assert!(is_near(length.slopes()[1], expected, length.value()), "{length:?} {expected}");
    }
}

/// Points around the place (6, 0), of a border without bulges, and how they move: in the plane, or with it.
fn moving_ring() -> impl Strategy<Value = (Vec<DVec4>, Vec<DVec4>)> {
    let all = vec((0.0..1.0, some::point(), -0.1..0.1), 5..9);
    (all, proptest::bool::ANY).prop_map(|(all, is_plane_moving)| {
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / all.len() as f64;
        let place = |(i, (out, ..)): (usize, &(f64, DVec3, f64))| {
            let (sin, cos) = libm::sincos(angle(i));
            (DVec3::new(cos, sin, 0.0) * (2.0 + out) + DVec3::X * 6.0).extend(1.0)
        };
        let mut points: Vec<DVec4> = all.iter().enumerate().map(place).collect();
        let speed = |((_, speed, weight), point): (&(f64, DVec3, f64), &DVec4)| {
            let rise = if is_plane_moving { 0.3 + 0.2 * point.x - 0.1 * point.y } else { 0.0 };
            (0.1 * speed.with_z(0.0)).with_z(rise).extend(if is_plane_moving {
                0.0
            } else {
                *weight
            })
        };
        let mut slopes: Vec<DVec4> = all.iter().zip(&points).map(speed).collect();
        points.push(points[0]);
        slopes.push(slopes[0]);
        (points, slopes)
    })
}

/// A ring as a border of degree 2, and a disc that is a hole in it, both after a step.
fn region_at((points, slopes): &(Vec<DVec4>, Vec<DVec4>), h: f64) -> ([VariedCurve; 2], Region) {
    let moved: Vec<DVec4> = points.iter().zip(slopes).map(|(p, s)| p + h * s).collect();
    let knots = virote_kernel::KnotVector::uniform_clamped(2, points.len(), 1.0).unwrap();
    let border = NurbsCurve::new(knots, moved).unwrap();
    let speed =
        slopes.iter().map(|s| DVec3::Z * s.z).fold(DVec3::ZERO, |a, b| a + b) / slopes.len() as f64;
    let hole = NurbsCurve::ellipse(
        Frame::XY.at(DVec3::X * 6.0),
        [0.5 + 0.2 * h, 0.7],
        CircleForm::NinePoint,
    )
    .unwrap();
    let is_flat = speed.length() <= 0.0;
    let holes = if is_flat { vec![hole.clone()] } else { Vec::new() };
    let region = Region::new(&border, &holes, Tolerance::DEFAULT).unwrap();
    let outward = |p: &DVec4| DVec4::new(0.4 * (p.x - 6.0 * p.w), 0.0, 0.0, 0.0);
    let of_hole = hole.control_points().iter().map(outward).collect();
    let varied = |curve: NurbsCurve, own: Vec<DVec4>| {
        let slopes = PointSlopes::new(1, own.len(), vec![(0, own)]).unwrap();
        VariedCurve::new(curve.into(), slopes).unwrap()
    };
    ([varied(border, slopes.clone()), varied(hole, of_hole)], region)
}

/// The region with what varies along its borders.
fn varied_region(ring: &(Vec<DVec4>, Vec<DVec4>)) -> VariedRegion {
    let ([border, hole], region) = region_at(ring, 0.0);
    let mut borders = vec![vec![border]];
    if region.n_holes() == 1 {
        borders.push(vec![hole]);
    }
    VariedRegion::new(region.into(), borders).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn a_region_grows_with_its_borders(ring in moving_ring()) {
        let varied = varied_region(&ring);
        let region = |h: f64| region_at(&ring, h).1;
        let size = region(0.0).area();
        let area = central(|h| region(h).area());
        prop_assert!(is_near(varied.area_slopes().unwrap()[0], area, size));
        let length = central(|h| region(h).length());
        prop_assert!(is_near(varied.length_slopes().unwrap()[0], length, size));
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let inertia = |h: f64| region(h).mass().inertia;
        let second = |d: usize, e: usize| {
            varied.second_moment_slopes([axes[d], axes[e]]).unwrap()[0]
        };
        let trace = second(0, 0) + second(1, 1) + second(2, 2);
        for (d, &axis) in axes.iter().enumerate() {
            let place = central(|h| region(h).mass().centroid[d]);
            prop_assert!(is_near(varied.centroid_slopes(axis).unwrap()[0], place, size));
            for e in 0..3 {
                let expected = central(|h| inertia(h).col(e)[d]);
                let found = if d == e { trace - second(d, e) } else { -second(d, e) };
                prop_assert!(is_near(found, expected, 10.0 * size), "{found} {expected}");
            }
        }
    }
}

proptest! {
    // Solids take long to measure.
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn what_a_region_passes_grows_with_it(ring in moving_ring(), speed in some::point()) {
        let (varied, speed) = (std::sync::Arc::new(varied_region(&ring)), 0.1 * speed);
        let way = |h: f64| DVec3::new(0.5, -0.3, 2.0) + h * speed;
        let passed = |h: f64| Solid::extruded(&region_at(&ring, h).1, way(h), Tolerance::DEFAULT).unwrap();
        let prism = VariedSolid::new(
            passed(0.0).into(), varied.clone(), RegionWay::Along(way(0.0), vec![speed]),
        );
        let volume = |h: f64| passed(h).volume_mass().unwrap();
        let size = volume(0.0).amount;
        prop_assert!(is_near(prism.volume_slopes().unwrap()[0], central(|h| volume(h).amount), size));
        let area = central(|h| passed(h).area_mass().unwrap().amount);
        prop_assert!(is_near(prism.area_slopes().unwrap()[0], area, size));
        for (k, axis) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().enumerate() {
            let expected = central(|h| volume(h).centroid[k]);
            prop_assert!(is_near(prism.centroid_slopes(axis).unwrap()[0], expected, size));
        }

        // About an axis in the plane, where that stays.
        prop_assume!(varied.region().n_holes() == 1);
        let axis = Axis::new(DVec3::ZERO, DVec3::Y).unwrap();
        for (angle, turn) in [(2.0, 0.7), (-1.5, 0.4), (std::f64::consts::TAU, 0.0)] {
            let passed = |h: f64| {
                Solid::revolved(&region_at(&ring, h).1, axis, angle + h * turn, Tolerance::DEFAULT).unwrap()
            };
            let ring = VariedSolid::new(
                passed(0.0).into(), varied.clone(), RegionWay::About(axis, angle, vec![turn]),
            );
            let volume = |h: f64| passed(h).volume_mass().unwrap();
            let size = volume(0.0).amount;
            prop_assert!(is_near(ring.volume_slopes().unwrap()[0], central(|h| volume(h).amount), size));
            let Ok(found) = ring.centroid_slopes(DVec3::Y) else { continue };
            prop_assert!(is_near(found[0], central(|h| volume(h).centroid.y), size));
        }
    }
}
