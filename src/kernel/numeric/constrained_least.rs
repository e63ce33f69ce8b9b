//! The least value of a function of several unknowns, within bounds and under conditions.
//!
//! Sequential quadratic programming: each step goes to where the function's quadratic model is least under
//! the conditions' linear ones, as far as a penalty on broken conditions falls with it. The model learns its
//! curvature from the gradients on the way. Nocedal & Wright, *Numerical Optimization*, ch. 18: algorithm
//! 18.3, with the damped updates of procedure 18.2 and the corrections of §18.3 where a step is refused.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_problem::{LeastEnd, LeastProblem},
    least_rounds::Ended,
};
use crate::ceiling::CONSTRAINED_LOOKS;

/// What a search for a least value found.
///
/// ```
/// use virote_kernel::{Answers, ConstrainedLeast, LeastProblem};
///
/// let problem = LeastProblem { start: &[1.0], bounds: &[[0.0, 4.0]], n_equations: 0 };
/// let found: ConstrainedLeast =
///     problem.find(|x, _| Ok::<_, ()>(Answers::from(vec![(x[0] - 3.0) * (x[0] - 3.0)])))?;
/// assert!((found.unknowns[0] - 3.0).abs() < 1e-6 && found.has_differences);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ConstrainedLeast {
    /// The best place.
    pub unknowns: Vec<f64>,
    /// What the functions are there.
    pub values: Vec<f64>,
    /// How it ended.
    pub end: LeastEnd,
    /// How often the functions were asked, for values or for gradients.
    pub n_evaluations: usize,
    /// Whether gradients were taken by differences.
    pub has_differences: bool,
}

impl LeastProblem<'_> {
    /// The best place near the start. The functions answer with the value that is to be least, then with
    /// those that are to be zero, then with those that are not to be negative; where one has no finite value
    /// the search goes no further.
    ///
    /// # Errors
    /// Those of the functions.
    pub fn find<E>(
        &self,
        functions: impl FnMut(&[f64], Wanted) -> Result<Answers, E>,
    ) -> Result<ConstrainedLeast, E> {
        let mut asked = CountedFunctions::new(functions);
        let Ended { place: unknowns, values, end } = self.rounds(&mut asked)?;
        Ok(ConstrainedLeast {
            unknowns,
            values,
            end,
            n_evaluations: asked.n_evaluations,
            has_differences: asked.has_differences,
        })
    }

    /// The best of some places that are spread over the bounds, all of which are finite: the one with the
    /// least values under zero and off zero of the conditions, and of such the one of the least value.
    ///
    /// The places are those of Roberts's sequence, *The unreasonable effectiveness of quasirandom sequences*
    /// (2018), from the middle on.
    ///
    /// # Errors
    /// Those of the functions.
    pub fn spread<E>(
        &self,
        mut functions: impl FnMut(&[f64], Wanted) -> Result<Answers, E>,
    ) -> Result<Vec<f64>, E> {
        let n = self.bounds.len();
        // The root of xⁿ⁺¹ = x + 1 above 1.
        let mut base: f64 = 2.0;
        for _ in 0..64 {
            base = libm::pow(1.0 + base, 1.0 / (n as f64 + 1.0));
        }
        let mut best: Option<(f64, f64, Vec<f64>)> = None;
        for look in 0..CONSTRAINED_LOOKS {
            let share = |k: usize| {
                let turned = 0.5 + look as f64 * libm::pow(base, -(k as f64 + 1.0));
                turned - turned.floor()
            };
            let place: Vec<f64> = self
                .bounds
                .iter()
                .enumerate()
                .map(|(k, [low, high])| low + share(k) * (high - low))
                .collect();
            let values = functions(&place, Wanted::Values)?.values;
            if !values.iter().all(|value| value.is_finite()) {
                continue;
            }
            let broken: f64 = self.broken(&values).sum();
            let is_better = best.as_ref().is_none_or(|(least_broken, least, _)| {
                (broken, values[0]) < (*least_broken, *least)
            });
            if is_better {
                best = Some((broken, values[0], place));
            }
        }
        let middle = || self.bounds.iter().map(|[low, high]| low + 0.5 * (high - low)).collect();
        Ok(best.map_or_else(middle, |(_, _, place)| place))
    }
}

#[cfg(test)]
mod tests {
    use super::{Answers, ConstrainedLeast, LeastEnd, LeastProblem, Wanted};

    const FREE: [f64; 2] = [-f64::INFINITY, f64::INFINITY];

    fn found(
        functions: fn(&[f64]) -> Vec<f64>,
        start: &[f64],
        bounds: &[[f64; 2]],
        n_equations: usize,
    ) -> ConstrainedLeast {
        LeastProblem { start, bounds, n_equations }
            .find(|x, _| Ok::<_, ()>(Answers::from(functions(x))))
            .expect("no failure")
    }

    #[track_caller]
    fn check(found: &ConstrainedLeast, wanted: &[f64]) {
        assert_eq!(found.end, LeastEnd::Settled, "{found:?}");
        let is_near = found.unknowns.iter().zip(wanted).all(|(x, y)| (x - y).abs() < 1e-6);
        assert!(is_near, "{found:?}");
        assert!(found.n_evaluations < 1000, "{found:?}");
    }

    #[test]
    fn valleys_and_saddles_are_left_for_the_least_value() {
        let valley = |x: &[f64]| {
            vec![100.0 * libm::pow(x[1] - x[0] * x[0], 2.0) + libm::pow(1.0 - x[0], 2.0)]
        };
        check(&found(valley, &[-1.2, 1.0], &[FREE; 2], 0), &[1.0, 1.0]);
        let saddle = |x: &[f64]| vec![libm::pow(x[0], 4.0) - x[0] * x[0] + x[1] * x[1]];
        let beside = found(saddle, &[0.0, 0.5], &[FREE; 2], 0);
        check(&beside, &[beside.unknowns[0].signum() * 0.5_f64.sqrt(), 0.0]);
    }

    #[test]
    fn saddles_on_an_axis_of_symmetry_are_left() {
        let quartic = |x: &[f64]| {
            let [x, y] = [x[0], x[1]];
            vec![x * x + y * y + 4.0 * x * y + libm::pow(x, 4.0) + libm::pow(y, 4.0)]
        };
        let half = 0.5_f64.sqrt();
        for bounds in [FREE, [-2.0, 2.0]] {
            let low = found(quartic, &[1.0, 1.0], &[bounds; 2], 0);
            let side = low.unknowns[0].signum();
            check(&low, &[side * half, -side * half]);
            assert!((low.values[0] + 0.5).abs() < 1e-12, "{low:?}");
        }
        // The same without the fourth powers falls without bound.
        let saddle = |x: &[f64]| vec![x[0] * x[0] + x[1] * x[1] + 4.0 * x[0] * x[1]];
        for start in [[1.0, 1.0], [0.0, 0.0]] {
            assert_eq!(found(saddle, &start, &[FREE; 2], 0).end, LeastEnd::Unbounded);
        }
        // In a corner, from inside and from the saddle, where it is no flat function.
        let product = |x: &[f64]| vec![x[0] * x[1]];
        for start in [[0.5, 0.5], [0.0, 0.0]] {
            let corner = found(product, &start, &[[-1.0, 1.0]; 2], 0);
            let side = corner.unknowns[0].signum();
            check(&corner, &[side, -side]);
        }
        let beside = found(product, &[0.0, 0.0], &[[0.0, 1.0], [-1.0, 1.0]], 0);
        check(&beside, &[1.0, -1.0]);
        // Nothing curves at the start, and fourth powers fall along a diagonal.
        let diagonal = |x: &[f64]| vec![libm::pow(x[0] - x[1], 2.0) - libm::pow(x[0] + x[1], 4.0)];
        let corner = found(diagonal, &[0.5, -0.5], &[[-1.0, 1.0]; 2], 0);
        assert!((corner.values[0] + 16.0).abs() < 1e-9, "{corner:?}");
    }

    #[test]
    fn the_greatest_value_on_a_circle_is_not_taken_for_the_least() {
        let half = 0.5_f64.sqrt();
        let sum = |x: &[f64]| vec![x[0] + x[1], x[0] * x[0] + x[1] * x[1] - 1.0];
        check(&found(sum, &[1.0, 1.0], &[FREE; 2], 1), &[-half, -half]);
        let height = |x: &[f64]| vec![x[1], x[0] * x[0] + x[1] * x[1] - 1.0];
        check(&found(height, &[0.0, 1.0], &[FREE; 2], 1), &[0.0, -1.0]);
        let sphere = |x: &[f64]| vec![x[2], x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0];
        check(&found(sphere, &[0.0, 0.0, 1.0], &[FREE; 3], 1), &[0.0, 0.0, -1.0]);
        // Held off from a circle from outside.
        let outside = found(height, &[0.0, 2.0], &[[-3.0, 3.0]; 2], 0);
        assert!((outside.values[0] + 3.0).abs() < 1e-9, "{outside:?}");
    }

    #[test]
    fn places_that_gradients_beside_hold_are_left_along_kinks() {
        // Nesterov's function of two unknowns, and of three: all but one of 2ⁿ⁻¹ places are none of the least.
        let nesterov = |x: &[f64], wanted| {
            let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
            let mut value = 0.25 * (x[0] - 1.0).abs();
            let mut slopes = vec![0.0; x.len()];
            slopes[0] = 0.25 * sign(x[0] - 1.0);
            for i in 1..x.len() {
                let off = x[i] - 2.0 * x[i - 1].abs() + 1.0;
                value += off.abs();
                slopes[i] += sign(off);
                slopes[i - 1] -= 2.0 * sign(off) * sign(x[i - 1]);
            }
            let gradients = (wanted == Wanted::Gradients).then(|| vec![slopes]);
            Ok::<_, ()>(Answers { values: vec![value], gradients })
        };
        for start in [[-1.0, 1.0], [0.0, -1.0], [-0.5, 0.3], [-2.0, -2.0]] {
            let problem = LeastProblem { start: &start, bounds: &[FREE; 2], n_equations: 0 };
            check(&problem.find(nesterov).expect("no failure"), &[1.0; 2]);
        }
        for start in [[-1.0, 1.0, 1.0], [0.0, -1.0, 1.0], [-0.5, 0.3, 0.1]] {
            let problem = LeastProblem { start: &start, bounds: &[FREE; 3], n_equations: 0 };
            let found = problem.find(nesterov).expect("no failure");
            assert!(found.end != LeastEnd::Settled || found.values[0] < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn long_valleys_are_followed_to_their_end() {
        let end = |factor: f64, start: &[f64]| {
            let valley = |x: &[f64], _| {
                let across = x[1] - x[0] * x[0];
                let along = 1.0 - x[0];
                let slopes =
                    vec![-2.0 * along - 4.0 * factor * across * x[0], 2.0 * factor * across];
                let values = vec![along * along + factor * across * across];
                Ok::<_, ()>(Answers { values, gradients: Some(vec![slopes]) })
            };
            LeastProblem { start, bounds: &[FREE; 2], n_equations: 0 }.find(valley)
        };
        for factor in [1e5, 1e6, 1e7, 1e8] {
            for start in [[-1.2, 1.0], [0.0, 0.0], [-2.0, -2.0], [3.0, -1.0]] {
                let found = end(factor, &start).expect("no failure");
                assert_eq!(found.end, LeastEnd::Settled, "{factor}: {found:?}");
                let is_near = found.unknowns.iter().all(|x| (x - 1.0).abs() < 1e-5);
                assert!(is_near, "{factor}: {found:?}");
            }
        }
        // One too long for the steps there are is told.
        let found = end(1e9, &[-1.2, 1.0]).expect("no failure");
        assert_eq!(found.end, LeastEnd::Unsettled, "{found:?}");
    }

    #[test]
    fn conditions_that_nearly_hold_are_led_back_to() {
        let can = |x: &[f64]| {
            let value = std::f64::consts::PI * (2.0 + x[0]) * (2.0 + x[1]);
            vec![value, x[0] * x[0] + x[1] * x[1] - 2.0]
        };
        for start in [[-1.3, -0.2], [1.0, 1.1]] {
            let found = found(can, &start, &[FREE; 2], 1);
            assert_eq!(found.end, LeastEnd::Settled, "{found:?}");
            assert!((found.values[0] - std::f64::consts::PI).abs() < 1e-7, "{found:?}");
        }
        // Two that contradict one another in their tenth digit.
        let narrow = |x: &[f64]| vec![x[0] * x[0] + x[1], x[1] - 1.0, 0.999_999_999_9 - x[1]];
        check(&found(narrow, &[1.0, 1.0], &[FREE; 2], 0), &[0.0, 1.0]);
        let apart = |x: &[f64]| vec![x[0] * x[0] + x[1], x[1] - 1.0, 0.999_99 - x[1]];
        assert_eq!(found(apart, &[1.0, 1.0], &[FREE; 2], 0).end, LeastEnd::Contradictory);
    }

    #[test]
    fn bounds_and_conditions_hold() {
        // Hock & Schittkowski, Test Examples for Nonlinear Programming Codes, problems 71, 43 and 6.
        let unit = [1.0, 5.0];
        let hs71 = |x: &[f64]| {
            let squares: f64 = x.iter().map(|x| x * x).sum();
            let product: f64 = x.iter().product();
            vec![x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], squares - 40.0, product - 25.0]
        };
        let solved = found(hs71, &[1.0, 5.0, 5.0, 1.0], &[unit; 4], 1);
        check(&solved, &[1.0, 4.742_999_64, 3.821_149_98, 1.379_408_29]);
        let rosen_suzuki = |x: &[f64]| {
            let [a, b, c, d] = [x[0], x[1], x[2], x[3]];
            let value =
                a * a + b * b + 2.0 * c * c + d * d - 5.0 * a - 5.0 * b - 21.0 * c + 7.0 * d;
            vec![
                value,
                8.0 - a * a - b * b - c * c - d * d - a + b - c + d,
                10.0 - a * a - 2.0 * b * b - c * c - 2.0 * d * d + a + d,
                5.0 - 2.0 * a * a - b * b - c * c - 2.0 * a + b + d,
            ]
        };
        check(&found(rosen_suzuki, &[0.0; 4], &[FREE; 4], 0), &[0.0, 1.0, 2.0, -1.0]);
        let curved = |x: &[f64]| vec![libm::pow(1.0 - x[0], 2.0), 10.0 * (x[1] - x[0] * x[0])];
        check(&found(curved, &[-1.2, 1.0], &[FREE; 2], 1), &[1.0, 1.0]);
    }

    #[test]
    fn even_slopes_are_held_by_curved_conditions_from_inside() {
        let disc = |x: &[f64]| vec![x[0] + x[1], 1.0 - x[0] * x[0] - x[1] * x[1]];
        check(&found(disc, &[0.1; 2], &[FREE; 2], 0), &[-0.5_f64.sqrt(); 2]);
        // The condition is level on the way at what is zero but for rounding.
        let small = |x: &[f64]| vec![-x[0], 3e-5 - 0.25 * (x[0] + 0.01) * (x[0] + 0.01)];
        let end = 2.0 * 3e-5_f64.sqrt() - 0.01;
        for start in [-0.0084, -0.0099, -0.01, -1e-9] {
            check(&found(small, &[start], &[FREE], 0), &[end]);
        }
    }

    #[test]
    fn what_has_no_least_value_is_told() {
        let ends = [
            found(|x| vec![x[0] - x[1]], &[1.0, 2.0], &[FREE; 2], 0).end,
            found(|_| vec![3.0], &[1.0, 2.0], &[FREE; 2], 0).end,
            found(|x| vec![x[0], x[0] - 3.0, 1.0 - x[0]], &[2.0], &[FREE], 0).end,
            found(|x| vec![x[0], x[0] * x[0] + 1.0], &[2.0], &[FREE], 1).end,
        ];
        let [unbounded, flat, contradictory, curved] = ends;
        assert_eq!(unbounded, LeastEnd::Unbounded);
        assert_eq!(flat, LeastEnd::Flat);
        assert_eq!([contradictory, curved], [LeastEnd::Contradictory; 2]);
    }

    #[test]
    fn poles_are_told_and_what_is_only_steep_is_not() {
        let end = |functions: fn(&[f64]) -> Vec<f64>, start: &[f64]| {
            found(functions, start, &vec![FREE; start.len()], 0).end
        };
        let poles: [(fn(&[f64]) -> Vec<f64>, &[f64]); 6] = [
            (|x| vec![-1.0 / (x[0] * x[0])], &[3.0]),
            (|x| vec![libm::log(x[0].abs())], &[3.0]),
            (|x| vec![-libm::pow(x[0] - 1.0, -2.0)], &[3.0]),
            (|x| vec![1.0 / (x[0] * x[0] * x[0])], &[-1.0]),
            (|x| vec![-1.0 / libm::hypot(x[0] - 1.0, x[1] - 2.0)], &[3.0, 3.0]),
            (|x| vec![libm::log(libm::hypot(x[0], x[1])) + x[1] * x[1]], &[3.0, 1.0]),
        ];
        for (pole, start) in poles {
            assert_eq!(end(pole, start), LeastEnd::Pole, "from {start:?}");
        }
        let steep: [(fn(&[f64]) -> Vec<f64>, &[f64]); 6] = [
            (|x| vec![-1.0 / (1e-6 + x[0] * x[0])], &[3.0]),
            (|x| vec![-1.0 / (1e-12 + (x[0] - 1.0) * (x[0] - 1.0))], &[1.5]),
            (|x| vec![-libm::exp(-1e4 * x[0] * x[0])], &[0.03]),
            (|x| vec![(x[0] - 1.0).abs().sqrt()], &[3.0]),
            (|x| vec![libm::pow((x[0] - 1.0).abs(), 0.1)], &[3.0]),
            (|x| vec![(x[0] - 1.0).abs() + (x[1] + 2.0).abs()], &[3.0, 3.0]),
        ];
        for (bounded, start) in steep {
            assert_ne!(end(bounded, start), LeastEnd::Pole, "from {start:?}");
        }
        // Kept off by a bound, or by a condition.
        let inverse = |x: &[f64]| vec![-1.0 / x[0]];
        assert_eq!(found(inverse, &[1.0], &[[1e-3, 5.0]], 0).end, LeastEnd::Settled);
        let beside = |x: &[f64]| vec![-1.0 / x[0], x[0] - 0.5];
        check(&found(beside, &[1.0], &[FREE], 0), &[0.5]);
    }

    #[test]
    fn what_only_tends_to_its_least_value_is_told() {
        let tends = |x: &[f64]| vec![1.0 / x[0]];
        assert_eq!(found(tends, &[3.0], &[FREE], 0).end, LeastEnd::Unattained);
        let along = |x: &[f64]| vec![x[0], x[0] * x[1] - 1.0, x[0]];
        assert_eq!(found(along, &[1.0, 1.0], &[FREE; 2], 0).end, LeastEnd::Unattained);
        // Rounding ends it before it is far.
        let branch = |x: &[f64]| vec![(1.0 + x[0] * x[0]).sqrt() - x[0]];
        assert_eq!(found(branch, &[1.0], &[FREE], 0).end, LeastEnd::Unattained);
        let turns = |x: &[f64]| vec![1.0 / x[0] + 1e-14 * x[0]];
        let slow = found(turns, &[1.0], &[FREE], 0);
        assert!(
            slow.end == LeastEnd::Settled && (slow.unknowns[0] / 1e7 - 1.0).abs() < 1e-3,
            "{slow:?}"
        );
        let falls = |x: &[f64]| vec![-x[0].sqrt()];
        assert_eq!(found(falls, &[3.0], &[FREE], 0).end, LeastEnd::Unbounded);
    }

    #[test]
    fn places_without_a_value_are_kept_out_of() {
        let logarithm = |x: &[f64]| vec![x[0] - libm::log(x[0])];
        check(&found(logarithm, &[8.0], &[FREE], 0), &[1.0]);
    }

    #[test]
    fn places_are_spread_over_all_of_the_bounds_and_no_further() {
        let bounds = [[-1.0, 1.0], [3.0, 5.0]];
        let mut reached = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let functions = |x: &[f64], _| {
            for (ends, x) in reached.iter_mut().zip(x) {
                *ends = [ends[0].min(*x), ends[1].max(*x)];
            }
            Ok::<_, ()>(Answers::from(vec![(x[0] - 0.5).abs() + (x[1] - 4.5).abs()]))
        };
        let problem = LeastProblem { start: &[0.0, 4.0], bounds: &bounds, n_equations: 0 };
        let best = problem.spread(functions).expect("no failure");
        assert!((best[0] - 0.5).abs() < 0.25 && (best[1] - 4.5).abs() < 0.25, "{best:?}");
        for (reached, [low, high]) in reached.iter().zip(bounds) {
            assert!(low <= reached[0] && reached[0] < low + 0.25, "{reached:?}");
            assert!(high - 0.25 < reached[1] && reached[1] <= high, "{reached:?}");
        }
    }
}
