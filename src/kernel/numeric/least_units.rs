//! Typical sizes of the unknowns of a search for a least value.

use super::{
    answers::{Answers, Wanted},
    least_model::magnitude,
    least_problem::LeastProblem,
    least_search::LeastSearch,
};
use crate::tolerance::{LAST_BIT, LEAST_UNIT_SHARE};

/// By how many times an unknown's size grows as it is looked for.
const WIDER: f64 = 16.0;

/// Times that it grows, at most: what is smaller beside the others is no size.
const MOST_WIDER: i32 = 16;

/// Last bits of a value that a change of it must have to tell how the function bends.
const TELLING_BITS: f64 = 1e6;

impl LeastProblem<'_> {
    /// The sizes that places tell: the width of bounds, how far from zero an unknown is, or how far others are.
    pub(super) fn units(&self, place: &[f64]) -> Vec<f64> {
        let size = magnitude(place);
        let unit = |(x, [low, high]): (&f64, &[f64; 2])| match high - low {
            width if width.is_finite() && 0.0 < width => width,
            _ if *x != 0.0 => x.abs(),
            _ if 0.0 < size => size,
            _ => 1.0,
        };
        place.iter().zip(self.bounds).map(unit).collect()
    }
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Widens the sizes of unknowns that nothing bounds and that begin nearer to zero than others or one, where the
    /// functions hardly change over them: up to where one does, at most to the size of an unknown that begins at zero.
    /// By how much each function changes over those that were widened.
    pub(super) fn widen_units(&mut self, gradients: &[Vec<f64>]) -> Result<Vec<f64>, E> {
        let whole = magnitude(&self.place).max(1.0);
        let mut changes = vec![0.0_f64; gradients.len()];
        for k in 0..self.place.len() {
            let is_free = self.problem.bounds[k].iter().all(|bound| bound.is_infinite());
            let begins_small = self.place[k] != 0.0 && self.units[k] < LEAST_UNIT_SHARE * whole;
            if !is_free || !begins_small {
                continue;
            }
            let (unit, values) = self.wider_unit(k, whole, gradients)?;
            self.units[k] = unit;
            for ((most, there), here) in changes.iter_mut().zip(values).zip(&self.values) {
                *most = most.max((there - here).abs());
            }
        }
        Ok(changes)
    }

    /// The size of an unknown over which a function changes by what tells, or bends up, and the values there; its own size,
    /// and the values of the place, if that is none wider.
    fn wider_unit(
        &mut self,
        k: usize,
        whole: f64,
        gradients: &[Vec<f64>],
    ) -> Result<(f64, Vec<f64>), E> {
        let sign = if 0.0 < gradients[0][k] { -1.0 } else { 1.0 };
        let least = whole * libm::pow(WIDER, -f64::from(MOST_WIDER));
        let mut found = (self.units[k], self.values.clone());
        let mut wider = self.units[k];
        // At its own size, and from the least one on.
        for _ in 0..=MOST_WIDER + 1 {
            let mut place = self.place.clone();
            place[k] += sign * wider;
            let values = self.asked.values(&place)?;
            let (is_told, is_bent) = self.told(k, &values, gradients, sign * wider);
            if is_bent && !is_told {
                break;
            }
            if self.units[k] < wider && values.iter().all(|value| value.is_finite()) {
                found = (wider, values);
            }
            if is_told || is_bent || whole <= wider {
                break;
            }
            wider = (WIDER * wider).max(least).min(whole);
        }
        Ok(found)
    }

    /// Whether a function changes by what tells where an unknown is a step farther, and whether one bends: the first, which
    /// is to be least, up, as it does behind its least value. One that only falls faster has none there.
    fn told(&self, k: usize, there: &[f64], gradients: &[Vec<f64>], step: f64) -> (bool, bool) {
        let (mut is_told, mut is_bent) = (false, false);
        for (idx, (there, here)) in there.iter().zip(&self.values).enumerate() {
            let gradient = &gradients[idx];
            let telling = LEAST_UNIT_SHARE * magnitude(gradient).max(here.abs());
            let change = there - here;
            let beside_even = change - gradient[k] / self.units[k] * step;
            let bend = if idx == 0 { beside_even } else { beside_even.abs() };
            let is_visible = TELLING_BITS * LAST_BIT * here.abs() < change.abs();
            is_bent |= !there.is_finite() || is_visible && change.abs() < 2.0 * bend;
            // A slope that rounding hides tells nothing.
            let is_sloped = telling <= gradient[k].abs() && 0.0 < change.abs();
            is_told |= is_sloped || telling <= change.abs();
        }
        (is_told, is_bent)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Answers, LeastEnd, LeastProblem};

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    /// Where the sum of squares of how far each unknown is from its own place, times a factor, is least.
    fn search(places: &[f64], factor: f64, start: &[f64]) -> crate::ConstrainedLeast {
        let functions = |x: &[f64], _| {
            let away: Vec<f64> = x.iter().zip(places).map(|(x, place)| x - place).collect();
            let values = vec![factor * away.iter().map(|away| away * away).sum::<f64>()];
            let slopes = away.iter().map(|away| 2.0 * factor * away).collect();
            Ok::<_, ()>(Answers { values, gradients: Some(vec![slopes]) })
        };
        LeastProblem { start, bounds: &vec![FREE; start.len()], n_equations: 0 }
            .find(functions)
            .expect("no failure")
    }

    #[test]
    fn starts_beside_zero_say_little_of_sizes() {
        let cases: [(&[f64], &[f64]); 9] = [
            (&[3.0], &[1e-12]),
            (&[3.0], &[-1e-200]),
            (&[3.0, 2.0], &[1e-9, 1.0]),
            (&[1e6, 2.0], &[1e-9, 1.0]),
            (&[3.0, 2.0], &[1e-12, 1e-12]),
            (&[1e9], &[1.0]),
            (&[1e10], &[1.0]),
            (&[1e9], &[0.0]),
            (&[2e-9, 1e-9], &[1e-9, 3e-9]),
        ];
        for (places, start) in cases {
            for factor in [1e-6, 1.0, 1e6] {
                let found = search(places, factor, start);
                assert_eq!(found.end, LeastEnd::Settled, "{places:?} from {start:?}: {found:?}");
                let pairs = found.unknowns.iter().zip(places);
                let off = pairs.map(|(x, place)| (x / place - 1.0).abs()).fold(0.0, f64::max);
                assert!(off < 1e-6, "{places:?} from {start:?}: {found:?}");
                assert!(found.n_evaluations < 100, "{places:?} from {start:?}: {found:?}");
            }
        }
    }

    #[test]
    fn what_falls_without_bound_is_told_also_farther_off() {
        let ends = |function: fn(f64) -> f64, start: f64| {
            LeastProblem { start: &[start], bounds: &[FREE], n_equations: 0 }
                .find(|x, _| Ok::<_, ()>(Answers::from(vec![function(x[0])])))
                .expect("no failure")
                .end
        };
        for start in [1.0, 1e-7] {
            for function in [|x: f64| -x, |x: f64| -x * x, |x: f64| -x * x * x] {
                assert_eq!(ends(function, start), LeastEnd::Unbounded);
            }
            assert_ne!(ends(|x| -libm::exp(x), start), LeastEnd::Settled);
        }
    }

    type Function = fn(&[f64]) -> (f64, Vec<f64>);

    /// How searches for the least value of a function end that knows its slopes.
    #[track_caller]
    fn check_ends(functions: &[Function], starts: &[&[f64]], end: LeastEnd) {
        for (i, function) in functions.iter().enumerate() {
            for start in starts {
                let answers = |x: &[f64], _| {
                    let (value, slopes) = function(x);
                    Ok::<_, ()>(Answers { values: vec![value], gradients: Some(vec![slopes]) })
                };
                let problem =
                    LeastProblem { start, bounds: &vec![FREE; start.len()], n_equations: 0 };
                let found = problem.find(answers).expect("no failure");
                assert_eq!(found.end, end, "{i} from {start:?}: {found:?}");
            }
        }
    }

    const STARTS: [&[f64]; 9] =
        [&[1e-12], &[1e-9], &[-1e-9], &[1e-7], &[1e-5], &[-1e-4], &[1e-3], &[0.1], &[2.0]];

    #[test]
    fn poles_are_told_from_starts_beside_zero() {
        let of_one: [Function; 6] = [
            |x| (-1.0 / (x[0] * x[0]), vec![2.0 / libm::pow(x[0], 3.0)]),
            |x| (libm::log(x[0].abs()), vec![1.0 / x[0]]),
            |x| (-1.0 / x[0].abs(), vec![x[0].signum() / (x[0] * x[0])]),
            |x| (-libm::pow(x[0] - 1.0, -2.0), vec![2.0 * libm::pow(x[0] - 1.0, -3.0)]),
            |x| (libm::log((x[0] - 1.0).abs()), vec![1.0 / (x[0] - 1.0)]),
            |x| {
                (
                    -1.0 / (x[0] - 3.0).abs(),
                    vec![(x[0] - 3.0).signum() * libm::pow(x[0] - 3.0, -2.0)],
                )
            },
        ];
        check_ends(&of_one, &STARTS, LeastEnd::Pole);
        let of_two: [Function; 4] = [
            |x| {
                let square = x[0] * x[0] + x[1] * x[1];
                let factor = 2.0 / (square * square);
                (-1.0 / square, vec![factor * x[0], factor * x[1]])
            },
            |x| {
                let square = x[0] * x[0] + x[1] * x[1];
                (libm::log(square), vec![2.0 * x[0] / square, 2.0 * x[1] / square])
            },
            // It rises to the other side, and nowhere is steepest towards the pole.
            |x| {
                let [a, b] = [x[0], x[1]];
                let square = a * a + b * b;
                let part = 1.0 / (square * square);
                (-a / square, vec![(a * a - b * b) * part, 2.0 * a * b * part])
            },
            |x| {
                let [a, b] = [x[0] - 1.0, x[1] - 2.0];
                let square = a * a + b * b;
                let factor = 2.0 / (square * square);
                (-1.0 / square, vec![factor * a, factor * b])
            },
        ];
        let starts: [&[f64]; 9] = [
            &[1e-9, 1e-9],
            &[1e-5, 1e-5],
            &[-1e-5, 2e-5],
            &[1e-9, 1.0],
            &[1.0, 1e-9],
            &[1e-5, -0.3],
            &[1e-3, 1e-7],
            &[0.2, 0.1],
            &[3.0, -4.0],
        ];
        check_ends(&of_two, &starts, LeastEnd::Pole);
    }

    #[test]
    fn what_only_tends_to_its_least_value_is_told_from_starts_beside_zero() {
        let functions: [Function; 3] = [
            |x| {
                let whole = 1.0 + x[0] * x[0];
                (1.0 / whole, vec![-2.0 * x[0] / (whole * whole)])
            },
            |x| {
                let whole = 1.0 + libm::pow(x[0], 4.0);
                (1.0 / whole, vec![-4.0 * libm::pow(x[0], 3.0) / (whole * whole)])
            },
            |x| (-libm::atan(x[0]), vec![-1.0 / (1.0 + x[0] * x[0])]),
        ];
        check_ends(&functions, &STARTS, LeastEnd::Unattained);
        let unbounded: [Function; 3] = [
            |x| (-x[0], vec![-1.0]),
            |x| (-x[0] * x[0], vec![-2.0 * x[0]]),
            |x| (-libm::log1p(x[0] * x[0]), vec![-2.0 * x[0] / (1.0 + x[0] * x[0])]),
        ];
        check_ends(&unbounded, &STARTS, LeastEnd::Unbounded);
    }
}
