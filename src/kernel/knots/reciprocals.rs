//! What the basis divides by, divided once.

use std::{array::from_fn, sync::Arc};

/// Degrees whose basis has no loops.
pub(super) const UNROLLED_DEGREE: usize = 3;

/// Reciprocals of knot differences: a division takes as long as the rest of a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reciprocals {
    /// Spans over the length of the domain.
    pub(super) mean_span: f64,
    /// `1 / (u_{i+q} − u_i)` at `[i][q − 1]`; none for higher degrees.
    pub(super) widths: Arc<[[f64; UNROLLED_DEGREE]]>,
}

impl Reciprocals {
    pub(super) fn new(degree: usize, knots: &[f64]) -> Self {
        let of_knot =
            |i: usize| from_fn(|q| knots.get(i + q + 1).map_or(0.0, |u| 1.0 / (u - knots[i])));
        let n = if degree <= UNROLLED_DEGREE { knots.len() } else { 0 };
        let n_points = knots.len().saturating_sub(degree + 1);
        let n_spans = n_points.saturating_sub(degree);
        let length =
            knots.get(n_points).zip(knots.get(degree)).map_or(1.0, |(end, start)| end - start);
        Self { mean_span: n_spans as f64 / length, widths: (0..n).map(of_knot).collect() }
    }
}
