//! What lies beyond the place, far away, to which a search for a least value came.
//!
//! A function that falls as far as the search went may rise farther off, by any power of the distance: it is asked along
//! the way from the start on, at steps whose logarithms double, and between them where one is higher.

use super::{
    answers::{Answers, Wanted},
    least_model::magnitude,
    least_problem::LeastEnd,
    least_search::LeastSearch,
    pole_search::END_OF_NUMBERS,
};

/// The logarithm to the base of two of the first step: 64 times farther off.
const FIRST_STEP: f64 = 6.0;

/// The least such step: twice as far off is a fair start.
const LEAST_STEP: f64 = 1.0;

/// A place beyond which powers of it are no numbers.
const FARTHEST: f64 = 1e150;

/// What a function does beyond.
pub(super) enum Beyond {
    /// It falls on; how the search ends.
    Falls(LeastEnd),
    /// It rises behind this place.
    Rises(Vec<f64>),
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// What the function does beyond the place, far away, at which the search ended in one of two ways.
    pub(super) fn beyond(&mut self, end: LeastEnd) -> Result<Beyond, E> {
        let starts = self.problem.start.iter().zip(&self.place).zip(&self.units);
        let way: Vec<f64> = starts.map(|((from, x), unit)| (x - from) / unit).collect();
        let size = magnitude(&self.place);
        let distance = self.distance();
        let (mut best, mut least) = (self.place.clone(), self.merit(&self.values));
        let (mut farther, mut step) = (0.0, FIRST_STEP);
        let (mut is_behind, mut is_level) = (false, false);
        while LEAST_STEP <= step {
            let times = libm::pow(2.0, farther + step);
            if FARTHEST < size * times {
                break;
            }
            let (place, values) = self.moved(&way, times - 1.0)?;
            let merit = self.merit(&values);
            if merit <= least {
                self.trail.keep(distance * times, values[0]);
                is_level = least <= merit;
                (best, least, farther) = (place, merit, farther + step);
            } else {
                is_behind = true;
            }
            step *= if is_behind { 0.5 } else { 2.0 };
        }
        if least < END_OF_NUMBERS {
            return Ok(Beyond::Falls(end));
        }
        Ok(match is_behind {
            true => Beyond::Rises(best),
            false if is_level || self.trail.falls_ever_less() => {
                Beyond::Falls(LeastEnd::Unattained)
            }
            false => Beyond::Falls(LeastEnd::Unbounded),
        })
    }
}
