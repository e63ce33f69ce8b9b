//! Linear conditions on the control points of a spline.

use smallvec::smallvec;

pub(crate) use crate::numeric::banded::Equation;
use crate::{KnotVector, numeric::banded::Coefficients};

impl Equation {
    /// The spline's point at `t` is given.
    pub(crate) fn point(knots: &KnotVector, t: f64) -> Self {
        Self::point_on(knots, knots.span_at(t), t)
    }

    /// The spline's points at the parameters are given, each found from the span of the one before.
    pub(crate) fn points<'a>(
        knots: &'a KnotVector,
        parameters: &'a [f64],
    ) -> impl Iterator<Item = Self> + 'a {
        let mut span = knots.degree();
        parameters.iter().map(move |&t| {
            span = knots.span_from(span, t);
            Self::point_on(knots, span, t)
        })
    }

    fn point_on(knots: &KnotVector, span: usize, t: f64) -> Self {
        let values = knots.with_basis_on(span, t, Coefficients::from_slice);
        Self { first: span - knots.degree(), values }.without_zeros()
    }

    /// The spline's derivative at `t` is given.
    pub(crate) fn derivative(knots: &KnotVector, t: f64, order: usize) -> Self {
        let span = knots.span_at(t);
        let values = knots.basis_derivatives_on(span, t, order).row(order).into();
        Self { first: span - knots.degree(), values }.without_zeros()
    }

    /// One control point is given.
    pub(crate) fn control_point(index: usize) -> Self {
        Self { first: index, values: smallvec![1.0] }
    }
}
