//! Splines that come nearest to points: linear least squares.

use glam::{DVec3, DVec4};

use super::{interpolate::check_degree, parameters::check_ends};
use crate::{
    CountError, FitError, GeomError, InputError, KnotVector, NurbsCurve,
    numeric::triangular_factor::{TriangularFactor, without_ends},
    tolerance::RANK_RELATIVE,
};

/// Control points that act on a span of a cubic: a number that the compiler knows makes loops faster.
const CUBIC: usize = 4;

/// What a fit is to have at a parameter: a value, or a derivative of an order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FitCondition {
    /// The parameter.
    pub(crate) t: f64,
    /// Which derivative is meant.
    pub(crate) order: usize,
    /// By how much the difference counts more than that of a value.
    pub(crate) weight: f64,
}

/// A basis, with the factored equations of a spline over it that begins at the first value, ends
/// at the last, and comes nearest to those between: the sum of the squared distances at the
/// parameters is least. Curves and the rows and columns of surfaces share it.
///
/// Points of a parabola have the parabola nearest, whose control point is where its end tangents meet:
///
/// ```
/// use virote_kernel::{Approximator, KnotVector, glam::DVec3};
///
/// let parameters = [0.0, 0.2, 0.5, 0.9, 1.0];
/// let points = parameters.map(|t| DVec3::new(t, t * t, 0.0));
/// let fit = Approximator::new(&parameters, KnotVector::bezier(2)?)?.curve(&points)?;
/// assert!(fit.points()[1].distance(DVec3::new(0.5, 0.0, 0.0)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Approximator {
    knots: KnotVector,
    /// The first control point that counts at each parameter.
    firsts: Vec<usize>,
    /// How much it and those behind it count, degree + 1 a parameter.
    shares: Vec<f64>,
    factor: TriangularFactor,
}

impl Approximator {
    /// For values at the parameters, over the given knots. O(n·p²) for n parameters.
    ///
    /// # Errors
    /// [`CountError::CountTooSmall`] for degree 0, [`CountError::TooFewPoints`] below two parameters,
    /// [`InputError::NotFinite`]; [`FitError::Undetermined`] where parts of the spline have too few.
    pub fn new(parameters: &[f64], knots: KnotVector) -> Result<Self, GeomError> {
        check_degree(knots.degree())?;
        check_ends(parameters)?;
        if let Some(index) = parameters.iter().position(|parameter| !parameter.is_finite()) {
            return Err(InputError::NotFinite { what: "parameter", index }.into());
        }
        let width = knots.degree() + 1;
        let mut firsts = Vec::with_capacity(parameters.len());
        let mut shares = Vec::with_capacity(parameters.len() * width);
        let mut span = knots.degree();
        for &t in parameters {
            span = knots.span_from(span, t);
            firsts.push(span + 1 - width);
            knots.with_basis_on(span, t, |basis| shares.extend_from_slice(basis));
        }
        Self::of_rows(knots, firsts, shares)
    }

    /// The same, if its parameters hold every control point by more than rounding.
    ///
    /// # Errors
    /// [`FitError::Undetermined`].
    pub fn determined(self) -> Result<Self, GeomError> {
        let control_points = self.knots.n_points();
        // Of as many values as control points all are met, however little the parameters hold of some.
        if RANK_RELATIVE < self.factor.least_hold() || self.firsts.len() == control_points {
            return Ok(self);
        }
        Err(GeomError::Fit(FitError::Undetermined { control_points }))
    }

    /// For conditions in the order of their parameters between both ends, over the given knots.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn weighted(
        conditions: &[FitCondition],
        knots: KnotVector,
    ) -> Result<Self, GeomError> {
        let width = knots.degree() + 1;
        let mut firsts = Vec::with_capacity(conditions.len());
        let mut shares = Vec::with_capacity(conditions.len() * width);
        for &FitCondition { t, order, weight } in conditions {
            if order == 0 {
                knots.with_basis(t, |span, basis| {
                    firsts.push(span + 1 - width);
                    shares.extend(basis.iter().map(|share| weight * share));
                });
            } else {
                let span = knots.span_at(t);
                let derivatives = knots.basis_derivatives_on(span, t, order);
                firsts.push(span + 1 - width);
                shares.extend(derivatives.row(order).iter().map(|share| weight * share));
            }
        }
        Self::of_rows(knots, firsts, shares)
    }

    fn of_rows(knots: KnotVector, firsts: Vec<usize>, shares: Vec<f64>) -> Result<Self, GeomError> {
        let width = knots.degree() + 1;
        let n_inner = knots.n_points().saturating_sub(2);
        let rows = firsts.iter().copied().zip(shares.chunks_exact(width));
        let control_points = knots.n_points();
        let factor =
            TriangularFactor::new(rows.map(|row| without_ends(row, n_inner)), n_inner, width)
                .ok_or(GeomError::Fit(FitError::Undetermined { control_points }))?;
        Ok(Self { knots, firsts, shares, factor })
    }

    /// The first control point that counts at each parameter, and how much it and those behind it
    /// do.
    fn rows(&self) -> impl Iterator<Item = (usize, &[f64])> {
        self.firsts.iter().copied().zip(self.shares.chunks_exact(self.knots.degree() + 1))
    }

    /// The spline of control points at each of the parameters.
    pub(crate) fn values<'a>(&'a self, points: &'a [DVec4]) -> impl Iterator<Item = DVec4> + 'a {
        self.rows().map(|(first, shares)| value(&points[first..], shares))
    }

    /// The knots of the splines.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// The control points of the spline nearest to the values.
    ///
    /// Seminormal equations with one step of refinement, as accurate as a QR factorization:
    /// Björck, *Numerical Methods for Least Squares Problems*, §2.9.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one value a parameter.
    pub fn near(&self, values: &[DVec4]) -> Result<Vec<DVec4>, GeomError> {
        self.check_count(values.len())?;
        Ok(self.nearest([values[0], values[values.len() - 1]], |i| values[i]))
    }

    /// The control points from end to end of the spline that comes nearest to what the conditions
    /// want, each times its weight.
    pub(crate) fn between(&self, ends: [DVec4; 2], wanted: &[DVec4]) -> Vec<DVec4> {
        self.nearest(ends, |i| wanted[i])
    }

    /// [`Self::between`], the wanted ones by their number.
    fn nearest(&self, ends: [DVec4; 2], wanted: impl Fn(usize) -> DVec4) -> Vec<DVec4> {
        let mut points = vec![DVec4::ZERO; self.knots.n_points()];
        let last = points.len() - 1;
        (points[0], points[last]) = (ends[0], ends[1]);
        for is_first in [true, false] {
            let correction = self.correction(&points, is_first, &wanted);
            for (point, step) in points[1..last].iter_mut().zip(correction) {
                *point += step;
            }
        }
        points
    }

    /// What is missing from inner control points, all of which are zero `at_first`.
    fn correction(
        &self,
        points: &[DVec4],
        at_first: bool,
        wanted: impl Fn(usize) -> DVec4,
    ) -> Vec<DVec4> {
        let n_points = points.len();
        let mut sums = vec![DVec4::ZERO; n_points];
        for (i, (first, shares)) in self.rows().enumerate() {
            let is_inside = 0 < first && first + shares.len() < n_points;
            let points = if at_first && is_inside { &[] } else { &points[first..] };
            let sums = &mut sums[first..];
            match (shares.first_chunk::<CUBIC>(), sums.first_chunk_mut::<CUBIC>()) {
                (Some(shares), Some(sums)) if self.knots.degree() + 1 == CUBIC => {
                    let known = points.first_chunk::<CUBIC>();
                    let known = known.map_or(DVec4::ZERO, |points| value(points, shares));
                    share_out(wanted(i) - known, shares, sums);
                }
                _ => share_out(wanted(i) - value(points, shares), shares, sums),
            }
        }
        let mut inner = sums[1..n_points - 1].to_vec();
        self.factor.solve_normal(&mut inner);
        inner
    }

    /// The polynomial curve nearest to points.
    ///
    /// # Errors
    /// Those of [`Self::near`].
    pub fn curve(&self, points: &[DVec3]) -> Result<NurbsCurve, GeomError> {
        let mut found = self.near_points(points)?;
        found.iter_mut().for_each(|point| point.w = 1.0);
        NurbsCurve::new(self.knots.clone(), found)
    }

    /// The control points of [`Self::curve`], their weights one but for rounding.
    pub(super) fn near_points(&self, points: &[DVec3]) -> Result<Vec<DVec4>, GeomError> {
        self.check_count(points.len())?;
        let ends = [points[0], points[points.len() - 1]].map(|end| end.extend(1.0));
        Ok(self.nearest(ends, |i| points[i].extend(1.0)))
    }

    fn check_count(&self, got: usize) -> Result<(), GeomError> {
        let needed = self.firsts.len();
        if got == needed {
            Ok(())
        } else {
            Err(CountError::WrongCount { what: "points", needed, got }.into())
        }
    }
}

/// Control points in shares.
#[inline(always)]
fn value(points: &[DVec4], shares: &[f64]) -> DVec4 {
    points.iter().zip(shares).fold(DVec4::ZERO, |sum, (&point, &share)| sum + share * point)
}

/// Adds to each sum its share.
#[inline(always)]
fn share_out(whole: DVec4, shares: &[f64], sums: &mut [DVec4]) {
    for (sum, &share) in sums.iter_mut().zip(shares) {
        *sum += share * whole;
    }
}
