//! The least value between kinks, where a search for a least value settled beside some.
//!
//! Beside kinks a function is several smooth ones that take turns. Each is known by its plane at a place where it was
//! asked; where the greatest of them is least, with the curvature that the search learned, is where it is asked next, until
//! they promise nothing that counts: then nothing near by is lower, as far as they tell. Kiwiel, *Proximity control in
//! bundle methods for convex nondifferentiable minimization*, Math. Programming 46 (1990); Bonnans, Gilbert, Lemaréchal &
//! Sagastizábal, *Numerical Optimization*, ch. 10.

use super::{
    answers::{Answers, Wanted, beside},
    least_model::{CurvatureModel, Plane, Terms, magnitude},
    least_search::LeastSearch,
    quadratic_program::dot,
};
use crate::{
    ceiling::{KINK_GIVEN_UP, KINK_LOOKS, KINK_PLANES, KINK_STEPS, KINK_UNKNOWNS, SETTLING_STEPS},
    tolerance::{
        DIFFERENCE_RELATIVE, KINK_BEND_MOST, KINK_BESIDE_RELATIVE, KINK_DIFFERENCE_RELATIVE,
        KINK_FARTHER, KINK_FARTHEST_RELATIVE, KINK_PROMISE_RELATIVE, KINK_ROUNDINGS,
        KINK_SHARE_MOST, KINK_SLOPE_RELATIVE, LAST_BIT, LEAST_PROBE_RELATIVE, PLANE_RELATIVE,
    },
};

/// The share of a promised fall that is worth going to, and the one from which on ways are made longer.
const KEPT: f64 = 0.1;
const WELL_KEPT: f64 = 0.5;

/// By how much the curvature is lessened where ways are made longer.
const LONGER: f64 = 0.2;

/// Planes of a function near a place.
struct Planes {
    known: Vec<Plane>,
    /// The share of the curvature that counts.
    share: f64,
    /// A promise that means nothing: what the function says there is hidden by rounding.
    floor: f64,
    /// Whether some of them are of different smooth functions.
    are_kinked: bool,
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// How steeply the function fell, at most, along the last steps.
    fn steepest(&self) -> f64 {
        let last = self.steepness.iter().rev().take(SETTLING_STEPS);
        last.copied().fold(0.0, f64::max)
    }

    /// Whether the search settled without its slopes becoming less, or never came away from the start.
    fn is_steep(&self) -> bool {
        let least = KINK_SLOPE_RELATIVE * self.steepest();
        self.steepness.last().is_some_and(|end| least <= *end)
    }

    /// Whether the place at which the search settled is beside kinks: its slopes became no less, or differences over so much
    /// that they are of both sides are others than those of one side, by more than what the function bends.
    pub(super) fn is_beside_kinks(&mut self, is_kinked: bool) -> Result<bool, E> {
        if !self.asked.has_differences {
            return Ok(is_kinked || self.is_steep());
        }
        let (place, values) = (self.place.clone(), self.values.clone());
        self.asked.reach = KINK_DIFFERENCE_RELATIVE;
        let beside = self.slopes_beside(&place, &values);
        self.asked.reach = DIFFERENCE_RELATIVE;
        let bent = 2.0 * (KINK_BESIDE_RELATIVE + DIFFERENCE_RELATIVE) * self.bend_beside();
        let hidden =
            KINK_ROUNDINGS * LAST_BIT * self.merit(&self.values).abs() / KINK_DIFFERENCE_RELATIVE;
        let least = (KINK_SLOPE_RELATIVE * self.steepest()).max(bent).max(hidden);
        let is_unlike = beside?.0.iter().zip(&self.slopes).any(|(one, both)| {
            least.max(KINK_SLOPE_RELATIVE * magnitude(one)) < distance(one, both)
        });
        Ok(is_unlike || is_kinked && !self.bends_evenly()?)
    }

    /// Goes to the least value between the kinks beside the place; whether there are some.
    pub(super) fn settle_between_kinks(&mut self) -> Result<bool, E> {
        if !self.is_steep() || KINK_UNKNOWNS < self.place.len() {
            return Ok(false);
        }
        let before = (self.place.clone(), self.values.clone(), self.slopes.clone());
        self.asked.reach = KINK_DIFFERENCE_RELATIVE;
        let is_kinked = self.follow_planes();
        self.asked.reach = DIFFERENCE_RELATIVE;
        // Differences over so little are too rough where there is no kink.
        if self.asked.has_differences && matches!(is_kinked, Ok(false)) {
            (self.place, self.values, self.slopes) = before;
        }
        is_kinked
    }

    fn follow_planes(&mut self) -> Result<bool, E> {
        self.is_shown = false;
        let n = self.place.len();
        let model = self.learned.take().unwrap_or_else(|| CurvatureModel::new(n)).evened();
        let (place, values) = (self.place.clone(), self.values.clone());
        let (slopes, below) = self.slopes_beside(&place, &values)?;
        let first = Plane { gradient: slopes[0].clone(), gap: below.abs() };
        self.slopes = slopes;
        let mut planes = Planes { known: vec![first], share: 1.0, floor: 0.0, are_kinked: false };
        let mut n_given_up = 0;
        for step in 0..KINK_STEPS {
            if KINK_SHARE_MOST < planes.share || step == KINK_LOOKS && !planes.are_kinked {
                break;
            }
            let rounding = self.rounding(&planes.known);
            planes.known[1..].iter_mut().for_each(|plane| plane.gap = plane.gap.max(rounding));
            let terms = Terms {
                gradients: &self.slopes,
                values: &self.weighted(&self.values),
                limits: &self.limits(&self.place),
                n_equations: self.problem.n_equations,
            };
            let Some((way, fall)) = model.step_below(&terms, &planes.known, &[], planes.share)
            else {
                n_given_up += 1;
                if KINK_GIVEN_UP < n_given_up {
                    break;
                }
                planes.known.truncate(1);
                planes.share /= LONGER * LONGER;
                continue;
            };
            let broken = self.problem.broken(terms.values).zip(&self.penalties);
            let promised = fall + broken.map(|(broken, penalty)| broken * penalty).sum::<f64>();
            let (here, reach) = (self.merit(&self.values), magnitude(&way));
            let is_nothing = promised <= planes.floor.max(rounding);
            if !is_nothing && self.is_lower(here - promised, reach) {
                self.look_along(&way, promised, rounding, &mut planes)?;
            } else if reach < LEAST_PROBE_RELATIVE && 1.0 < KINK_SHARE_MOST * planes.share {
                planes.share *= LONGER;
            } else {
                self.is_shown = !self.has_planes_above;
                break;
            }
        }
        Ok(planes.are_kinked)
    }

    /// Asks where the planes promise to be lower, and goes there if it is; they learn of one more.
    fn look_along(
        &mut self,
        way: &[f64],
        promised: f64,
        rounding: f64,
        planes: &mut Planes,
    ) -> Result<(), E> {
        let (place, values) = self.moved(way, 1.0)?;
        let kept = (self.merit(&self.values) - self.merit(&values)) / promised;
        if !kept.is_finite() {
            planes.share /= LONGER;
            return Ok(());
        }
        let (slopes, below) = self.slopes_beside(&place, &values)?;
        let way = self.way_between(&self.place, &place);
        let fall = self.weights[0] * (self.values[0] - values[0]);
        let gradient = slopes[0].clone();
        let off = distance(&gradient, &planes.known[0].gradient);
        let least = KINK_SLOPE_RELATIVE * self.steepest();
        planes.are_kinked |= least.max(KINK_BEND_MOST * magnitude(&way)) < off;
        let above = -rounding.max(self.little());
        if KEPT < kept {
            for plane in &mut planes.known {
                let gap = plane.gap - fall - dot(&plane.gradient, &way);
                self.has_planes_above |= gap < above;
                plane.gap = gap.abs();
            }
            (self.place, self.values, self.slopes) = (place, values, slopes);
            self.beside.clear();
            if WELL_KEPT < kept {
                planes.share *= LONGER;
            }
            planes.known.retain(|known| !known.is_alike(&gradient));
            planes.known.insert(0, Plane { gradient, gap: below.abs() });
        } else {
            let gap = fall + below + dot(&gradient, &way);
            self.has_planes_above |= gap < above;
            let gap = gap.abs();
            let is_hidden = promised <= self.little() || fall == 0.0;
            planes.learn(Plane { gradient, gap: gap.max(rounding) }, promised, is_hidden);
        }
        if KINK_PLANES * (self.place.len() + 2) < planes.known.len() {
            let gaps = planes.known.iter().map(|plane| plane.gap).enumerate();
            let lowest = gaps.skip(1).max_by(|a, b| a.1.total_cmp(&b.1));
            lowest.map(|(k, _)| planes.known.remove(k));
        }
        Ok(())
    }

    /// The gradients at a place, and by how much the plane is below the value there. Differences are taken a little beside:
    /// at a kink itself, to which steps lead, they are those of no side; and farther beside as long as they are across one.
    pub(super) fn slopes_beside(
        &mut self,
        place: &[f64],
        values: &[f64],
    ) -> Result<(Vec<Vec<f64>>, f64), E> {
        if !self.asked.has_differences {
            return Ok((self.gradients_at(place)?, 0.0));
        }
        let mut far = KINK_BESIDE_RELATIVE;
        let (side, there, slopes) = loop {
            let turn = self.asked.n_evaluations;
            let side = beside(place, self.problem.bounds, far, turn);
            let there = self.asked.values(&side)?;
            let slopes = self.gradients_at(&side)?;
            far *= KINK_FARTHER;
            if !self.is_across(&slopes) || KINK_FARTHEST_RELATIVE < far {
                break (side, there, slopes);
            }
        };
        let back = dot(&slopes[0], &self.way_between(place, &side));
        Ok((slopes, self.weights[0] * (values[0] - there[0]) + back))
    }

    /// Whether the last differences, which these slopes are, were taken across a kink.
    pub(super) fn is_across(&self, slopes: &[Vec<f64>]) -> bool {
        if !self.asked.has_differences {
            return false;
        }
        let bend = KINK_BEND_MOST.max(4.0 * self.bend_beside()) * KINK_DIFFERENCE_RELATIVE;
        let jumps = self.scaled(self.asked.jumps.clone());
        jumps.iter().zip(slopes).any(|(jumps, slopes)| {
            bend.max(KINK_SLOPE_RELATIVE * magnitude(slopes)) < magnitude(jumps)
        })
    }

    /// A fall that counts for nothing beside the value and the fall so far.
    pub(super) fn little(&self) -> f64 {
        let here = self.merit(&self.values);
        KINK_PROMISE_RELATIVE * here.abs().max(self.start_merit - here)
    }

    /// What the value may be wrong by where the unknowns are by their last bits.
    pub(super) fn rounding(&self, planes: &[Plane]) -> f64 {
        let sizes: Vec<f64> =
            self.place.iter().zip(&self.units).map(|(x, u)| (x / u).abs()).collect();
        let sum = |plane: &Plane| -> f64 {
            plane.gradient.iter().zip(&sizes).map(|(slope, size)| slope.abs() * size).sum()
        };
        KINK_ROUNDINGS * LAST_BIT * planes.iter().map(sum).fold(0.0, f64::max)
    }
}

impl Planes {
    /// Takes up the plane of a place that was not as low as promised. One that tells nothing new shortens the next way, or
    /// means that rounding hides what is promised.
    fn learn(&mut self, plane: Plane, promised: f64, is_hidden: bool) {
        let alike = self.known.iter().position(|known| known.is_alike(&plane.gradient));
        let is_news = alike.is_none_or(|k| plane.gap + KEPT * promised < self.known[k].gap);
        if promised < plane.gap || !is_news && !is_hidden || is_news && alike == Some(0) {
            self.share /= LONGER;
        }
        if !is_news && is_hidden {
            self.floor = self.floor.max(2.0 * promised);
        }
        if is_news && alike != Some(0) {
            alike.map(|k| self.known.remove(k));
            self.known.push(plane);
        }
    }
}

impl Plane {
    /// Whether a gradient is that of the same smooth function.
    fn is_alike(&self, gradient: &[f64]) -> bool {
        let size = magnitude(gradient).max(magnitude(&self.gradient));
        distance(gradient, &self.gradient) <= PLANE_RELATIVE * size
    }
}

/// The largest difference of two lists of numbers.
pub(super) fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
