//! The steps of a search for a least value under conditions.
//!
//! Nocedal & Wright, *Numerical Optimization*, algorithm 18.3, with the corrections of §18.3 where a step is
//! refused.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_model::{CurvatureModel, Terms, magnitude},
    least_problem::{LeastEnd, LeastProblem},
};
use crate::{
    ceiling::{CONSTRAINED_HALVINGS, CONSTRAINED_STEPS},
    tolerance::{
        ARMIJO, CONDITION_RELATIVE, LAST_BIT, LEAST_FAR, LEAST_GAIN_RELATIVE, LEAST_PROBE_RELATIVE,
        LEAST_SLOPE_RELATIVE, LEAST_STEP_RELATIVE,
    },
};

/// A search under way. Unknowns are those of the problem, steps are in units of `units`.
pub(super) struct LeastSearch<'a, F> {
    problem: LeastProblem<'a>,
    asked: &'a mut CountedFunctions<F>,
    /// A typical size of each unknown.
    units: Vec<f64>,
    /// What each function counts with: its steepness at the start is one.
    weights: Vec<f64>,
    pub(super) place: Vec<f64>,
    pub(super) values: Vec<f64>,
    /// The weight of each broken condition.
    penalties: Vec<f64>,
}

/// A place beside the best one, with the merit on the other side of that.
struct BestBeside {
    merit: f64,
    opposite: f64,
    place: Vec<f64>,
    values: Vec<f64>,
}

impl<'a, F, E> LeastSearch<'a, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    pub(super) fn new(
        problem: LeastProblem<'a>,
        asked: &'a mut CountedFunctions<F>,
    ) -> Result<Self, E> {
        let place: Vec<f64> = clamped(problem.start, problem.bounds);
        let size = magnitude(&place);
        let unit = |(x, [low, high]): (&f64, &[f64; 2])| match high - low {
            width if width.is_finite() && 0.0 < width => width,
            _ if *x != 0.0 => x.abs(),
            _ if 0.0 < size => size,
            _ => 1.0,
        };
        let units = place.iter().zip(problem.bounds).map(unit).collect();
        let values = asked.values(&place)?;
        let n_conditions = values.len() - 1;
        let weights = vec![1.0; values.len()];
        let mut search = Self {
            problem,
            asked,
            units,
            weights,
            place,
            values,
            penalties: vec![0.0; n_conditions],
        };
        let gradients = search.gradients()?;
        for (idx, gradient) in gradients.iter().enumerate() {
            let steepness = magnitude(gradient);
            if 0.0 < steepness && steepness.is_finite() {
                search.weights[idx] = 1.0 / steepness;
            }
        }
        Ok(search)
    }

    /// Gradients of the weighted functions by the unknowns in their units.
    fn gradients(&mut self) -> Result<Vec<Vec<f64>>, E> {
        let mut gradients = self.asked.gradients(&self.place, self.problem.bounds)?;
        for (gradient, weight) in gradients.iter_mut().zip(&self.weights) {
            for (slope, unit) in gradient.iter_mut().zip(&self.units) {
                *slope *= unit * weight;
            }
        }
        Ok(gradients)
    }

    fn weighted(&self, values: &[f64]) -> Vec<f64> {
        values.iter().zip(&self.weights).map(|(value, weight)| value * weight).collect()
    }

    /// The value with a penalty on each broken condition.
    fn merit(&self, values: &[f64]) -> f64 {
        if !values.iter().all(|value| value.is_finite()) {
            return f64::INFINITY;
        }
        let weighted = self.weighted(values);
        let broken = self.problem.broken(&weighted);
        weighted[0]
            + broken.zip(&self.penalties).map(|(broken, penalty)| broken * penalty).sum::<f64>()
    }

    fn most_broken(&self) -> f64 {
        self.problem.broken(&self.weighted(&self.values)).fold(0.0, f64::max)
    }

    /// The place after a step, inside the bounds, and the values there.
    fn moved(&mut self, step: &[f64], share: f64) -> Result<(Vec<f64>, Vec<f64>), E> {
        let parts = step.iter().zip(&self.units).map(|(part, unit)| share * part * unit);
        let place: Vec<f64> = self.place.iter().zip(parts).map(|(x, part)| x + part).collect();
        let place = clamped(&place, self.problem.bounds);
        let values = self.asked.values(&place)?;
        Ok((place, values))
    }

    /// Goes down until no step leads further.
    pub(super) fn descend(&mut self) -> Result<LeastEnd, E> {
        let mut gradients = self.gradients()?;
        if magnitude(&gradients[0]) <= 0.0 && self.is_flat()? {
            return Ok(LeastEnd::Flat);
        }
        let mut model = CurvatureModel::new(self.place.len());
        for _ in 0..CONSTRAINED_STEPS {
            let room =
                |[low, high]: &[f64; 2], x: &f64, unit: &f64| [(low - x) / unit, (high - x) / unit];
            let limits: Vec<[f64; 2]> = (self.problem.bounds.iter())
                .zip(&self.place)
                .zip(&self.units)
                .map(|((bounds, x), unit)| room(bounds, x, unit))
                .collect();
            let values = self.weighted(&self.values);
            let n_equations = self.problem.n_equations;
            let terms =
                Terms { gradients: &gradients, values: &values, limits: &limits, n_equations };
            let Some(step) = model.step(&terms) else { return Ok(self.ended()) };
            if magnitude(&step.way) <= LEAST_STEP_RELATIVE {
                return Ok(self.ended());
            }
            for (penalty, multiplier) in self.penalties.iter_mut().zip(&step.multipliers) {
                *penalty = multiplier.abs().max(0.5 * (*penalty + multiplier.abs()));
                if step.is_relaxed {
                    *penalty = penalty.max(1.0) * 10.0;
                }
            }
            let broken: f64 = self
                .problem
                .broken(&values)
                .zip(&self.penalties)
                .map(|(broken, penalty)| broken * penalty * step.kept)
                .sum();
            let slope = terms.slope(&step.way) - broken;
            let merit = self.merit(&self.values);
            if -slope <= LAST_BIT * merit.abs() {
                return Ok(self.ended());
            }
            let Some((place, values)) = self.shortened(&terms, &model, &step.way, slope)? else {
                if model.is_fresh() {
                    return Ok(self.ended());
                }
                model = CurvatureModel::new(self.place.len());
                continue;
            };
            let before = std::mem::replace(&mut self.place, place);
            self.values = values;
            if self.place.iter().zip(&self.units).any(|(x, unit)| LEAST_FAR < (x / unit).abs()) {
                return Ok(LeastEnd::Unbounded);
            }
            let behind = self.gradients()?;
            let way: Vec<f64> = (self.place.iter().zip(&before).zip(&self.units))
                .map(|((x, before), unit)| (x - before) / unit)
                .collect();
            model.learn(&way, [&gradients, &behind], &step.multipliers);
            gradients = behind;
        }
        Ok(self.ended())
    }

    /// How far along a step the penalized value falls enough; none where it does nowhere.
    fn shortened(
        &mut self,
        terms: &Terms<'_>,
        model: &CurvatureModel,
        way: &[f64],
        slope: f64,
    ) -> Result<Option<(Vec<f64>, Vec<f64>)>, E> {
        let merit = self.merit(&self.values);
        let mut share = 1.0;
        for halving in 0..CONSTRAINED_HALVINGS {
            let (place, values) = self.moved(way, share)?;
            let is_enough = |merit_there: f64, share: f64| {
                merit_there < merit && merit_there <= merit + ARMIJO * share * slope
            };
            let there = self.merit(&values);
            if is_enough(there, share) {
                return Ok(Some((place, values)));
            }
            // Curved conditions refuse good steps: one more that leads back to them.
            if halving == 0 && 1 < values.len() && there.is_finite() {
                let corrected = model.corrected(terms, way, &self.weighted(&values));
                if let Some(corrected) = corrected {
                    let (place, values) = self.moved(&corrected, 1.0)?;
                    if is_enough(self.merit(&values), 1.0) {
                        return Ok(Some((place, values)));
                    }
                }
            }
            // The parabola through what is known, not too far from one half.
            let bend = there - merit - share * slope;
            let part =
                if there.is_finite() && 0.0 < bend { -0.5 * slope * share / bend } else { 0.25 };
            share *= part.clamp(0.1, 0.5);
            if -slope * share <= LAST_BIT * merit.abs() {
                break;
            }
        }
        Ok(None)
    }

    fn is_allowed(&self) -> bool {
        self.most_broken() <= CONDITION_RELATIVE
    }

    fn ended(&self) -> LeastEnd {
        if self.is_allowed() { LeastEnd::Settled } else { LeastEnd::Contradictory }
    }

    /// The best of the places a little before and behind in each unknown.
    fn best_beside(&mut self) -> Result<Option<BestBeside>, E> {
        let mut best: Option<BestBeside> = None;
        for k in 0..self.place.len() {
            let mut side = |side: f64| {
                let mut step = vec![0.0; self.place.len()];
                step[k] = side;
                self.moved(&step, 1.0)
            };
            let sides = [side(-LEAST_PROBE_RELATIVE)?, side(LEAST_PROBE_RELATIVE)?];
            let merits = sides.each_ref().map(|(_, values)| self.merit(values));
            for (own, (place, values)) in sides.into_iter().enumerate() {
                let (merit, opposite) = (merits[own], merits[1 - own]);
                if best.as_ref().is_none_or(|best| merit < best.merit) {
                    best = Some(BestBeside { merit, opposite, place, values });
                }
            }
        }
        Ok(best)
    }

    /// Whether the function is the same on both sides in each unknown.
    fn is_flat(&mut self) -> Result<bool, E> {
        for k in 0..self.place.len() {
            for side in [-LEAST_PROBE_RELATIVE, LEAST_PROBE_RELATIVE] {
                let mut step = vec![0.0; self.place.len()];
                step[k] = side;
                #[expect(clippy::float_cmp, reason = "a flat function yields one number")]
                if self.moved(&step, 1.0)?.1[0] != self.values[0] {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Whether a place beside is better, such as beside a saddle or an inflection; the search goes there.
    pub(super) fn leaves_for_better(&mut self) -> Result<bool, E> {
        self.penalties.iter_mut().for_each(|penalty| *penalty = 2.0 * *penalty + 1.0);
        let merit = self.merit(&self.values);
        let Some(BestBeside { merit: least, opposite, place, values }) = self.best_beside()? else {
            return Ok(false);
        };
        // Down on one side by about as much as up on the other: a slope, however small.
        let (fall, rise) = (merit - least, opposite - merit);
        let is_slope =
            LEAST_SLOPE_RELATIVE * merit.abs() < fall && rise < 2.0 * fall && fall < 2.0 * rise;
        let is_better = is_slope || least < merit - LEAST_GAIN_RELATIVE * (1.0 + merit.abs());
        if is_better {
            (self.place, self.values) = (place, values);
        }
        Ok(is_better)
    }
}

/// Numbers brought between their bounds.
fn clamped(place: &[f64], bounds: &[[f64; 2]]) -> Vec<f64> {
    place.iter().zip(bounds).map(|(x, [low, high])| x.max(*low).min(*high)).collect()
}
