//! One linear condition on the control points of a spline.

use crate::KnotVector;

/// The condition Σ `values[j]`·P[`first` + j] = a given point.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub(crate) first: usize,
    pub(crate) values: Vec<f64>,
}

impl Equation {
    /// The spline's point at `t` is given.
    pub(crate) fn point(knots: &KnotVector, t: f64) -> Self {
        let row = knots.with_basis(t, |span, basis| (span, basis.to_vec()));
        Self { first: row.0 - knots.degree(), values: row.1 }.without_zeros()
    }

    /// The spline's derivative at `t` is given.
    pub(crate) fn derivative(knots: &KnotVector, t: f64, order: usize) -> Self {
        let span = knots.span_at(t);
        let values = knots.basis_derivatives_on(span, t, order).row(order).to_vec();
        Self { first: span - knots.degree(), values }.without_zeros()
    }

    /// One control point is given.
    pub(crate) fn control_point(index: usize) -> Self {
        Self { first: index, values: vec![1.0] }
    }

    /// The equation divided by its largest coefficient: for right-hand sides of zero.
    pub(crate) fn scaled(mut self) -> Self {
        let largest = self.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if largest > 0.0 {
            self.values.iter_mut().for_each(|value| *value /= largest);
        }
        self
    }

    /// The unknowns that it is about.
    pub(crate) fn columns(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.values.len()
    }

    /// Basis functions that vanish at a knot would only widen the band.
    fn without_zeros(mut self) -> Self {
        let is_zero = |value: &f64| value.abs() <= 0.0;
        let n_leading = self.values.iter().take_while(|value| is_zero(value)).count();
        self.values.drain(..n_leading);
        self.first += n_leading;
        let n_trailing = self.values.iter().rev().take_while(|value| is_zero(value)).count();
        self.values.truncate(self.values.len() - n_trailing);
        self
    }
}
