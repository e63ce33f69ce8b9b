//! Laws of curves through points and near them.

use glam::{DAffine3, DVec3, DVec4};
use proptest::{
    collection, prop_assert, prop_assume, proptest,
    strategy::{Just, Strategy},
};
use virote_kernel::{
    Ends, GeomError, InputError, Interpolator, KnotVector, NurbsCurve, Parametrization, Side,
    approximate, approximate_within, lagrange,
};

use crate::some::{affine_map, are_near, point};

const SPACINGS: [Parametrization; 4] = [
    Parametrization::Uniform,
    Parametrization::Chord,
    Parametrization::Centripetal,
    Parametrization::Foley,
];
const FREE_ENDS: [Ends; 5] =
    [Ends::Bessel, Ends::Natural, Ends::Quadratic, Ends::NotAKnot, Ends::Averaged];

fn points(least: usize, most: usize) -> impl Strategy<Value = Vec<DVec3>> {
    collection::vec(point(), least..=most)
}

/// Parameters that increase, with steps between 1 and 50.
fn parameters(n: usize) -> impl Strategy<Value = Vec<f64>> {
    let running = |steps: Vec<f64>| {
        steps
            .into_iter()
            .scan(-3.0, |sum, step| Some(std::mem::replace(sum, *sum + step)))
            .collect()
    };
    collection::vec(1.0..50.0_f64, n).prop_map(running)
}

/// Data with a parameter each.
fn data() -> impl Strategy<Value = (Vec<DVec3>, Vec<f64>)> {
    points(4, 12).prop_flat_map(|points| {
        let n = points.len();
        (Just(points), parameters(n))
    })
}

/// Whether the curve passes the points, to the rounding of its control points.
fn passes(curve: &NurbsCurve, points: &[DVec3], parameters: &[f64]) -> bool {
    let size = curve.points().iter().map(|p| p.length()).fold(1.0, f64::max);
    points
        .iter()
        .zip(parameters)
        .all(|(&point, &t)| curve.point_at(t).distance(point) <= 1e-12 * size)
}

/// The largest jump of the derivatives up to an order at the inner knots, as a fraction of them.
fn jump(curve: &NurbsCurve, order: usize) -> f64 {
    let domain = curve.domain();
    let breaks = curve.knots().breaks();
    let sides = breaks[1..breaks.len() - 1].iter().map(|&t| {
        (
            curve.derivatives_beside(t, Side::Left, order),
            curve.derivatives_beside(t, Side::Right, order),
        )
    });
    let seam = (
        curve.derivatives_beside(domain.end(), Side::Left, order),
        curve.derivatives_beside(domain.start(), Side::Right, order),
    );
    let is_closed = curve.is_closed(1e-9);
    sides
        .chain(is_closed.then_some(seam))
        .flat_map(|(left, right)| left.into_iter().zip(right))
        .map(|(left, right)| left.distance(right) / (1.0 + left.length()))
        .fold(0.0, f64::max)
}

/// A cubic and its derivative.
fn cubic(t: f64) -> [DVec3; 2] {
    let [a, b] = [DVec3::new(1.0, -2.0, 0.5), DVec3::new(0.25, 1.0, -1.0)];
    let [c, d] = [DVec3::new(-0.5, 0.125, 2.0), DVec3::new(0.03, -0.02, 0.01)];
    [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + 3.0 * t * d)]
}

proptest! {
    #[test]
    fn a_spline_through_points_passes_them(points in points(2, 14)) {
        for spacing in SPACINGS {
            let Ok(parameters) = spacing.parameters(&points) else { continue };
            // Steps that differ by more amplify rounding.
            prop_assume!(parameters.windows(2).all(|pair| pair[1] - pair[0] > 1e-4));
            for ends in FREE_ENDS {
                let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
                prop_assert!(passes(&curve, &points, &parameters), "{spacing:?} {ends:?}");
            }
        }
    }

    #[test]
    fn a_spline_of_any_degree_passes_its_points((points, parameters) in data(), degree in 1..9_usize) {
        let curve = Interpolator::new(&parameters, degree, Ends::Averaged).unwrap().curve(&points).unwrap();
        prop_assert!(curve.degree() == degree.min(points.len() - 1));
        prop_assert!(curve.points().len() == points.len());
        prop_assert!(passes(&curve, &points, &parameters));
    }

    #[test]
    fn a_cubic_through_points_is_c2((points, parameters) in data()) {
        for ends in FREE_ENDS {
            let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            prop_assert!(jump(&curve, 2) < 1e-11, "{ends:?} {}", jump(&curve, 2));
        }
    }

    #[test]
    fn a_closed_spline_is_smooth_at_its_seam((points, parameters) in data(), degree in 1..7_usize) {
        let values = &points[..points.len() - 1];
        let curve = Interpolator::periodic(&parameters, degree).unwrap().curve(values).unwrap();
        prop_assert!(passes(&curve, values, &parameters));
        prop_assert!((curve.domain().end() - parameters[values.len()]).abs() < 1e-15);
        prop_assert!(curve.start().distance(curve.end()) < 1e-11);
        let degree = curve.degree();
        prop_assert!(jump(&curve, degree - 1) < 1e-9, "{degree} {}", jump(&curve, degree - 1));
    }

    #[test]
    fn interpolation_reproduces_cubics((_, parameters) in data(), f in 0.0..1.0_f64) {
        let scaled: Vec<f64> = parameters.iter().map(|t| t / 50.0).collect();
        let (values, slopes): (Vec<DVec3>, Vec<DVec3>) =
            scaled.iter().map(|&t| cubic(t)).map(|[value, slope]| (value, slope)).unzip();
        let n = scaled.len();
        let t = scaled[0] + f * (scaled[n - 1] - scaled[0]);
        let clamped = Interpolator::new(&scaled, 3, Ends::Clamped).unwrap();
        let curves = [
            clamped.curve_with_tangents(&values, [slopes[0], slopes[n - 1]]).unwrap(),
            Interpolator::new(&scaled, 3, Ends::NotAKnot).unwrap().curve(&values).unwrap(),
            Interpolator::new(&scaled, 3, Ends::Averaged).unwrap().curve(&values).unwrap(),
            Interpolator::with_derivatives(&scaled, 3).unwrap().curve_with_derivatives(&values, &slopes).unwrap(),
        ];
        for (i, curve) in curves.iter().enumerate() {
            prop_assert!(are_near(curve.point_at(t), cubic(t)[0], 1e-11), "{i}");
            prop_assert!(are_near(curve.derivatives_at(t, 1)[1], cubic(t)[1], 1e-9), "{i}");
        }
    }

    /// Of any degree that the values and slopes determine.
    #[test]
    fn splines_with_slopes_at_their_ends_reproduce_cubics((_, parameters) in data(), f in 0.0..1.0_f64, degree in 3..6_usize) {
        let scaled: Vec<f64> = parameters.iter().map(|t| t / 50.0).collect();
        let lifted = |[value, slope]: [DVec3; 2]| [value.extend(1.0), slope.extend(0.0)];
        let (values, slopes): (Vec<DVec4>, Vec<DVec4>) =
            scaled.iter().map(|&t| lifted(cubic(t))).map(|[value, slope]| (value, slope)).unzip();
        let n = scaled.len();
        let t = scaled[0] + f * (scaled[n - 1] - scaled[0]);
        for has_slope in [[true, true], [true, false], [false, true], [false, false]] {
            let fit = Interpolator::with_end_slopes(&scaled, degree, has_slope).unwrap();
            let n_slopes = has_slope.iter().filter(|&&has| has).count();
            prop_assert!(fit.knots().degree() == degree.min(n + n_slopes - 1));
            let ends = [slopes[0], slopes[n - 1]];
            let given = [0, 1].map(|end| has_slope[end].then_some(ends[end]));
            let points = fit.with_slopes_at_ends(&values, given).unwrap();
            let points: Vec<DVec3> = points.into_iter().map(DVec4::truncate).collect();
            prop_assert!(points.len() == n + n_slopes);
            let curve = NurbsCurve::polynomial(fit.knots().clone(), &points).unwrap();
            prop_assert!(are_near(curve.point_at(t), cubic(t)[0], 1e-9), "{has_slope:?}");
            prop_assert!(are_near(curve.derivatives_at(t, 1)[1], cubic(t)[1], 1e-7), "{has_slope:?}");
            // Other slopes, or one value more, do not belong to it.
            let others = [0, 1].map(|end| (!has_slope[end]).then_some(ends[end]));
            prop_assert!(fit.with_slopes_at_ends(&values, others).is_err());
            prop_assert!(fit.with_slopes_at_ends(&values[1..], given).is_err());
        }
    }

    #[test]
    fn derivatives_are_kept_at_the_points((points, parameters) in data(), degree in 2..4_usize) {
        let derivatives: Vec<DVec3> = points.iter().rev().copied().collect();
        let curve = Interpolator::with_derivatives(&parameters, degree).unwrap()
            .curve_with_derivatives(&points, &derivatives).unwrap();
        prop_assert!(curve.degree() == degree);
        prop_assert!(passes(&curve, &points, &parameters));
        for (&t, &derivative) in parameters.iter().zip(&derivatives) {
            prop_assert!(curve.derivatives_at(t, 1)[1].distance(derivative) < 1e-10);
        }
    }

    #[test]
    fn fits_are_affinely_invariant((points, parameters) in data(), map in affine_map(), f in 0.0..1.0_f64) {
        let image: Vec<DVec3> = points.iter().map(|&p| map.transform_point3(p)).collect();
        let t = parameters[0] + f * (parameters[points.len() - 1] - parameters[0]);
        for ends in FREE_ENDS {
            let fit = Interpolator::new(&parameters, 3, ends).unwrap();
            let [a, b] = [fit.curve(&points).unwrap(), fit.curve(&image).unwrap()];
            prop_assert!(are_near(map.transform_point3(a.point_at(t)), b.point_at(t), 1e-10), "{ends:?}");
        }
    }

    #[test]
    fn natural_ends_do_not_bend_and_quadratic_ones_are_parabolas((points, parameters) in data()) {
        for (ends, order) in [(Ends::Natural, 2), (Ends::Quadratic, 3)] {
            let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            for t in [parameters[0], parameters[points.len() - 1]] {
                prop_assert!(curve.derivatives_at(t, order)[order].length() < 1e-10, "{ends:?}");
            }
        }
    }

    #[test]
    fn the_lagrange_polynomial_passes_its_points((points, parameters) in data()) {
        let curve = lagrange(&points, &parameters).unwrap();
        prop_assert!(curve.degree() == points.len() - 1 && curve.n_segments() == 1);
        let size = curve.points().iter().map(|p| p.length()).fold(1.0, f64::max);
        for (&t, &point) in parameters.iter().zip(&points) {
            prop_assert!(curve.point_at(t).distance(point) < 1e-13 * size);
        }
    }
}

proptest! {
    #[test]
    fn approximation_keeps_the_ends_and_its_tolerance(points in points(4, 40), fraction in 0.001..0.3_f64) {
        let parameters = Parametrization::Chord.loose_parameters(&points).unwrap();
        let tolerance = 10.0 * fraction;
        let curve = approximate_within(&points, &parameters, 3, tolerance, false).unwrap();
        prop_assert!(curve.points().len() <= points.len());
        prop_assert!(curve.start().distance(points[0]) < 1e-15);
        prop_assert!(curve.end().distance(points[points.len() - 1]) < 1e-15);
        // The points of a fine sample are no nearer than the curve.
        let step = 1.0 / 4000.0;
        let speed = (0..=400)
            .map(|i| curve.derivatives_at(f64::from(i) / 400.0, 1)[1].length())
            .fold(0.0, f64::max);
        let sample = curve.sample(4001);
        for &p in &points {
            let nearest = sample.iter().map(|s| s.distance(p)).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest <= tolerance + step * speed);
        }
    }

    #[test]
    fn approximation_with_listed_parameters_keeps_them((points, parameters) in data(), tolerance in 0.01..3.0_f64) {
        let curve = approximate_within(&points, &parameters, 3, tolerance, true).unwrap();
        for (&p, &t) in points.iter().zip(&parameters) {
            prop_assert!(curve.point_at(t).distance(p) <= tolerance);
        }
    }

    #[test]
    fn the_residual_of_least_squares_is_orthogonal_to_the_basis((points, parameters) in data(), degree in 1..4_usize) {
        let n_control = degree + 1 + (points.len() - degree - 1) / 2;
        let curve = approximate(&points, &parameters, degree, n_control).unwrap();
        prop_assert!(curve.points().len() == n_control);
        let size = curve.points().iter().map(|p| p.length()).fold(1.0, f64::max);
        for i in 1..n_control - 1 {
            let mut bump = vec![DVec3::ZERO; n_control];
            bump[i] = DVec3::X;
            let basis = NurbsCurve::polynomial(curve.knots().clone(), &bump).unwrap();
            let sum: DVec3 = points
                .iter()
                .zip(&parameters)
                .map(|(&p, &t)| (p - curve.point_at(t)) * basis.point_at(t).x)
                .sum();
            prop_assert!(sum.length() < 1e-12 * size, "{i}: {}", sum.length());
        }
    }

    #[test]
    fn least_squares_reproduce_splines((points, parameters) in data()) {
        let n_control = (points.len() - points.len() / 4).max(4);
        let knots = KnotVector::spreading(3, n_control, &parameters).unwrap();
        let spline = NurbsCurve::polynomial(knots.clone(), &points[..knots.n_points()]).unwrap();
        let on_it: Vec<DVec3> = parameters.iter().map(|&t| spline.point_at(t)).collect();
        let found = approximate(&on_it, &parameters, 3, knots.n_points()).unwrap();
        for (a, b) in found.points().into_iter().zip(spline.points()) {
            prop_assert!(are_near(a, b, 1e-9));
        }
    }
}

fn along_x(xs: &[f64]) -> Vec<DVec3> {
    xs.iter().map(|&x| DVec3::new(x, 2.0 * x, -x)).collect()
}

#[test]
fn collinear_points_give_a_straight_curve() {
    let points = along_x(&[0.0, 1.0, 1.5, 4.0, 9.0, 10.0]);
    for spacing in SPACINGS {
        let parameters = spacing.parameters(&points).unwrap();
        for ends in FREE_ENDS {
            let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            for p in curve.sample(50) {
                assert!(
                    DVec3::new(p.x, 2.0 * p.x, -p.x).distance(p) < 1e-13,
                    "{spacing:?} {ends:?}"
                );
            }
        }
    }
}

#[test]
fn spacing_that_varies_a_million_times_is_passed() {
    let points: Vec<DVec3> = [0.0, 1.0, 1.000_001, 2.0, 2.000_001, 3.0, 4.0]
        .iter()
        .map(|&x| DVec3::new(x, f64::from((x * 3.0) as i32 % 2), 0.0))
        .collect();
    for spacing in SPACINGS {
        let parameters = spacing.parameters(&points).unwrap();
        for ends in FREE_ENDS {
            let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            for (&t, &p) in parameters.iter().zip(&points) {
                assert!(curve.point_at(t).distance(p) < 1e-9, "{spacing:?} {ends:?}");
            }
        }
    }
}

/// Farin's Bessel tangent at either end is that of the parabola through the three points there.
#[test]
fn bessel_ends_leave_along_the_parabolas_of_three_points() {
    let parameters = [0.0, 1.0, 4.0, 6.0, 9.0];
    let along = |t: f64| DVec3::new(t, t * t, 2.0 * t - t * t);
    // Only the point amid is off the parabola, so that the ends see no more than two of its points
    // and this one.
    for (off, start) in [(2, 0), (2, 4), (1, 0), (3, 4)] {
        let mut points = parameters.map(along);
        points[off] += DVec3::new(0.0, 3.0, -1.0);
        let [a, b, c] = if start == 0 { [0, 1, 2] } else { [4, 3, 2] };
        let between =
            |i: usize, j: usize| (points[j] - points[i]) / (parameters[j] - parameters[i]);
        // Newton's divided differences.
        let bent = (between(b, c) - between(a, b)) / (parameters[c] - parameters[a]);
        let expected = between(a, b) + bent * (parameters[a] - parameters[b]);
        let fit = Interpolator::new(&parameters, 3, Ends::Bessel).unwrap();
        let found = fit.curve(&points).unwrap().derivatives_at(parameters[start], 1)[1];
        assert!(found.distance(expected) < 1e-12, "{found} at {start}, not {expected}");
    }
}

#[test]
fn bessel_ends_on_three_points_are_their_parabola() {
    let points = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), DVec3::new(3.0, 9.0, 0.0)];
    let curve =
        Interpolator::new(&[0.0, 1.0, 3.0], 3, Ends::Bessel).unwrap().curve(&points).unwrap();
    assert!(curve.point_at(2.0).distance(DVec3::new(2.0, 4.0, 0.0)) < 1e-15);
}

#[test]
fn two_points_of_degree_three_are_a_line() {
    let points = [DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)];
    for ends in FREE_ENDS {
        let curve = Interpolator::new(&[0.0, 1.0], 3, ends).unwrap().curve(&points).unwrap();
        assert!(curve.point_at(0.25).distance(DVec3::new(0.25, 0.5, 0.75)) < 1e-15, "{ends:?}");
    }
}

#[test]
fn points_at_one_place_are_told_by_their_indices() {
    let points = along_x(&[0.0, 1.0, 1.0, 2.0]);
    for spacing in [Parametrization::Chord, Parametrization::Centripetal, Parametrization::Foley] {
        let found = spacing.parameters(&points);
        assert_eq!(
            found,
            Err(GeomError::Input(InputError::CoincidentPoints { first: 1, second: 2 })),
            "{spacing:?}"
        );
    }
    assert!(Parametrization::Uniform.parameters(&points).is_ok());
}

#[test]
fn a_rotated_fit_is_the_fit_of_rotated_points() {
    // Chord lengths do not change with rotations and scale with the model.
    let map = DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 2.0) / 3.0, 0.7)
        * DAffine3::from_scale(DVec3::splat(250.0));
    let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.5, 0.5], [4.0, 2.0]]
        .map(|[x, y]| DVec3::new(x, y, 0.0));
    let image = points.map(|p| map.transform_point3(p));
    for spacing in SPACINGS {
        let fit = |points: &[DVec3]| {
            let parameters = spacing.parameters(points).unwrap();
            Interpolator::new(&parameters, 3, Ends::Bessel).unwrap().curve(points).unwrap()
        };
        let (a, b) = (fit(&points), fit(&image));
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            let distance = map.transform_point3(a.point_at(t)).distance(b.point_at(t));
            assert!(distance < 1e-11, "{spacing:?} {distance}");
        }
    }
}

/// Splines that interpolate a sine of amplitude a and circular frequency w at knots h apart miss it by a(wh)⁴/384: those that
/// are nearest to its points take no more control points than that, few or many as the points may be.
#[test]
fn sines_take_no_more_control_points_than_interpolation_theory_says() {
    for frequency in 1..=6 {
        for n_points in [100, 500, 2500, 10_000] {
            for tolerance in [1e-1, 1e-2, 1e-3] {
                let turns = std::f64::consts::TAU * f64::from(frequency);
                let at = |i: usize| i as f64 / (n_points - 1) as f64;
                let point = |i: usize| DVec3::new(10.0 * at(i), libm::sin(turns * at(i)), 0.0);
                let points: Vec<DVec3> = (0..n_points).map(point).collect();
                let parameters = Parametrization::Chord.parameters(&points).unwrap();
                let curve = approximate_within(&points, &parameters, 3, tolerance, false).unwrap();
                let spans = turns * libm::pow(1.0 / (384.0 * tolerance), 0.25);
                let found = curve.control_points().len();
                let what = format!("{frequency} turns, {n_points} points within {tolerance}");
                assert!(found as f64 <= spans + 5.0, "{what}: {found}, {spans}");
                for &p in &points {
                    let distance = curve.closest(p, 1e-9).distance;
                    assert!(distance <= tolerance * (1.0 + 1e-9), "{what}: {distance}");
                }
            }
        }
    }
}

/// Splines that interpolate a circle at even parameters h apart miss it by h⁴/384; those nearest to its points take no more
/// control points than that.
#[test]
fn circles_take_no_more_control_points_than_interpolation_theory_says() {
    for (n_points, tolerance) in [(1001, 1e-3), (4001, 1e-5), (20_001, 1e-7)] {
        let at = |i: usize| std::f64::consts::TAU * i as f64 / (n_points - 1) as f64;
        let points: Vec<DVec3> =
            (0..n_points).map(|i| DVec3::new(libm::cos(at(i)), libm::sin(at(i)), 0.0)).collect();
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        let curve = approximate_within(&points, &parameters, 3, tolerance, false).unwrap();
        let spans = std::f64::consts::TAU / libm::pow(384.0 * tolerance, 0.25);
        let found = curve.control_points().len();
        assert!(found as f64 <= spans + 5.0, "{n_points} within {tolerance}: {found}, {spans}");
        for &p in points.iter().step_by(7) {
            let distance = curve.closest(p, 1e-3 * tolerance).distance;
            assert!(
                distance <= tolerance * (1.0 + 1e-6),
                "{n_points} within {tolerance}: {distance}"
            );
        }
    }
}

#[test]
fn a_bump_between_the_points_of_a_sample_is_kept() {
    for middle in [0.123, 0.5] {
        let at = |i: usize| i as f64 / 4999.0;
        // Some twelve of the points wide.
        let bump = |t: f64| libm::exp(-libm::pow(800.0 * (t - middle), 2.0));
        let points: Vec<DVec3> =
            (0..5000).map(|i| DVec3::new(10.0 * at(i), 0.01 * bump(at(i)), 0.0)).collect();
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        for tolerance in [3e-3, 1e-4] {
            for are_fixed in [false, true] {
                let curve =
                    approximate_within(&points, &parameters, 3, tolerance, are_fixed).unwrap();
                let worst =
                    points.iter().map(|&p| curve.closest(p, 1e-9).distance).fold(0.0, f64::max);
                assert!(worst <= tolerance * (1.0 + 1e-6), "{middle}, {tolerance}: {worst}");
            }
        }
    }
}

/// The length of a curve, by a fine polygon, beside that of the polygon of points.
fn detour(curve: &NurbsCurve, points: &[DVec3]) -> f64 {
    let (domain, n) = (curve.domain(), 20 * points.len());
    let places: Vec<DVec3> =
        (0..=n).map(|i| curve.point_at(domain.at(i as f64 / n as f64))).collect();
    let length = |way: &[DVec3]| way.windows(2).map(|ends| ends[0].distance(ends[1])).sum::<f64>();
    length(&places) / length(points)
}

#[test]
fn a_curve_near_points_makes_no_detours_between_them() {
    let mut state = 7_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for n in [20, 61, 201, 1501] {
        for tolerance in [0.2, 0.05, 1e-3] {
            let points: Vec<DVec3> =
                (0..n).map(|_| DVec3::new(random(), random(), random())).collect();
            let parameters = Parametrization::Chord.parameters(&points).unwrap();
            let curve = approximate_within(&points, &parameters, 3, tolerance, false).unwrap();
            let found = detour(&curve, &points);
            assert!(found < 1.25, "{n} points within {tolerance}: {found} times as long");
        }
    }
}

#[test]
fn noise_within_the_tolerance_is_neither_followed_nor_taken_for_corners() {
    for (n, most) in [(201, 14), (2001, 40), (10_001, 80)] {
        // Low discrepancy instead of chance: the same everywhere.
        let noise = |i: usize| (0.618_033_988_749_895 * i as f64).fract() - 0.5;
        let at = |i: usize| 20.0 * i as f64 / (n - 1) as f64;
        let point = |i: usize| DVec3::new(at(i), libm::sin(at(i)) + 0.1 * noise(i), 0.0);
        let points: Vec<DVec3> = (0..n).map(point).collect();
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        let curve = approximate_within(&points, &parameters, 3, 0.06, false).unwrap();
        assert!(curve.control_points().len() <= most, "{n}: {}", curve.control_points().len());
        // A corner is a knot as often as the degree.
        assert!(
            curve
                .knots()
                .breaks()
                .iter()
                .all(|&t| [0.0, 1.0].contains(&t) || curve.knots().multiplicity(t) == 1)
        );
    }
}

#[test]
fn as_many_control_points_as_points_stay_among_them() {
    for (n, degree) in [(30, 1), (50, 2), (100, 3), (100, 5), (400, 3)] {
        let points: Vec<DVec3> =
            (0..n).map(|i| DVec3::new(f64::from(i), libm::sin(f64::from(i) / 5.0), 0.0)).collect();
        let uneven: Vec<DVec3> = (0..n)
            .map(|i| DVec3::new(f64::from(i) + 0.4 * libm::sin(f64::from(i) * 1.7), 0.0, 0.0))
            .collect();
        let even: Vec<f64> = (0..n).map(|i| f64::from(i) / f64::from(n - 1)).collect();
        let chords = Parametrization::Chord.parameters(&uneven).unwrap();
        for parameters in [&even, &chords] {
            for fewer in [0, 1, 2, 4, 6, 10, n as usize / 4] {
                let n_control = n as usize - fewer;
                let curve = approximate(&points, parameters, degree, n_control).unwrap();
                let what = format!("{n_control} control points for {n} points, degree {degree}");
                for (&p, &t) in points.iter().zip(parameters) {
                    // What a sine of 31 points a wave leaves.
                    let allowed = if fewer == 0 { 1e-9 } else { 0.5 };
                    assert!(curve.point_at(t).distance(p) <= allowed, "{what}, at {t}");
                }
                let furthest = curve.points().iter().map(|p| p.y.abs()).fold(0.0, f64::max);
                assert!(furthest < 3.0, "{what}: {furthest}");
            }
        }
    }
}
