//! The last digits of the place at which a function is least.
//!
//! Near its least value a function is above that by the square of the distance alone, so that values tell half of the
//! digits of the place. Gradients tell all of them. Nocedal & Wright, *Numerical Optimization*, §18.1: steps of Newton's
//! method along the ways that what holds the place leaves free.

use super::{
    answers::{Answers, Wanted},
    least_beside::{Bending, slopes_along},
    least_model::magnitude,
    least_search::LeastSearch,
    quadratic_program::dot,
};
use crate::{
    ceiling::LEAST_REFINEMENTS,
    tolerance::{KINK_ROUNDINGS, LAST_BIT, LEAST_BEND_RELATIVE, LEAST_PROBE_RELATIVE},
};

impl Bending {
    /// The step of Newton's method by the slopes along the ways; none where the function does not clearly bend up along
    /// all of them.
    fn newton_step(&self, slopes: &[f64]) -> Option<Vec<f64>> {
        let most = self.axes.iter().map(|(bend, _)| *bend).fold(0.0, f64::max);
        let mut step = vec![0.0; self.ways.first()?.len()];
        for (bend, axis) in &self.axes {
            if *bend <= LEAST_BEND_RELATIVE * most {
                return None;
            }
            let share = -dot(slopes, axis) / bend;
            for (way, part) in self.ways.iter().zip(axis) {
                step.iter_mut().zip(way).for_each(|(step, along)| *step += share * part * along);
            }
        }
        Some(step)
    }
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    fn is_step_rounding(&self, step: &[f64]) -> bool {
        let mut parts = step.iter().zip(&self.place).zip(&self.units);
        parts.all(|((step, x), unit)| (step * unit).abs() <= 0.5 * LAST_BIT * x.abs())
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
            false => slopes_at(self, &self.place.clone())?,
        };
        for _ in 0..LEAST_REFINEMENTS {
            let Some(step) = bending.newton_step(&slopes) else { break };
            let is_still = 1 == self.values.len() && self.is_step_rounding(&step);
            if is_still || LEAST_PROBE_RELATIVE < magnitude(&step) {
                break;
            }
            let (place, values) = self.led_along(&step, 1.0, &bending.held)?;
            let [before, behind] = [&self.values, &values].map(|values| self.merit(values));
            if !behind.is_finite() || KINK_ROUNDINGS * LAST_BIT * before.abs() < behind - before {
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
