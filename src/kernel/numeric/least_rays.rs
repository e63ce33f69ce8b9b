//! Better places beside one where planes hold one another off, but bend down between.
//!
//! Of a function that is convex near by, a hull of gradients that holds zero is a proof; of one that is not, such as
//! |y − 2|x||, it may hold zero where the function falls along a kink. There each plane tells a way down, and the planes
//! that it meets tell the kinks on which to stay. Gürbüzbalaban & Overton, *On Nesterov's nonsmooth Chebyshev–Rosenbrock
//! functions*, Nonlinear Analysis 75 (2012).

use super::{
    answers::{Answers, Wanted},
    least_beside::free_ways,
    least_kinks::distance,
    least_model::{HoldingCondition, Plane, Terms, magnitude},
    least_search::LeastSearch,
    quadratic_program::dot,
};
use crate::{
    ceiling::KINK_HULL_PLANES,
    tolerance::{KINK_SLOPE_RELATIVE, LEAST_PROBE_RELATIVE},
};

/// The share of a steepness over a way above which a plane counts as above the function.
const ABOVE: f64 = 0.1;

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Whether a place is lower beside where planes bend down between one another, as those of −|x| do, so that their hull
    /// holds zero though the function falls along a kink; the search goes there. From each plane the way is followed that
    /// goes down, and where another plane counts there the kink between both.
    pub(super) fn leaves_between_planes(&mut self, planes: Vec<Plane>) -> Result<bool, E> {
        let mut gradients: Vec<Vec<f64>> = planes.into_iter().map(|plane| plane.gradient).collect();
        if !self.bends_down_between(&gradients)? {
            return Ok(false);
        }
        let n = self.place.len();
        let mut idx = 0;
        while idx < gradients.len() && idx < KINK_HULL_PLANES * (n + 2) {
            let first = gradients[idx].clone();
            let mut kinks = Vec::new();
            while let Some(way) = self.way_down(&first, &kinks) {
                let (place, values) = self.moved(&way, LEAST_PROBE_RELATIVE)?;
                if self.is_lower(self.merit(&values), LEAST_PROBE_RELATIVE) {
                    self.leave_for((place, values), LEAST_PROBE_RELATIVE);
                    return Ok(true);
                }
                let slope = self.slopes_beside(&place, &values)?.0.swap_remove(0);
                let is_known = |known: &Vec<f64>| {
                    distance(known, &slope) <= KINK_SLOPE_RELATIVE * magnitude(&slope)
                };
                if !gradients.iter().any(is_known) {
                    gradients.push(slope.clone());
                }
                if is_known(&first) || kinks.len() == n {
                    break;
                }
                let normal = slope.iter().zip(&first).map(|(other, first)| other - first);
                kinks.push(normal.collect());
            }
            idx += 1;
        }
        Ok(false)
    }

    /// Whether one of the planes is above the function where another one goes down, which convex functions have nowhere.
    fn bends_down_between(&mut self, gradients: &[Vec<f64>]) -> Result<bool, E> {
        for gradient in gradients {
            let Some(way) = self.way_down(gradient, &[]) else { continue };
            let there = self.moved(&way, LEAST_PROBE_RELATIVE)?.1;
            let rise = self.merit(&there) - self.merit(&self.values);
            let heights = gradients.iter().map(|own| LEAST_PROBE_RELATIVE * dot(own, &way));
            let highest = heights.fold(f64::NEG_INFINITY, f64::max);
            if rise + ABOVE * LEAST_PROBE_RELATIVE * magnitude(gradient) < highest {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The way along which a plane goes down most steeply on some kinks and what holds the place, its largest part one;
    /// none where it is level there.
    fn way_down(&self, gradient: &[f64], kinks: &[Vec<f64>]) -> Option<Vec<f64>> {
        let terms = Terms {
            gradients: &self.slopes,
            values: &self.weighted(&self.values),
            limits: &self.limits(&self.place),
            n_equations: self.problem.n_equations,
        };
        let mut holding = if self.is_free() { Vec::new() } else { terms.holding()? };
        holding.extend(kinks.iter().map(|normal| kink(normal.clone())));
        let mut way = vec![0.0; gradient.len()];
        for free in free_ways(&holding, gradient.len()) {
            let down = -dot(gradient, &free);
            way.iter_mut().zip(&free).for_each(|(part, free)| *part += down * free);
        }
        let size = magnitude(&way);
        let is_steep = KINK_SLOPE_RELATIVE * magnitude(gradient) < size;
        is_steep.then(|| way.iter().map(|part| part / size).collect())
    }
}

/// What holds a place on a kink across which the slopes differ so.
fn kink(normal: Vec<f64>) -> HoldingCondition {
    HoldingCondition { idx: 0, normal, multiplier: 0.0 }
}
