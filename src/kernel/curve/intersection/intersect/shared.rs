//! Pieces of two curves that are one and the same curve.
//!
//! Such pieces share an arc that ends where one of them does. It is told before anything is halved,
//! since halving would come to as many parts as the arc is tolerances long.

use glam::DVec3;

use super::{
    meeting::{ContactInterval, IntersectionSearch},
    newton::foot,
};
use crate::{GeomError, Interval, curve::representation::part::CurvePart};

/// Places of an arc that are looked at, besides its ends.
const N_LOOKS: usize = 16;

/// Halvings that tell most points beside a piece from those on it.
const FEW_HALVINGS: usize = 5;

/// Roundings within which pieces are the same curve.
const SAME_ROUNDINGS: f64 = 16.0;

impl IntersectionSearch<'_> {
    /// # Errors
    /// `IntersectionError::RunTogether` where two pieces share an arc that is longer than a touch.
    pub(super) fn check_shared(&self, a: &CurvePart, b: &CurvePart) -> Result<(), GeomError> {
        let slack = SAME_ROUNDINGS * self.rounding;
        let may_be_on = |part, point| may_be_on(part, point, slack, FEW_HALVINGS);
        let ends = [a.interval.start(), a.interval.end()].into_iter();
        let ends = ends.filter(|&t| may_be_on(b, self.first.point_at(t)));
        let others = [b.interval.start(), b.interval.end()].into_iter();
        let others = others.map(|s| self.second.point_at(s)).filter(|&point| may_be_on(a, point));
        let others = others.map(|point| foot(self.first, a.interval, point));
        let both = ends.chain(others).filter(|&t| self.is_same_at(t, b.interval));
        let [low, high] = both
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)]);
        let Ok(first) = Interval::new(low, high) else { return Ok(()) };
        if self.extent(self.first, first) <= self.longest_touch
            || !first.steps(N_LOOKS).into_iter().all(|t| self.is_same_at(t, b.interval))
        {
            return Ok(());
        }
        Err(self.run_together(ContactInterval { first, second: b.interval }))
    }

    /// Whether the first curve is at a point of the other, up to rounding.
    fn is_same_at(&self, t: f64, second: Interval) -> bool {
        let p = self.first.point_at(t);
        let nearest = self.second.point_at(foot(self.second, second, p));
        nearest.distance(p) <= SAME_ROUNDINGS * self.rounding
    }
}

/// Whether a point may be on a piece: what is outside of the boxes of all its parts is not on it.
fn may_be_on(part: &CurvePart, point: DVec3, slack: f64, n_halvings: usize) -> bool {
    if part.points.iter().any(|point| point.w <= 0.0) {
        return true;
    }
    part.bounds.contains(point, slack)
        && (n_halvings == 0
            || part.halves().iter().any(|half| may_be_on(half, point, slack, n_halvings - 1)))
}
