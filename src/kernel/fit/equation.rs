//! Linear conditions on the control points of a spline.

use crate::KnotVector;
pub(crate) use crate::numeric::banded::Equation;

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
}
