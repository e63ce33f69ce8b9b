//! The last digits of the place at which a function is least.
//!
//! Near its least value a function is above that by the square of the distance alone, so that values tell half of the
//! digits of the place. Gradients tell all of them. Nocedal & Wright, *Numerical Optimization*, §18.1: steps of Newton's
//! method along the ways that what holds the place leaves free.

use super::{
    answers::{Answers, Wanted},
    least_bending::slopes_along,
    least_model::magnitude,
    least_search::LeastSearch,
};
use crate::{
    ceiling::LEAST_REFINEMENTS,
    tolerance::{KINK_ROUNDINGS, LAST_BIT, LEAST_PROBE_RELATIVE},
};

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    fn is_step_rounding(&self, step: &[f64]) -> bool {
        let mut parts = step.iter().zip(&self.place).zip(&self.units);
        parts.all(|((step, x), unit)| (step * unit).abs() <= 0.5 * LAST_BIT * x.abs())
    }

    /// Whether other values are no worse than those here, to rounding.
    fn is_as_low(&self, values: &[f64]) -> bool {
        let [here, there] = [&self.values, values].map(|values| self.merit(values));
        there <= here + KINK_ROUNDINGS * LAST_BIT * here.abs()
    }

    /// Goes from where the search settled to where its gradients vanish, as long as each step makes them less and the value
    /// is the same to rounding.
    pub(super) fn refine(&mut self) -> Result<(), E> {
        let Some(bending) = self.bending.take().filter(|_| !self.asked.has_differences) else {
            return Ok(());
        };
        let slopes_at = |search: &mut Self, place: &[f64]| {
            let gradients = search.gradients_at(place)?;
            Ok(slopes_along(&bending.ways, &gradients, &bending.shares))
        };
        let mut slopes = match self.is_free() {
            true => slopes_along(&bending.ways, &self.slopes, &bending.shares),
            false => {
                // What holds the place first: slopes beside it are others.
                let still = vec![0.0; self.place.len()];
                let (place, values) = self.led_along(&still, 1.0, &bending.held)?;
                if self.is_as_low(&values) {
                    (self.place, self.values) = (place, values);
                }
                slopes_at(self, &self.place.clone())?
            }
        };
        for _ in 0..LEAST_REFINEMENTS {
            let Some(step) = bending.newton_step(&slopes) else { break };
            let is_still = 1 == self.values.len() && self.is_step_rounding(&step);
            if is_still || LEAST_PROBE_RELATIVE < magnitude(&step) {
                break;
            }
            let (place, values) = self.led_along(&step, 1.0, &bending.held)?;
            if !self.is_as_low(&values) {
                break;
            }
            let there = slopes_at(self, &place)?;
            if self.asked.has_differences || magnitude(&slopes) <= magnitude(&there) {
                break;
            }
            (self.place, self.values, slopes) = (place, values, there);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use crate::{Answers, LeastProblem};

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    /// Where a function of two unknowns is least under one condition, both with their gradients.
    fn place(
        functions: fn(f64, f64) -> [(f64, [f64; 2]); 2],
        bounds: [[f64; 2]; 2],
        n_equations: usize,
    ) -> [f64; 2] {
        let answers = |x: &[f64], _| {
            let (values, gradients): (Vec<f64>, Vec<Vec<f64>>) = (functions(x[0], x[1])
                .into_iter())
            .map(|(value, slopes)| (value, slopes.to_vec()))
            .unzip();
            Ok::<_, ()>(Answers { values, gradients: Some(gradients) })
        };
        let problem = LeastProblem { start: &[0.7, 0.9], bounds: &bounds, n_equations };
        let found = problem.find(answers).expect("no failure");
        [found.unknowns[0], found.unknowns[1]]
    }

    fn check(found: [f64; 2], wanted: [f64; 2]) {
        let is_exact = found.iter().zip(wanted).all(|(x, wanted)| (x - wanted).abs() < 1e-14);
        assert!(is_exact, "{found:?} for {wanted:?}");
    }

    #[test]
    fn places_under_conditions_have_all_digits() {
        let [third, half] = [1.0 / 3.0_f64.sqrt(), 0.5_f64.sqrt()];
        // The greatest product x²y on the unit circle, and the greatest sum inside of it.
        let on_circle = |x: f64, y: f64| {
            [(-x * x * y, [-2.0 * x * y, -x * x]), (x * x + y * y - 1.0, [2.0 * x, 2.0 * y])]
        };
        check(place(on_circle, [FREE; 2], 1), [2.0_f64.sqrt() * third, third]);
        let inside =
            |x: f64, y: f64| [(-x - y, [-1.0; 2]), (1.0 - x * x - y * y, [-2.0 * x, -2.0 * y])];
        check(place(inside, [FREE; 2], 0), [half; 2]);
        // A bound and a condition that does not bind: y = x² - x is least for x = ½.
        let beside = |x: f64, y: f64| {
            let off = y - x * x + x;
            [
                (
                    libm::cosh(off) + libm::pow(y + 0.2, 2.0),
                    [libm::sinh(off) * (1.0 - 2.0 * x), libm::sinh(off) + 2.0 * (y + 0.2)],
                ),
                (9.0 - x, [-1.0, 0.0]),
            ]
        };
        let [x, y] = place(beside, [[0.5, 4.0], [-1.0, 1.0]], 0);
        assert!((libm::sinh(y - x * x + x) * (1.0 - 2.0 * x)).abs() < 1e-14, "{x} {y}");
        assert!((libm::sinh(y - x * x + x) + 2.0 * (y + 0.2)).abs() < 1e-14, "{x} {y}");
    }
}
