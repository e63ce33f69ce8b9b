//! Curves that a search has fitted to points.

use std::cell::OnceCell;

use glam::DVec3;

use super::span_errors::SpanErrors;
use crate::NurbsCurve;

/// A curve fitted to the points.
#[derive(Clone)]
pub(super) struct FittedCurve {
    pub(super) curve: NurbsCurve,
    pub(super) parameters: Vec<f64>,
    /// Distances of the points from the curve at their parameters.
    pub(super) misses: Vec<f64>,
    pub(super) worst: f64,
    /// The sum of their squares.
    pub(super) squares: f64,
    /// Point, first and second derivative of the curve at each parameter, where they were asked for.
    pub(super) places: Vec<[DVec3; 3]>,
    /// Whether it makes no detour between two points of the search that it is of, once that was asked for.
    pub(super) is_straight: OnceCell<bool>,
}

impl FittedCurve {
    pub(super) fn new(curve: NurbsCurve, parameters: Vec<f64>, misses: Vec<f64>) -> Self {
        let worst = misses.iter().fold(0.0_f64, |worst, &miss| worst.max(miss));
        let squares = misses.iter().map(|miss| miss * miss).sum();
        let (places, is_straight) = (Vec::new(), OnceCell::new());
        Self { curve, parameters, misses, worst, squares, places, is_straight }
    }

    pub(super) fn n_control(&self) -> usize {
        self.curve.control_points().len()
    }

    /// What the spans miss, if that falls with their width to the power of an order.
    pub(super) fn span_errors(&self, order: f64) -> SpanErrors {
        SpanErrors::new(self.curve.knots(), &self.parameters, &self.misses, order)
    }
}

/// Curves each of which came from the one before by letting points slide: the last, and the one that misses least.
pub(super) struct SlideTrail {
    last: FittedCurve,
    /// The one that misses least, where it is not the last.
    before: Option<FittedCurve>,
}

impl SlideTrail {
    pub(super) fn new(first: FittedCurve) -> Self {
        Self { last: first, before: None }
    }

    pub(super) fn last(&self) -> &FittedCurve {
        &self.last
    }

    pub(super) fn best(&self) -> &FittedCurve {
        self.before.as_ref().unwrap_or(&self.last)
    }

    pub(super) fn push(&mut self, next: FittedCurve) {
        let is_best = next.worst < self.best().worst;
        let last = std::mem::replace(&mut self.last, next);
        self.before = if is_best { None } else { self.before.take().or(Some(last)) };
    }

    pub(super) fn into_best(self) -> FittedCurve {
        self.before.unwrap_or(self.last)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{FittedCurve, SlideTrail};
    use crate::NurbsCurve;

    #[test]
    fn the_best_of_a_trail_is_the_first_that_misses_least() {
        let missing = |miss: f64| {
            let line = NurbsCurve::line(DVec3::ZERO, DVec3::X).expect("a line");
            FittedCurve::new(line, vec![0.0, 1.0], vec![miss])
        };
        let mut trail = SlideTrail::new(missing(4.0));
        for (miss, least) in [(3.0, 3.0), (5.0, 3.0), (6.0, 3.0), (2.0, 2.0), (2.5, 2.0)] {
            trail.push(missing(miss));
            assert_eq!((trail.last().worst, trail.best().worst), (miss, least));
        }
        assert!((trail.into_best().worst - 2.0).abs() < 1e-15);
    }
}
