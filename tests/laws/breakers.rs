//! What breaks other geometry kernels: each input on which one of them was found wrong, slow or
//! silent, under a name that says it. Expected values are closed forms.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DAffine3, DVec3};
use virote_kernel::{
    CircleForm, ConstructionError, Curve, Ends, FitError, Frame, GeomError, InputError,
    Interpolator, KnotVector, NurbsCurve, Parametrization, Side, Tolerance, approximate,
    approximate_within, lagrange, make_compatible,
};

use crate::{curve::are_same, some::parameter};

const SPACINGS: [Parametrization; 4] = [
    Parametrization::Uniform,
    Parametrization::Chord,
    Parametrization::Centripetal,
    Parametrization::Foley,
];
const ENDS: [Ends; 5] =
    [Ends::Bessel, Ends::Natural, Ends::Quadratic, Ends::NotAKnot, Ends::Averaged];

fn plane(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

fn bezier(points: &[[f64; 2]]) -> NurbsCurve {
    NurbsCurve::bezier(&plane(points)).unwrap()
}

fn spline(knots: &[f64], points: &[[f64; 2]]) -> NurbsCurve {
    let degree = knots.len() - points.len() - 1;
    let knots = KnotVector::new(degree, knots.to_vec()).unwrap();
    NurbsCurve::polynomial(knots, &plane(points)).unwrap()
}

fn rational(weights: &[f64], points: &[[f64; 2]]) -> NurbsCurve {
    let knots = KnotVector::bezier(points.len() - 1).unwrap();
    NurbsCurve::rational(knots, &plane(points), weights).unwrap()
}

fn circle(radius: f64) -> NurbsCurve {
    NurbsCurve::circle(DVec3::ZERO, radius, DVec3::X, DVec3::Z, CircleForm::NinePoint).unwrap()
}

#[track_caller]
fn near(got: f64, expected: f64, tolerance: f64) {
    let apart = (got - expected).abs();
    assert!(apart <= tolerance * expected.abs().max(1.0), "{got} instead of {expected}");
}

#[track_caller]
fn near_point(got: DVec3, expected: DVec3, tolerance: f64) {
    assert!(got.distance(expected) <= tolerance, "{got} instead of {expected}");
}

/// The turning of a polygon against the other hand, summed.
fn backward_turning(points: &[DVec3]) -> f64 {
    let legs: Vec<DVec3> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let turns = legs.windows(2).map(|pair| pair[0].cross(pair[1]).z);
    turns.filter(|&turn| turn < 0.0).map(f64::abs).sum()
}

/// Interpolation and approximation.
mod fits {
    use super::*;

    #[test]
    fn duplicate_consecutive_points_are_told_and_uniform_parameters_take_them() {
        let points = plane(&[[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]]);
        for spacing in
            [Parametrization::Chord, Parametrization::Centripetal, Parametrization::Foley]
        {
            let found = spacing.parameters(&points);
            assert_eq!(
                found,
                Err(GeomError::Input(InputError::CoincidentPoints { first: 1, second: 2 }))
            );
        }
        let parameters = Parametrization::Uniform.parameters(&points).unwrap();
        for ends in ENDS {
            let curve = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            for (&t, &point) in parameters.iter().zip(&points) {
                near_point(curve.point_at(t), point, 1e-14);
            }
        }
    }

    #[test]
    fn spacing_of_one_to_a_million_does_not_swing_out() {
        // Two points of a circle a millionth apart; centripetal parameters are made for that.
        let at = |angle: f64| DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        let angles = [0.0, 0.5, 0.5 + 1e-6, 1.0, 1.5, 2.0];
        let points: Vec<DVec3> = angles.iter().map(|&angle| at(angle)).collect();
        for spacing in [Parametrization::Chord, Parametrization::Centripetal] {
            let parameters = spacing.parameters(&points).unwrap();
            let curve =
                Interpolator::new(&parameters, 3, Ends::Bessel).unwrap().curve(&points).unwrap();
            for (&t, &point) in parameters.iter().zip(&points) {
                near_point(curve.point_at(t), point, 1e-12);
            }
            for point in curve.sample(300) {
                assert!((point.length() - 1.0).abs() < 0.05, "{spacing:?}: {}", point.length());
            }
        }
    }

    #[test]
    fn collinear_points_stay_collinear() {
        let points: Vec<DVec3> = [0.0, 1.0, 1.001, 5.0, 5.5, 20.0]
            .map(|x| DVec3::new(x, 3.0 * x - 1.0, -2.0 * x))
            .to_vec();
        let along = DVec3::new(1.0, 3.0, -2.0).normalize();
        for spacing in SPACINGS {
            let parameters = spacing.parameters(&points).unwrap();
            for ends in ENDS {
                let curve =
                    Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
                for point in curve.sample(100) {
                    let off = (point - points[0]).cross(along).length();
                    assert!(off < 1e-12, "{spacing:?} {ends:?}: {off}");
                }
            }
        }
    }

    #[test]
    fn two_points_with_degree_three_are_the_line() {
        let points = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, 0.0, 5.0)];
        for ends in ENDS {
            let curve = Interpolator::new(&[0.0, 2.0], 3, ends).unwrap().curve(&points).unwrap();
            near_point(curve.point_at(0.5), points[0].lerp(points[1], 0.25), 1e-15);
        }
    }

    #[test]
    fn three_points_with_degree_three_are_passed_at_every_end_condition() {
        let points = plane(&[[0.0, 0.0], [1.0, 2.0], [4.0, 1.0]]);
        for ends in ENDS {
            let curve =
                Interpolator::new(&[0.0, 0.4, 1.0], 3, ends).unwrap().curve(&points).unwrap();
            for (t, point) in [0.0, 0.4, 1.0].into_iter().zip(&points) {
                near_point(curve.point_at(t), *point, 1e-14);
            }
        }
    }

    #[test]
    fn exactly_closed_data_make_a_periodic_curve_without_a_seam() {
        let ring = plane(&[[2.0, 0.0], [0.0, 2.0], [-3.0, 0.5], [-1.0, -2.0], [1.0, -1.0]]);
        let closed: Vec<DVec3> = ring.iter().copied().chain([ring[0]]).collect();
        let parameters = Parametrization::Chord.parameters(&closed).unwrap();
        let curve = Interpolator::periodic(&parameters, 3).unwrap().curve(&ring).unwrap();
        let domain = curve.domain();
        let before = curve.derivatives_beside(domain.end(), Side::Left, 2);
        let after = curve.derivatives_beside(domain.start(), Side::Right, 2);
        for (before, after) in before.iter().zip(&after) {
            near_point(*before, *after, 1e-12 * (1.0 + after.length()));
        }
        for (&t, &point) in parameters.iter().zip(&closed) {
            near_point(curve.point_at(t), point, 1e-14);
        }
    }

    /// A circle with a wobble that is no shape: twenty waves of half the amplitude.
    fn noisy_circle(amplitude: f64) -> Vec<DVec3> {
        let noise = |i: u32| {
            let x = libm::sin(f64::from(i) * 12.9898) * 43758.5453;
            2.0 * (x - x.floor()) - 1.0
        };
        let point = |i: u32| {
            let angle = f64::from(i) * FRAC_PI_2 / 200.0;
            let radius = 10.0 + amplitude * noise(i);
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
        };
        (0..=200).map(point).collect()
    }

    #[test]
    fn noisy_data_are_approximated_and_their_noise_is_not() {
        let points = noisy_circle(0.01);
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        let curve = approximate(&points, &parameters, 3, 6).unwrap();
        for point in curve.sample(500) {
            assert!((point.length() - 10.0).abs() < 0.01, "{}", point.length());
        }
        assert!(backward_turning(&curve.sample(500)) <= 0.0, "the curve waves");
        let within = approximate_within(&points, &parameters, 3, 0.02, false).unwrap();
        assert!(within.points().len() <= 8, "{} points follow the noise", within.points().len());
    }

    #[test]
    fn a_degree_above_the_number_of_points_is_lowered_or_told() {
        let points = plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
        let parameters = [0.0, 0.5, 1.0];
        let curve =
            Interpolator::new(&parameters, 9, Ends::Averaged).unwrap().curve(&points).unwrap();
        assert_eq!(curve.degree(), 2);
        let refused = approximate(&points, &parameters, 3, 4);
        assert!(refused.is_err(), "{refused:?}");
    }

    #[test]
    fn a_fit_of_degree_one_is_the_polygon() {
        let points = plane(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [5.0, 5.0]]);
        let parameters = [0.0, 0.2, 0.5, 1.0];
        let curve =
            Interpolator::new(&parameters, 1, Ends::Averaged).unwrap().curve(&points).unwrap();
        assert_eq!(curve.degree(), 1);
        for (point, expected) in curve.points().into_iter().zip(&points) {
            near_point(point, *expected, 1e-15);
        }
    }

    #[test]
    fn a_kink_in_the_data_is_kept_within_the_tolerance() {
        let leg = |i: u32| if i <= 50 { [f64::from(i), 0.0] } else { [50.0, f64::from(i) - 50.0] };
        let points = plane(&(0..=100).map(leg).collect::<Vec<_>>());
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        let curve = approximate_within(&points, &parameters, 3, 0.01, false).unwrap();
        for &point in &points {
            let distance = curve.closest(point, 1e-9).distance;
            assert!(distance <= 0.01 * (1.0 + 1e-9), "{point} is missed by {distance}");
        }
        // Away from the corner the legs are straight.
        near(curve.closest(DVec3::new(20.5, 0.0, 0.0), 1e-9).distance, 0.0, 0.011);
    }

    #[test]
    fn the_function_of_runge_swings_out_as_a_polynomial_and_not_as_a_spline() {
        let runge = |x: f64| DVec3::new(x, 1.0 / (1.0 + 25.0 * x * x), 0.0);
        let points: Vec<DVec3> = (0..=14).map(|i| runge(f64::from(i) / 7.0 - 1.0)).collect();
        let parameters: Vec<f64> = (0..=14).map(|i| f64::from(i) / 14.0).collect();
        let highest =
            |curve: &NurbsCurve| curve.sample(500).iter().map(|p| p.y.abs()).fold(0.0, f64::max);
        assert!(1.5 < highest(&lagrange(&points, &parameters).unwrap()));
        for ends in ENDS {
            let spline = Interpolator::new(&parameters, 3, ends).unwrap().curve(&points).unwrap();
            assert!(highest(&spline) < 1.01, "{ends:?}");
        }
    }

    #[test]
    fn bessel_ends_on_three_points_are_the_parabola_through_them() {
        let parabola = |t: f64| DVec3::new(t, t * t - 3.0 * t, 2.0 * t * t);
        let points = [0.0, 0.3, 1.0].map(parabola);
        let curve =
            Interpolator::new(&[0.0, 0.3, 1.0], 3, Ends::Bessel).unwrap().curve(&points).unwrap();
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            near_point(curve.point_at(t), parabola(t), 1e-14);
        }
    }

    #[test]
    fn natural_ends_have_no_burrs() {
        // A quarter circle: natural ends are straight there, but do not overshoot.
        let points: Vec<DVec3> = (0..=8)
            .map(|i| f64::from(i) * FRAC_PI_2 / 8.0)
            .map(|a| DVec3::new(libm::cos(a), libm::sin(a), 0.0))
            .collect();
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        let curve =
            Interpolator::new(&parameters, 3, Ends::Natural).unwrap().curve(&points).unwrap();
        for point in curve.sample(400) {
            near(point.length(), 1.0, 2e-3);
        }
        assert!(backward_turning(&curve.sample(400)) < 1e-12);
    }
}

/// The nearest point of a curve.
mod feet {
    use super::*;

    /// The distance to the nearest of many samples, which no nearest point may exceed.
    fn sampled(curve: &NurbsCurve, p: DVec3) -> f64 {
        curve.sample(5000).iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_wave_is_never_missed_from_anywhere() {
        let points: Vec<[f64; 2]> = (0..24)
            .map(|i| [f64::from(i), 4.0 * libm::sin(1.7 * f64::from(i)) + 0.1 * f64::from(i)])
            .collect();
        let knots = KnotVector::uniform_clamped(3, points.len(), 1.0).unwrap();
        let curve = NurbsCurve::polynomial(knots, &plane(&points)).unwrap();
        for i in 0..20 {
            for j in 0..10 {
                let p = DVec3::new(f64::from(i) * 1.7 - 5.0, f64::from(j) * 2.1 - 9.0, 0.5);
                let foot = curve.closest(p, 1e-9);
                assert!(foot.distance <= sampled(&curve, p) + 1e-12, "from {p}");
                near_point(curve.point_at(foot.parameter), foot.point, 1e-14);
            }
        }
    }

    #[test]
    fn the_centre_of_a_circle_has_the_radius_as_its_distance() {
        for form in CircleForm::ALL {
            let circle = NurbsCurve::circle(DVec3::ONE, 2.5, DVec3::X, DVec3::Y, form).unwrap();
            let foot = circle.closest(DVec3::ONE, 1e-9);
            near(foot.distance, 2.5, 1e-14);
            near(
                circle.closest(DVec3::new(1.0, 30.0, 1.0), 1e-9).distance,
                libm::hypot(29.0, 2.5),
                1e-13,
            );
        }
    }

    #[test]
    fn a_point_on_the_seam_is_found_on_it() {
        let foot = circle(2.0).closest(DVec3::new(2.0, 0.0, 0.0), 1e-9);
        near(foot.distance, 0.0, 1e-15);
        assert!(foot.parameter <= 1e-12 || 1.0 - 1e-12 <= foot.parameter);
        near_point(
            circle(2.0).closest(DVec3::new(9.0, 0.0, 1.0), 1e-9).point,
            DVec3::new(2.0, 0.0, 0.0),
            1e-9,
        );
    }

    #[test]
    fn a_cusp_is_the_nearest_point_of_what_lies_before_its_tip() {
        // (t², t³) points its tip along −x.
        let coefficients = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y];
        let domain = virote_kernel::Interval::new(-1.0, 1.0).unwrap();
        let curve = NurbsCurve::power_form(&coefficients, domain).unwrap();
        let foot = curve.closest(DVec3::new(-3.0, 0.0, 0.0), 1e-9);
        near(foot.distance, 3.0, 1e-13);
        near_point(foot.point, DVec3::ZERO, 1e-9);
    }

    #[test]
    fn a_spiral_of_seven_turns_has_its_own_turn_nearest() {
        let spiral = |turn: f64| {
            let angle = turn * TAU;
            DVec3::new(libm::cos(angle), libm::sin(angle), 0.05 * turn)
        };
        let helix = NurbsCurve::helix(Frame::XY, 1.0, 0.05, 7.0, 1e-9).unwrap();
        for i in 0..140 {
            let turn = f64::from(i) / 20.0;
            let out = spiral(turn) * DVec3::new(1.3, 1.3, 1.0);
            let foot = helix.closest(out, 1e-12);
            near_point(foot.point, spiral(turn), 1e-4);
            assert!((foot.parameter * 7.0 - turn).abs() < 0.01, "turn {turn}");
            assert!(foot.distance <= sampled(&helix, out) + 1e-12);
        }
    }

    #[test]
    fn a_point_a_million_away_finds_its_end_or_its_side() {
        let curve = bezier(&[[0.0, 0.0], [1.0, 3.0], [2.0, -3.0], [3.0, 0.0]]);
        let foot = curve.closest(DVec3::new(-1e6, 0.0, 0.0), 1e-9);
        near_point(foot.point, DVec3::ZERO, 1e-9);
        let above = curve.closest(DVec3::new(1.0, 1e6, 0.0), 1e-9);
        let highest = curve.bounds().max;
        near(above.point.y, highest.y, 1e-7);
    }

    #[test]
    fn feet_in_the_last_two_hundredths_of_the_domain_are_found() {
        let curve = bezier(&[[0.0, 0.0], [1.0, 3.0], [2.0, -3.0], [3.0, 0.0]]);
        for t in [0.98, 0.99, 0.995, 0.998, 0.9999, 1.0 - 1e-9] {
            let [point, velocity] = [0, 1].map(|k| curve.derivatives_at(t, 1)[k]);
            let out = point + 0.01 * velocity.cross(DVec3::Z).normalize();
            let foot = curve.closest(out, 1e-12);
            near(foot.distance, 0.01, 1e-10);
            near(foot.parameter, t, 1e-8);
        }
    }

    #[test]
    fn a_curve_that_stays_at_one_point_is_as_far_as_that_point() {
        let still = bezier(&[[1.0, 1.0], [1.0, 1.0], [1.0, 1.0]]);
        near(still.closest(DVec3::new(4.0, 5.0, 0.0), 1e-9).distance, 5.0, 1e-15);
    }
}

/// Arc length.
mod lengths {
    use super::*;

    fn length(curve: &NurbsCurve) -> f64 {
        curve.length(curve.domain())
    }

    #[test]
    fn the_length_of_a_crossed_square_with_its_cusp() {
        // P' = (3 − 12t + 12t², 3 − 6t), twice over half: with s = 1 − 2t it is 3√(s⁴ + s²).
        let curve = bezier(&[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]);
        let half = 1.5 * (std::f64::consts::SQRT_2 * 2.0 - 1.0) / 3.0;
        near(length(&curve), 2.0 * half, 1e-13);
    }

    #[test]
    fn the_length_of_the_semicubical_parabola() {
        let coefficients = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y];
        let part = |t: f64| (libm::pow(4.0 + 9.0 * t * t, 1.5) - 8.0) / 27.0;
        for (from, to) in [(-1.0, 2.0), (-1.0, 1.0), (-0.001, 1.0), (0.0, 3.0)] {
            let domain = virote_kernel::Interval::new(from, to).unwrap();
            let curve = NurbsCurve::power_form(&coefficients, domain).unwrap();
            near(length(&curve), part(from) + part(to), 1e-12);
        }
    }

    #[test]
    fn the_length_of_a_quarter_circle_whose_weights_are_one_to_a_thousand() {
        // The same arc by any ratio: weights 1, cos·k, k².
        for k in [1e-3, 1.0, 1e3] {
            let weights = [1.0, k * std::f64::consts::FRAC_1_SQRT_2, k * k];
            let arc = rational(&weights, &[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
            near(length(&arc), FRAC_PI_2, 1e-12);
            let middle = arc.parameter_at_length(FRAC_PI_2 / 2.0).unwrap();
            let expected = DVec3::new(1.0, 1.0, 0.0) * std::f64::consts::FRAC_1_SQRT_2;
            near_point(arc.point_at(middle), expected, 1e-11);
        }
    }

    #[test]
    fn a_nearly_straight_curve_is_as_long_as_its_series_says() {
        // y = h·x·(1 − x)·4: length 1 + 8h²/3 − 32h⁴/5 + 256h⁶/7 − …
        let parabola = |h: f64| bezier(&[[0.0, 0.0], [0.5, 2.0 * h], [1.0, 0.0]]);
        for h in [1e-2, 1e-4, 1e-6, 1e-9, 0.0] {
            let s = h * h;
            let series = 1.0 + 8.0 * s / 3.0 - 32.0 * s * s / 5.0 + 256.0 * s * s * s / 7.0;
            near(length(&parabola(h)), series, 1e-11);
        }
    }

    #[test]
    fn the_length_of_a_parabola_is_its_closed_form() {
        // y = x² over −3..3.
        let curve = bezier(&[[-3.0, 9.0], [0.0, -9.0], [3.0, 9.0]]);
        near(length(&curve), 3.0 * 37.0_f64.sqrt() + 0.5 * libm::asinh(6.0), 1e-13);
    }

    #[test]
    fn the_length_of_every_form_of_a_circle_is_two_pi_r() {
        for form in CircleForm::ALL {
            let circle = NurbsCurve::circle(DVec3::ONE, 7.0, DVec3::X, DVec3::Y, form).unwrap();
            near(length(&circle), 7.0 * TAU, 1e-13);
        }
    }

    #[test]
    fn the_length_of_a_helix_is_its_closed_form() {
        let helix = NurbsCurve::helix(Frame::XY, 2.0, 3.0, 4.5, 1e-9).unwrap();
        near(length(&helix), 4.5 * libm::hypot(2.0 * TAU, 3.0), 1e-9);
    }

    #[test]
    fn length_is_inverted_through_a_cusp() {
        let coefficients = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y];
        let domain = virote_kernel::Interval::new(-1.0, 1.0).unwrap();
        let curve = NurbsCurve::power_form(&coefficients, domain).unwrap();
        let part = |t: f64| (libm::pow(4.0 + 9.0 * t * t, 1.5) - 8.0) / 27.0;
        for t in [-0.9, -0.5, -0.1, 0.1, 0.5, 0.9] {
            let length = part(1.0) + part(t) * f64::signum(t);
            near(curve.parameter_at_length(length).unwrap(), t, 1e-10);
        }
        near(curve.parameter_at_length(part(1.0)).unwrap(), 0.0, 1e-5);
    }
}

/// Curves on one knot vector.
mod knots {
    use super::*;

    const ZIGZAG: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 3.0], [2.0, -1.0], [3.0, 2.0], [4.0, 0.0]];

    /// A clamped cubic with one knot.
    fn with_knot(t: f64) -> NurbsCurve {
        spline(&[0.0, 0.0, 0.0, 0.0, t, 1.0, 1.0, 1.0, 1.0], &ZIGZAG)
    }

    /// Brings the curves to one basis, from which they stay within a fraction of their size; the
    /// inner knots, of which none stands more often than the degree.
    #[track_caller]
    fn merged_within(curves: &[NurbsCurve], fraction: f64) -> Vec<f64> {
        let both = make_compatible(curves).unwrap();
        for (curve, before) in both.iter().zip(curves) {
            assert_eq!(curve.knots(), both[0].knots());
            assert!(are_same(before, curve, fraction), "a curve moved");
            for (t, times) in curve.knots().distinct() {
                let is_end = t <= curve.domain().start() || curve.domain().end() <= t;
                assert!(times <= curve.degree() + usize::from(is_end), "{t} stands {times} times");
            }
        }
        let domain = both[0].domain();
        let inner = both[0].knots().breaks();
        inner.into_iter().filter(|&t| domain.start() < t && t < domain.end()).collect()
    }

    #[track_caller]
    fn merged(curves: &[NurbsCurve]) -> Vec<f64> {
        merged_within(curves, 1e-12)
    }

    #[test]
    fn knots_apart_by_rounding_are_one() {
        let other = 0.1 + 0.2;
        assert!(0.3 < other);
        assert_eq!(merged(&[with_knot(0.3), with_knot(other)]).len(), 1);
        assert_eq!(merged_within(&[with_knot(0.5), with_knot(0.5 + 1e-13)], 1e-11).len(), 1);
    }

    #[test]
    fn knots_a_billionth_apart_are_one_and_the_curves_move_by_no_more() {
        assert_eq!(merged_within(&[with_knot(0.5), with_knot(0.5 + 1e-9)], 1e-8).len(), 1);
    }

    #[test]
    fn knots_a_millionth_apart_are_kept_and_nothing_moves() {
        assert_eq!(merged(&[with_knot(0.5), with_knot(0.5 + 1e-6)]).len(), 2);
    }

    #[test]
    fn clusters_that_chain_across_the_limit_end_on_one_set_of_knots() {
        // Each within the limit of its neighbour, the first and the last not of one another.
        for step in [0.7e-12, 1.4e-9] {
            let curves: Vec<NurbsCurve> =
                (0..6).map(|i| with_knot(0.5 + f64::from(i) * step)).collect();
            let inner = merged_within(&curves, 1e-7);
            assert!((1..=6).contains(&inner.len()));
            for pair in inner.windows(2) {
                assert!(1e-9 < pair[1] - pair[0], "a span is left that is rounding");
            }
        }
    }

    #[test]
    fn domains_of_one_and_of_a_million_become_one() {
        let long = with_knot(0.25).reparametrized(virote_kernel::Interval::new(0.0, 1e6).unwrap());
        assert_eq!(merged(&[with_knot(0.25), long.clone()]), [0.25]);
        assert_eq!(merged(&[long, with_knot(0.25)]), [0.25e6]);
    }

    #[test]
    fn a_periodic_and_a_clamped_curve_share_their_knots() {
        let ring = NurbsCurve::uniform(3, &plane(&ZIGZAG), true).unwrap();
        assert_eq!(merged(&[ring, with_knot(0.5)]), [1.0, 2.0, 2.5, 3.0, 4.0]);
    }

    #[test]
    fn a_corner_against_a_smooth_curve_stays_a_corner() {
        let corner = NurbsCurve::polyline(&plane(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]))
            .unwrap()
            .elevate_degree(3)
            .unwrap();
        let curves = make_compatible(&[corner.clone(), with_knot(0.5)]).unwrap();
        assert_eq!(curves[0].knots().multiplicity(1.0), 3);
        let [before, after] =
            [Side::Left, Side::Right].map(|side| curves[0].tangent_at(1.0, side).unwrap());
        near_point(before, DVec3::X, 1e-14);
        near_point(after, DVec3::Y, 1e-14);
        merged(&[corner, with_knot(0.5)]);
    }

    #[test]
    fn a_triple_knot_and_a_single_one_beside_it_do_not_add_up() {
        let triple = spline(
            &[0.0, 0.0, 0.0, 0.0, 0.744, 0.744, 0.744, 1.0, 1.0, 1.0, 1.0],
            &[[0.0, 0.0], [1.0, 2.0], [2.0, 2.0], [3.0, 0.0], [4.0, 1.0], [5.0, 5.0], [6.0, 0.0]],
        );
        for single in [0.745, 0.744 + 1e-9, 0.744 + 1e-13] {
            let inner = merged_within(&[triple.clone(), with_knot(single)], 1e-8);
            assert_eq!(inner.len(), if single < 0.7445 { 1 } else { 2 });
        }
    }
}

/// Other degrees, and places beside.
mod degrees {
    use super::*;

    #[test]
    fn elevation_then_reduction_comes_back() {
        let curve = spline(
            &[0.0, 0.0, 0.0, 0.0, 0.3, 0.7, 0.7, 1.0, 1.0, 1.0, 1.0],
            &[[0.0, 0.0], [1.0, 4.0], [3.0, 5.0], [4.0, -2.0], [6.0, 0.0], [7.0, 3.0], [9.0, 1.0]],
        );
        for degree in 4..=9 {
            let back = curve.elevate_degree(degree).unwrap().reduced(Some(3), 1e-9).unwrap();
            assert_eq!(back.knots(), curve.knots());
            for (a, b) in back.points().into_iter().zip(curve.points()) {
                near_point(a, b, 1e-12 * 9.0);
            }
        }
    }

    #[test]
    fn a_true_cubic_does_not_become_a_parabola_in_silence() {
        // The nearest parabola in the middle is a quarter of the third difference times √3/9·… away;
        // the refusal tells no less than the true distance of the best one, |Δ³|/32 of the ends kept.
        let cubic = bezier(&[[0.0, 0.0], [1.0, 3.0], [2.0, -3.0], [3.0, 0.0]]);
        match cubic.reduced(Some(2), 1e-6) {
            Err(GeomError::Fit(FitError::NotReducible { degree: 2, error, tolerance })) => {
                assert!(0.5 < error && error < 3.0, "{error}");
                assert!(tolerance <= 1e-6);
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn rational_elevation_keeps_the_radius_of_a_circle() {
        for form in CircleForm::ALL {
            let mut circle =
                NurbsCurve::circle(DVec3::ZERO, 3.0, DVec3::X, DVec3::Z, form).unwrap();
            for _ in 0..4 {
                circle = circle.elevate_degree(circle.degree() + 1).unwrap();
                for point in circle.sample(200) {
                    near(point.length(), 3.0, 1e-14);
                }
            }
        }
    }

    #[test]
    fn elevated_knots_stand_as_often_as_their_continuity_needs() {
        let curve = spline(
            &[0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0],
            &[[0.0, 0.0], [1.0, 4.0], [3.0, 5.0], [4.0, -2.0], [6.0, 0.0], [7.0, 3.0]],
        );
        let elevated = curve.elevate_degree(5).unwrap();
        assert_eq!(elevated.knots().multiplicity(1.0), 4);
        assert_eq!(elevated.knots().multiplicity(2.0), 5);
    }

    #[test]
    fn an_offset_inward_beyond_the_least_radius_is_not_the_curve_itself() {
        // Half axes 3 and 2: the curvature at the tips is 3/4, its radius 4/3.
        let ellipse = NurbsCurve::ellipse(Frame::XY, [3.0, 2.0], CircleForm::NinePoint).unwrap();
        for distance in [0.8, 1.3, 4.0 / 3.0] {
            let offset = ellipse.offset(-distance, DVec3::Z, Tolerance::DEFAULT).unwrap();
            for point in offset.curve.sample(300) {
                let from = ellipse.closest(point, 1e-9).distance;
                near(from, distance, 2e-6);
            }
        }
    }

    #[test]
    fn circles_that_are_offset_by_their_radius_vanish_and_say_so() {
        let offset = circle(2.0).offset(-2.0, DVec3::Z, Tolerance::DEFAULT);
        assert!(
            matches!(
                offset,
                Err(GeomError::Construction(ConstructionError::VanishingOffset { .. }))
            ),
            "{offset:?}"
        );
        let smaller = circle(2.0).offset(-0.5, DVec3::Z, Tolerance::DEFAULT).unwrap();
        for point in smaller.curve.sample(100) {
            near(point.length(), 1.5, 1e-14);
        }
    }
}

#[test]
fn closed_forms_of_the_helix_hold_to_its_tolerance() {
    let (r, c) = (2.0, 3.0 / TAU);
    let helix = Curve::from(NurbsCurve::helix(Frame::XY, r, 3.0, 2.0, 1e-12).unwrap());
    for i in 1..20 {
        let local = helix.local_at(f64::from(i) / 20.0 + 0.001, Side::Right).unwrap();
        near(local.curvature().unwrap(), r / (r * r + c * c), 1e-6);
        near(local.torsion().unwrap(), c / (r * r + c * c), 1e-3);
    }
}

#[test]
fn curvature_at_weights_of_one_to_a_thousand_is_that_of_the_circle() {
    for k in [1e-3, 1.0, 1e3] {
        let weights = [1.0, k * std::f64::consts::FRAC_1_SQRT_2, k * k];
        let arc = Curve::from(rational(&weights, &[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]));
        for f in [0.0, 0.001, 0.1, 0.5, 0.9, 0.999, 1.0] {
            let local = arc.local_at(f, Side::Right).unwrap();
            near(local.curvature().unwrap(), 1.0, 1e-10);
            near_point(local.center_of_curvature().unwrap(), DVec3::ZERO, 1e-10);
        }
    }
}

#[test]
fn everything_is_the_same_far_from_the_origin_to_the_rounding_there() {
    let curve = bezier(&[[0.0, 0.0], [1.0, 3.0], [2.0, -3.0], [3.0, 0.0]]);
    let map = DAffine3::from_translation(DVec3::splat(1e6));
    let far = curve.transformed(&map);
    near(far.length(far.domain()), curve.length(curve.domain()), 1e-9);
    for f in [0.1, 0.5, 0.8] {
        let t = parameter(&curve, f);
        let local = |c: &NurbsCurve| {
            Curve::from(c.clone()).local_at(t, Side::Right).unwrap().curvature().unwrap()
        };
        near(local(&far), local(&curve), 1e-7);
    }
}
