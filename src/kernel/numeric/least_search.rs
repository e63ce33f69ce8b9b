//! The steps of a search for a least value under conditions.
//!
//! Nocedal & Wright, *Numerical Optimization*, algorithm 18.3, with the corrections of §18.3 where a step is
//! refused.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_bending::Bending,
    least_model::{CurvatureModel, ModelStep, Terms, magnitude},
    least_problem::{LeastEnd, LeastProblem},
    least_trail::LeastTrail,
};
use crate::{
    ceiling::{CONDITION_CORRECTIONS, CONSTRAINED_STEPS, HEAVIER_CONDITIONS, STALLED_STEPS},
    tolerance::{
        CONDITION_RELATIVE, CONTRADICTION_RELATIVE, LAST_BIT, LEAST_FALL_REACH,
        LEAST_FALL_RELATIVE, LEAST_FAR, LEAST_LOWER_RELATIVE, LEAST_STALL_RELATIVE,
        LEAST_STALL_SHARE, LEAST_STEP_RELATIVE,
    },
};

/// Changes that mean nothing, together worth a way.
const RESOLUTIONS: f64 = 100.0;

/// A lower place that a step leads to.
pub(super) struct Lower {
    pub(super) place: Vec<f64>,
    pub(super) values: Vec<f64>,
    /// The weighted gradients there, where they were asked for.
    pub(super) gradients: Option<Vec<Vec<f64>>>,
}

/// A search under way. Unknowns are those of the problem, steps are in units of `units`.
pub(super) struct LeastSearch<'a, F> {
    pub(super) problem: LeastProblem<'a>,
    pub(super) asked: &'a mut CountedFunctions<F>,
    /// A typical size of each unknown.
    pub(super) units: Vec<f64>,
    /// What each function counts with: its steepness at the start is one, or where that is next to none its change over
    /// sizes that were widened.
    pub(super) weights: Vec<f64>,
    pub(super) place: Vec<f64>,
    pub(super) values: Vec<f64>,
    /// The weight of each broken condition.
    pub(super) penalties: Vec<f64>,
    /// The weighted gradients at the place where the steps ended.
    pub(super) slopes: Vec<Vec<f64>>,
    pub(super) trail: LeastTrail,
    /// How far the last place was that was lower beside an end.
    pub(super) left_by: f64,
    /// Whether places beside its end were better again and again.
    pub(super) is_left: bool,
    /// Whether beside kinks more was promised than found.
    pub(super) is_unproven: bool,
    /// Whether planes between kinks tell that nothing near by is lower.
    pub(super) is_shown: bool,
    /// Whether one of them was above the function somewhere, which is not convex then.
    pub(super) has_planes_above: bool,
    /// How steeply the function fell along each step.
    pub(super) steepness: Vec<f64>,
    /// The penalized value where the last descent began, and where the first one did.
    pub(super) first_merit: f64,
    pub(super) start_merit: f64,
    /// The weighted gradients where the first descent begins, until it does.
    first_gradients: Option<Vec<Vec<f64>>>,
    /// How the function bends where it settled, but beside kinks.
    pub(super) bending: Option<Bending>,
    /// The curvature where the next steps begin, where that was measured.
    pub(super) curvature: Option<CurvatureModel>,
    /// The curvature that the last descent learned.
    pub(super) learned: Option<CurvatureModel>,
    /// The penalized values beside the place at which the search settled, on both sides along each unknown.
    pub(super) beside: Vec<[f64; 2]>,
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
        let units = problem.units(&place);
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
            slopes: Vec::new(),
            trail: LeastTrail::default(),
            beside: Vec::new(),
            first_gradients: None,
            bending: None,
            curvature: None,
            learned: None,
            left_by: 0.0,
            is_left: false,
            is_unproven: false,
            is_shown: false,
            has_planes_above: false,
            steepness: Vec::new(),
            first_merit: 0.0,
            start_merit: 0.0,
        };
        search.asked.sizes.clone_from(&search.units);
        let slopes = search.asked.gradients(&search.place, search.problem.bounds)?;
        let changes = search.widen_units(&search.scaled(slopes.clone()))?;
        let gradients = search.scaled(slopes.clone());
        for (idx, (gradient, change)) in gradients.iter().zip(changes).enumerate() {
            // A slope that is nothing beside that change tells nothing of the function's.
            let slope = magnitude(gradient);
            let steepness = if slope < LAST_BIT.sqrt() * change { change } else { slope };
            let weight = 1.0 / steepness;
            if 0.0 < weight && weight.is_finite() {
                search.weights[idx] = weight;
            }
        }
        search.start_merit = search.merit(&search.values);
        search.first_gradients = Some(search.scaled(slopes));
        Ok(search)
    }

    /// Gradients of the weighted functions by the unknowns in their units.
    fn gradients(&mut self) -> Result<Vec<Vec<f64>>, E> {
        self.gradients_at(&self.place.clone())
    }

    /// Those at any place.
    pub(super) fn gradients_at(&mut self, place: &[f64]) -> Result<Vec<Vec<f64>>, E> {
        let gradients = self.asked.gradients(place, self.problem.bounds)?;
        Ok(self.scaled(gradients))
    }

    /// Gradients with the weights of their functions, by the unknowns in their units.
    pub(super) fn scaled(&self, mut gradients: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        for (gradient, weight) in gradients.iter_mut().zip(&self.weights) {
            for (slope, unit) in gradient.iter_mut().zip(&self.units) {
                *slope *= unit * weight;
            }
        }
        gradients
    }

    pub(super) fn weighted(&self, values: &[f64]) -> Vec<f64> {
        values.iter().zip(&self.weights).map(|(value, weight)| value * weight).collect()
    }

    /// The value with a penalty on each broken condition.
    pub(super) fn merit(&self, values: &[f64]) -> f64 {
        if !values.iter().all(|value| value.is_finite()) {
            return f64::INFINITY;
        }
        let weighted = self.weighted(values);
        let broken = self.problem.broken(&weighted);
        weighted[0]
            + broken.zip(&self.penalties).map(|(broken, penalty)| broken * penalty).sum::<f64>()
    }

    pub(super) fn most_broken(&self) -> f64 {
        self.problem.broken(&self.weighted(&self.values)).fold(0.0, f64::max)
    }

    /// The place after a step, inside the bounds, and the values there.
    pub(super) fn moved(&mut self, step: &[f64], share: f64) -> Result<(Vec<f64>, Vec<f64>), E> {
        let parts = step.iter().zip(&self.units).map(|(part, unit)| share * part * unit);
        let place: Vec<f64> = self.place.iter().zip(parts).map(|(x, part)| x + part).collect();
        let place = clamped(&place, self.problem.bounds);
        let values = self.asked.values(&place)?;
        Ok((place, values))
    }

    /// The step from a place to another.
    pub(super) fn way_between(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        to.iter().zip(from).zip(&self.units).map(|((x, from), unit)| (x - from) / unit).collect()
    }

    /// Goes down until no step leads further.
    pub(super) fn descend(&mut self) -> Result<LeastEnd, E> {
        let gradients = self.first_gradients.take().map_or_else(|| self.gradients(), Ok)?;
        self.first_merit = self.merit(&self.values);
        if magnitude(&gradients[0]) <= 0.0 && self.is_flat()? {
            return Ok(LeastEnd::Flat);
        }
        let n = self.place.len();
        let mut model = self.curvature.take().unwrap_or_else(|| CurvatureModel::new(n));
        let end = self.descend_by(&mut model, gradients)?;
        if !model.is_fresh() {
            self.learned = Some(model);
        }
        Ok(end)
    }

    fn descend_by(
        &mut self,
        model: &mut CurvatureModel,
        mut gradients: Vec<Vec<f64>>,
    ) -> Result<LeastEnd, E> {
        let n = self.place.len();
        let mut merit_before = f64::INFINITY;
        let mut n_heavier = 0;
        for n_steps in 0..CONSTRAINED_STEPS {
            // Among the roundings of differences it may go down for ever.
            if n_steps % STALLED_STEPS == 0 {
                let merit = self.merit(&self.values);
                let fall = merit_before - merit;
                if fall <= LEAST_STALL_RELATIVE && fall <= LEAST_STALL_SHARE * merit.abs() {
                    return self.ended(gradients);
                }
                merit_before = merit;
            }
            let limits = self.limits(&self.place);
            let values = self.weighted(&self.values);
            let n_equations = self.problem.n_equations;
            let terms =
                Terms { gradients: &gradients, values: &values, limits: &limits, n_equations };
            let Some(step) = model.renewed_step(&terms) else { return self.ended(gradients) };
            self.weigh_conditions(&step);
            let broken: f64 = self
                .problem
                .broken(&values)
                .zip(&self.penalties)
                .map(|(broken, penalty)| broken * penalty * step.kept)
                .sum();
            let slope = terms.slope(&step.way) - broken;
            self.steepness.push(-slope / magnitude(&step.way));
            if magnitude(&step.way) <= LEAST_STEP_RELATIVE {
                return self.ended(gradients);
            }
            if -slope <= self.resolution(magnitude(&step.way)) {
                return self.ended(gradients);
            }
            let Some(Lower { place, values, gradients: there }) =
                self.shortened(&terms, model, &step.way, slope)?
            else {
                if model.is_fresh() {
                    // Beside kinks a broken condition may have to count for more than slopes tell.
                    if n_heavier < HEAVIER_CONDITIONS && CONTRADICTION_RELATIVE < self.most_broken()
                    {
                        n_heavier += 1;
                        self.penalties.iter_mut().for_each(|each| *each = 10.0 * each.max(1.0));
                        continue;
                    }
                    return self.ended(gradients);
                }
                self.learned = Some(std::mem::replace(model, CurvatureModel::new(n)));
                continue;
            };
            let before = std::mem::replace(&mut self.place, place);
            self.values = values;
            if let Some(end) = self.end_far_away() {
                return Ok(end);
            }
            let behind = there.map_or_else(|| self.gradients(), Ok)?;
            let way = self.way_between(&before, &self.place);
            model.learn(&way, [&gradients, &behind], &step.multipliers);
            gradients = behind;
        }
        self.slopes = gradients;
        Ok(LeastEnd::Unsettled)
    }

    /// A change of the penalized value over so far that means nothing: it is rounding, or next to nothing beside the fall so
    /// far, which counts only over ways that are next to none as well: an exponential function falls by as much.
    pub(super) fn resolution(&self, reach: f64) -> f64 {
        let merit = self.merit(&self.values);
        let fall = if reach <= LEAST_FALL_REACH { self.first_merit - merit } else { 0.0 };
        (LAST_BIT * merit.abs()).max(LEAST_FALL_RELATIVE * fall)
    }

    /// Whether a penalized value so far away is lower than that here, by what is worth going there.
    pub(super) fn is_lower(&self, there: f64, reach: f64) -> bool {
        let here = self.merit(&self.values);
        let least = LEAST_LOWER_RELATIVE * here.abs();
        there < here - least.max(RESOLUTIONS * self.resolution(reach))
    }

    /// Goes to a place beside an end, so far away.
    pub(super) fn leave_for(&mut self, (place, values): (Vec<f64>, Vec<f64>), reach: f64) {
        (self.place, self.values, self.left_by) = (place, values, reach);
        self.beside.clear();
    }

    /// Whether nothing holds the unknowns.
    pub(super) fn is_free(&self) -> bool {
        self.values.len() == 1
            && self.problem.bounds.iter().flatten().all(|bound| bound.is_infinite())
    }

    /// How many times the unknowns' sizes the place is away from zero.
    pub(super) fn distance(&self) -> f64 {
        let sizes = self.place.iter().zip(&self.units).map(|(x, unit)| (x / unit).abs());
        sizes.fold(0.0, f64::max)
    }

    /// How it ends where the place is many times the unknowns' sizes away from zero.
    fn end_far_away(&mut self) -> Option<LeastEnd> {
        let distance = self.distance();
        self.trail.keep(distance, self.values[0]);
        (LEAST_FAR < distance).then(|| match self.trail.falls_ever_less() {
            true => LeastEnd::Unattained,
            false => LeastEnd::Unbounded,
        })
    }

    /// Lets each broken condition count by as much as it holds a step off, and for more and more where the conditions
    /// contradict one another.
    fn weigh_conditions(&mut self, step: &ModelStep) {
        for (penalty, multiplier) in self.penalties.iter_mut().zip(&step.multipliers) {
            *penalty = multiplier.abs().max(0.5 * (*penalty + multiplier.abs()));
            if step.is_relaxed {
                *penalty = penalty.max(1.0) * 10.0;
            }
        }
    }

    /// How far each unknown may go down and up from a place.
    pub(super) fn limits(&self, place: &[f64]) -> Vec<[f64; 2]> {
        let sides = self.problem.bounds.iter().zip(place).zip(&self.units);
        sides.map(|(([low, high], x), unit)| [(low - x) / unit, (high - x) / unit]).collect()
    }

    /// How it ends where no step leads further, with the place led back onto conditions that nearly hold.
    fn ended(&mut self, gradients: Vec<Vec<f64>>) -> Result<LeastEnd, E> {
        self.slopes = gradients;
        Ok(match self.most_broken() {
            off if CONTRADICTION_RELATIVE < off => LeastEnd::Contradictory,
            _ if self.holds(CONDITION_RELATIVE)? => LeastEnd::Settled,
            _ => LeastEnd::Unsettled,
        })
    }

    /// Whether the conditions hold where it ended, or where it is led back onto them; a search from there goes on
    /// where it was led back far.
    pub(super) fn is_led_back(&mut self) -> Result<bool, E> {
        self.holds(CONTRADICTION_RELATIVE)
    }

    /// Whether the conditions hold to a fraction, here or where the place is led back onto them.
    fn holds(&mut self, fraction: f64) -> Result<bool, E> {
        let before = (self.place.clone(), self.values.clone());
        for _ in 0..CONDITION_CORRECTIONS {
            let off = self.most_broken();
            if off <= fraction {
                return Ok(true);
            }
            let still = vec![0.0; self.place.len()];
            let Some((place, values)) = self.led_back(&still, &[])? else { break };
            if !self.merit(&values).is_finite() {
                break;
            }
            (self.place, self.values) = (place, values);
            if off <= self.most_broken() {
                break;
            }
        }
        let is_held = self.most_broken() <= fraction;
        if !is_held {
            (self.place, self.values) = before;
        }
        Ok(is_held)
    }

    /// The place a step away, and back by the shortest way to where the conditions hold, by their slopes here;
    /// those that are held are to be zero. None where they contradict one another.
    pub(super) fn led_back(
        &mut self,
        step: &[f64],
        held: &[usize],
    ) -> Result<Option<(Vec<f64>, Vec<f64>)>, E> {
        let (place, values) = self.moved(step, 1.0)?;
        let terms = Terms {
            gradients: &self.slopes,
            values: &self.weighted(&values),
            limits: &self.limits(&place),
            n_equations: self.problem.n_equations,
        };
        let Some(back) = terms.way_back(held) else { return Ok(None) };
        let taken = place.iter().zip(&self.place).zip(&self.units);
        let way: Vec<f64> =
            taken.zip(&back).map(|(((x, from), unit), back)| (x - from) / unit + back).collect();
        self.moved(&way, 1.0).map(Some)
    }
}

/// Numbers brought between their bounds.
pub(super) fn clamped(place: &[f64], bounds: &[[f64; 2]]) -> Vec<f64> {
    place.iter().zip(bounds).map(|(x, [low, high])| x.max(*low).min(*high)).collect()
}
