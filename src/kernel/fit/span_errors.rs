//! What the spans of a fitted curve miss, and the knots with which all would miss alike.

use crate::{KnotVector, tolerance::LEAST_ERROR_SHARE};

/// How much of what a span is taken to miss is its own; the rest is of those beside it.
const OWN_SHARE: f64 = 0.5;

/// What each span of a curve misses its points by at most, smoothed.
#[derive(Clone)]
pub(super) struct SpanErrors {
    breaks: Vec<f64>,
    errors: Vec<f64>,
    /// The error of a span falls with its width to this power.
    order: f64,
}

impl SpanErrors {
    /// Of points at ordered parameters.
    pub(super) fn new(knots: &KnotVector, parameters: &[f64], misses: &[f64], order: f64) -> Self {
        let breaks = knots.breaks();
        let last = breaks.len().saturating_sub(2);
        let (mut own, mut span) = (vec![0.0_f64; last + 1], 0);
        for (&t, &miss) in parameters.iter().zip(misses) {
            while span < last && breaks[span + 1] <= t {
                span += 1;
            }
            own[span] = own[span].max(miss);
        }
        let largest = own.iter().fold(0.0_f64, |most, &error| most.max(error));
        let least = (LEAST_ERROR_SHARE * largest).max(f64::MIN_POSITIVE);
        let smooth = |i: usize| {
            let beside = 0.5 * (own[i.saturating_sub(1)] + own[(i + 1).min(last)]);
            (OWN_SHARE * own[i] + (1.0 - OWN_SHARE) * beside).max(least)
        };
        let errors = (0..=last).map(smooth).collect();
        Self { breaks, errors, order }
    }

    /// With how many spans, all of which missed by as much, that would be the target.
    pub(super) fn n_wanted(&self, target: f64) -> f64 {
        self.errors.iter().map(|&error| self.need(error / target)).sum()
    }

    /// Knots of so many spans with which all would miss alike: de Boor, *A Practical Guide to Splines*, §XII; Burchard,
    /// *Splines (with optimal knots) are better*, Applicable Analysis 3 (1974). `None` where they run into one.
    pub(super) fn knots(&self, degree: usize, n_spans: usize) -> Option<KnotVector> {
        let inner = self.inner(n_spans);
        let [start, end] =
            [self.breaks[0], self.breaks[self.breaks.len() - 1]].map(|t| vec![t; degree + 1]);
        KnotVector::new(degree, [&start[..], &inner, &end].concat()).ok()
    }

    /// The knots between the ends.
    pub(super) fn inner(&self, n_spans: usize) -> Vec<f64> {
        let largest = self.errors.iter().fold(0.0_f64, |most, &error| most.max(error));
        let needs: Vec<f64> = self.errors.iter().map(|&error| self.need(error / largest)).collect();
        let step = needs.iter().sum::<f64>() / n_spans as f64;
        let (mut span, mut before) = (0, 0.0);
        let knot = |i: usize| {
            let wanted = step * i as f64;
            while span + 1 < needs.len() && before + needs[span] < wanted {
                before += needs[span];
                span += 1;
            }
            let width = self.breaks[span + 1] - self.breaks[span];
            self.breaks[span] + (wanted - before) / needs[span] * width
        };
        (1..n_spans).map(knot).collect()
    }

    /// How many spans stand for one with so many times the error.
    fn need(&self, error: f64) -> f64 {
        libm::pow(error, 1.0 / self.order)
    }
}

#[cfg(test)]
mod tests {
    use super::SpanErrors;
    use crate::KnotVector;

    /// Spans of the widths 1, 1, 2 that miss by these.
    fn errors(misses: [f64; 3]) -> SpanErrors {
        let knots = KnotVector::new(1, vec![0.0, 0.0, 1.0, 2.0, 4.0, 4.0]).expect("clamped");
        SpanErrors::new(&knots, &[0.5, 1.5, 3.0], &misses, 4.0)
    }

    #[test]
    fn spans_that_miss_alike_keep_their_knots() {
        let even = errors([2.0; 3]);
        assert!(even.inner(3).iter().zip([1.0, 2.0]).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!((even.n_wanted(2.0) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_sixteenth_of_the_error_takes_twice_the_spans_of_order_four() {
        assert!((errors([1.0; 3]).n_wanted(1.0 / 16.0) - 6.0).abs() < 1e-12);
    }

    #[test]
    fn knots_move_to_where_more_is_missed() {
        let found = errors([16.0, 1.0, 1.0]).inner(3);
        assert!(found[0] < 1.0 && found[1] < 2.0, "{found:?}");
    }
}
