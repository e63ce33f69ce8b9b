//! Typical sizes of the unknowns of a search for a least value.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_model::magnitude,
    least_problem::LeastProblem,
    least_search::{LeastSearch, clamped},
};
use crate::tolerance::{LAST_BIT, LEAST_PROBE_RELATIVE, LEAST_UNIT_SHARE};

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

    /// Whether the functions have values beside a place on both sides in each unknown.
    pub(super) fn has_values_around<F, E>(
        &self,
        place: &[f64],
        asked: &mut CountedFunctions<F>,
    ) -> Result<bool, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        for (k, unit) in self.units(place).into_iter().enumerate() {
            for side in [-LEAST_PROBE_RELATIVE, LEAST_PROBE_RELATIVE] {
                let mut beside = place.to_vec();
                beside[k] += side * unit;
                let values = asked.values(&clamped(&beside, self.bounds))?;
                if !values.iter().all(|value| value.is_finite()) {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Widens the sizes of unknowns that nothing bounds and that begin nearer to zero than others or one, where the
    /// functions hardly change over them: up to where one does, at most to the size of an unknown that begins at zero.
    /// Whether any was widened.
    pub(super) fn widen_units(&mut self, gradients: &[Vec<f64>]) -> Result<bool, E> {
        let whole = magnitude(&self.place).max(1.0);
        let mut is_wider = false;
        for k in 0..self.place.len() {
            let is_free = self.problem.bounds[k].iter().all(|bound| bound.is_infinite());
            let begins_small = self.place[k] != 0.0 && self.units[k] < LEAST_UNIT_SHARE * whole;
            if !is_free || !begins_small {
                continue;
            }
            let telling: Vec<f64> = gradients
                .iter()
                .zip(&self.values)
                .map(|(gradient, value)| LEAST_UNIT_SHARE * magnitude(gradient).max(value.abs()))
                .collect();
            let tells = |(gradient, telling): (&Vec<f64>, &f64)| *telling <= gradient[k].abs();
            if !gradients.iter().zip(&telling).any(tells) {
                self.units[k] = self.wider_unit(k, whole, (gradients, &telling))?;
                is_wider = true;
            }
        }
        Ok(is_wider)
    }

    /// The size of an unknown over which a function changes by what tells, or bends.
    fn wider_unit(
        &mut self,
        k: usize,
        whole: f64,
        (gradients, telling): (&[Vec<f64>], &[f64]),
    ) -> Result<f64, E> {
        let sign = if 0.0 < gradients[0][k] { -1.0 } else { 1.0 };
        let mut unit = self.units[k].max(whole * libm::pow(WIDER, -f64::from(MOST_WIDER)));
        for _ in 0..=MOST_WIDER {
            let wider = (WIDER * unit).min(whole);
            let mut place = self.place.clone();
            place[k] += sign * wider;
            let values = self.asked.values(&place)?;
            let mut is_bent = false;
            let mut is_told = false;
            for (idx, (there, here)) in values.iter().zip(&self.values).enumerate() {
                let change = there - here;
                let even = sign * gradients[idx][k] / self.units[k] * wider;
                let is_visible = TELLING_BITS * LAST_BIT * here.abs() < change.abs();
                is_bent |=
                    !there.is_finite() || is_visible && change.abs() < 2.0 * (change - even).abs();
                is_told |= telling[idx] <= change.abs();
            }
            if is_bent && !is_told {
                break;
            }
            unit = if values.iter().all(|value| value.is_finite()) { wider } else { unit };
            if is_told || is_bent || whole <= wider {
                break;
            }
        }
        Ok(unit)
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
}
