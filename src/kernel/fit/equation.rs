//! Linear conditions on the control points of a spline.

use std::ops::Range;

use smallvec::smallvec;

pub(crate) use crate::numeric::banded::Equation;
use crate::{
    KnotVector,
    numeric::banded::{BandedSystem, Coefficients},
};

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

/// The equations of a spline whose points at the parameters are given, as many as it has control
/// points, ready to be solved; `None` where they do not determine it.
///
/// As [`Equation::points`], without a list of them.
pub(super) fn band_of_points(knots: &KnotVector, parameters: &[f64]) -> Option<BandedSystem> {
    let (all, n, degree) = (knots.as_slice(), parameters.len(), knots.degree());
    // Function j is zero before knot j and behind knot j + p + 1. Schoenberg & Whitney, *On Pólya
    // frequency functions III* (1953): where more than p of them lie between, nothing is determined.
    let ends = |reach: usize| all[degree + 1..].iter().zip(&parameters[n.min(reach + 1)..]);
    let starts =
        |reach: usize| all[reach + 1..].iter().zip(&parameters[..n.max(reach + 1) - reach - 1]);
    let before = (0..=degree).find(|&reach| ends(reach).all(|(end, t)| end <= t))?;
    let behind = (0..=degree).find(|&reach| starts(reach).all(|(start, t)| t <= start))?;
    // One that is as wide on both sides is solved faster.
    let reach = if before.max(behind) == 2 { [2; 2] } else { [before, behind] };
    let mut band = BandedSystem::totally_positive(n, reach);
    for (i, (span, acting)) in each_span(knots, parameters).enumerate() {
        let first = span - knots.degree();
        knots.with_basis_on(span, parameters[i], |values| match acting.len() == values.len() {
            true => band.add(i, first, values),
            false => band.add(i, acting.start, &values[acting.start - first..acting.end - first]),
        });
    }
    band.factored()
}

/// The span of each parameter, and the control points that count there: not those whose functions
/// begin or end at it.
fn each_span(
    knots: &KnotVector,
    parameters: &[f64],
) -> impl Iterator<Item = (usize, Range<usize>)> {
    let (all, degree, mut span) = (knots.as_slice(), knots.degree(), knots.degree());
    parameters.iter().map(move |&t| {
        span = knots.span_from(span, t);
        let first = span - degree;
        if all[span] < t && t < all[span + 1] {
            return (span, first..span + 1);
        }
        let is_there = |knot: &&f64| t.total_cmp(knot).is_eq();
        let n_ending = all[span + 1..].iter().take_while(is_there).count().min(degree);
        let n_beginning = all[..=span].iter().rev().take_while(is_there).count().min(degree);
        (span, first + n_ending..(span + 1 - n_beginning).max(first + n_ending + 1))
    })
}
