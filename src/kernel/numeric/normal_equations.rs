//! The equations of a damped step towards the least squares.
//!
//! Nocedal & Wright, *Numerical Optimization*, §10.3.

use super::symmetric_band::SymmetricBand;
use crate::tolerance::STEP_REST_RELATIVE;

/// The equations of the step to the least squares of functions that were linear.
pub(super) struct NormalEquations {
    /// Products of the columns, by rows.
    products: Vec<Vec<f64>>,
    /// Products of the columns and the residuals, with the other sign.
    pub(super) right: Vec<f64>,
}

impl NormalEquations {
    pub(super) fn new(gradients: &[Vec<f64>], residuals: &[f64]) -> Self {
        let n = gradients.first().map_or(0, Vec::len);
        let (mut products, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
        for (gradient, residual) in gradients.iter().zip(residuals) {
            for (k, slope) in gradient.iter().enumerate() {
                right[k] -= slope * residual;
                products[k].iter_mut().zip(gradient).for_each(|(sum, other)| *sum += slope * other);
            }
        }
        Self { products, right }
    }

    /// Lets an unknown stay as it is.
    pub(super) fn hold(&mut self, k: usize) {
        self.right[k] = 0.0;
        self.products.iter_mut().for_each(|row| row[k] = 0.0);
        self.products[k].fill(0.0);
    }

    /// The step with a damping, which is a share of each diagonal coefficient.
    pub(super) fn step(&self, damping: f64) -> Vec<f64> {
        let n = self.right.len();
        let most = (0..n).map(|k| self.products[k][k]).fold(0.0, f64::max);
        let least = if 0.0 < most { most * STEP_REST_RELATIVE } else { 1.0 };
        let mut equations = SymmetricBand::new(n, n);
        for (row, products) in self.products.iter().enumerate() {
            for (column, product) in products.iter().enumerate().skip(row) {
                let more = if column == row {
                    damping * product.max(least) + least * damping
                } else {
                    0.0
                };
                equations.set(row, column, product + more);
            }
        }
        let mut step = self.right.clone();
        match equations.solve(&mut step) {
            Some(()) if step.iter().all(|part| part.is_finite()) => step,
            _ => vec![0.0; n],
        }
    }
}
