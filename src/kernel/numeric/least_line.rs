//! How far a search for a least value goes along a step.
//!
//! So far that the function falls by enough, and falls there by clearly less than where the step begins: so the model of its
//! curvature learns of kinks on the way as well. Lewis & Overton, *Nonsmooth optimization via quasi-Newton methods*,
//! Math. Programming 141 (2013), algorithm 2.6; with the corrections of Nocedal & Wright, *Numerical Optimization*, §18.3,
//! where a step is refused.

use super::{
    answers::{Answers, Wanted},
    least_model::{CurvatureModel, Terms, magnitude},
    least_search::{LeastSearch, Lower},
    quadratic_program::dot,
};
use crate::{
    ceiling::CONSTRAINED_HALVINGS,
    tolerance::{ARMIJO, CONDITION_RELATIVE, LEAST_FAR},
};

/// The share of its slope at the beginning by which a function still falls where a step is to go on.
const STEEP_SHARE: f64 = 0.9;

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// The place along a step where the penalized value fell by enough; none where it does nowhere.
    pub(super) fn shortened(
        &mut self,
        terms: &Terms<'_>,
        model: &CurvatureModel,
        way: &[f64],
        slope: f64,
    ) -> Result<Option<Lower>, E> {
        let merit = self.merit(&self.values);
        // Not beyond where it is far away.
        let room = terms.room(way).min((LEAST_FAR / magnitude(way)).max(1.0));
        let (mut share, mut low, mut high) = (1.0, 0.0, f64::INFINITY);
        let mut best = None;
        for halving in 0..CONSTRAINED_HALVINGS {
            let (place, values) = self.moved(way, share)?;
            // Farther than the model leads nothing holds it where conditions bend.
            if 1.0 < share && self.breaks_more(terms, &values) {
                break;
            }
            let is_enough = |merit_there: f64, share: f64| {
                merit_there < merit && merit_there <= merit + ARMIJO * share * slope
            };
            let there = self.merit(&values);
            if is_enough(there, share) {
                let gradients = self.gradients_at(&place)?;
                let is_steep = self.merit_slope(&gradients, &values, way) < STEEP_SHARE * slope;
                best = Some(Lower { place, values, gradients: Some(gradients) });
                if !is_steep || room <= share {
                    return Ok(best);
                }
                low = share;
            } else {
                high = share;
                // Curved conditions refuse good steps: one more that leads back to them.
                if halving == 0 && 1 < values.len() && there.is_finite() {
                    let corrected = model.corrected(terms, way, &self.weighted(&values));
                    if let Some(corrected) = corrected {
                        let (place, values) = self.moved(&corrected, 1.0)?;
                        if is_enough(self.merit(&values), 1.0) {
                            return Ok(Some(Lower { place, values, gradients: None }));
                        }
                    }
                }
            }
            share = if high.is_infinite() {
                room.min(share * 2.0_f64.max(share))
            } else if 0.0 < low {
                0.5 * (low + high)
            } else {
                // The parabola through what is known, not too far from one half.
                let bend = there - merit - share * slope;
                let part = if there.is_finite() && 0.0 < bend {
                    -0.5 * slope * share / bend
                } else {
                    0.25
                };
                share * part.clamp(0.1, 0.5)
            };
            let reach = share - low;
            if -slope * reach <= self.resolution(reach * magnitude(way)) {
                break;
            }
        }
        Ok(best)
    }

    /// Whether a condition is broken by more than where a step begins.
    fn breaks_more(&self, terms: &Terms<'_>, values: &[f64]) -> bool {
        let weighted = self.weighted(values);
        let before = self.problem.broken(terms.values);
        let mut pairs = self.problem.broken(&weighted).zip(before);
        pairs.any(|(there, here)| here + CONDITION_RELATIVE < there)
    }

    /// How the penalized value changes along a way from a place with these gradients and values.
    fn merit_slope(&self, gradients: &[Vec<f64>], values: &[f64], way: &[f64]) -> f64 {
        let given = gradients[1..].iter().zip(&values[1..]).zip(&self.penalties).enumerate();
        let broken = given.map(|(idx, ((gradient, &value), penalty))| match value {
            value if value < 0.0 => -penalty * dot(gradient, way),
            value if 0.0 < value && idx < self.problem.n_equations => penalty * dot(gradient, way),
            _ => 0.0,
        });
        dot(&gradients[0], way) + broken.sum::<f64>()
    }
}
