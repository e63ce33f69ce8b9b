//! The equations of splines through points: which knots, which conditions.

use super::{
    check_parameters,
    equation::{Equation, band_of_points},
};
use crate::{
    CountError, FitError, GeomError, KnotVector,
    numeric::{banded::BandedSystem, cyclic::CyclicSystem},
};

/// What a cubic with its knots at the points does where it begins and ends.
///
/// A natural spline does not bend where it begins; one without a knot at the second point takes the
/// cubic that all points lie on:
///
/// ```
/// use virote_kernel::{Ends, Interpolator, glam::DVec3};
///
/// let parameters = [0.0, 1.0, 2.0, 3.0, 4.0];
/// let points = parameters.map(|t: f64| DVec3::new(t, t * t * t, 0.0));
/// let spline = |ends| Interpolator::new(&parameters, 3, ends)?.curve(&points);
/// assert!(spline(Ends::Natural)?.derivatives_at(0.0, 2)[2].length() < 1e-12);
/// assert!((spline(Ends::NotAKnot)?.point_at(2.5).y - 15.625).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The tangent of the parabola through the first three points, and the last three.
    Bessel,
    /// No bending: the second derivative vanishes.
    Natural,
    /// The first and the last segment are parabolas.
    Quadratic,
    /// The derivatives there are given.
    Clamped,
    /// The first two segments are one cubic, and the last two: no knot at the second point.
    NotAKnot,
    /// No such condition: the knots are averages of the parameters, as many as the degree needs.
    Averaged,
}

/// A basis, with the factored equations of a spline over it that takes given values at given
/// parameters: curves and the rows and columns of surfaces share it.
///
/// The cubic of *The NURBS Book*, Ex9.1, whose one inner knot is 28/51:
///
/// ```
/// use virote_kernel::{Ends, Interpolator, Parametrization, glam::DVec3};
///
/// let points = [(0.0, 0.0), (3.0, 4.0), (-1.0, 4.0), (-4.0, 0.0), (-4.0, -3.0)];
/// let points = points.map(|(x, y)| DVec3::new(x, y, 0.0));
/// let parameters = Parametrization::Chord.parameters(&points)?;
/// let fit = Interpolator::new(&parameters, 3, Ends::Averaged)?;
/// assert!((fit.knots().as_slice()[4] - 28.0 / 51.0).abs() < 1e-15);
/// let curve = fit.curve(&points)?;
/// assert!(curve.point_at(parameters[2]).distance(points[2]) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Interpolator {
    pub(super) knots: KnotVector,
    pub(super) n_values: usize,
    pub(super) equations: FactoredEquations,
}

#[derive(Clone, Debug)]
pub(super) enum FactoredEquations {
    /// One an unknown, and nothing else.
    Values(BandedSystem),
    /// One more at each end: what stands on their right-hand side.
    WithEnds(BandedSystem, [EndRow; 2]),
    /// A derivative after each value.
    WithDerivatives(BandedSystem),
    /// A derivative after the first value, before the last, or both.
    WithEndSlopes(BandedSystem, [bool; 2]),
    /// A ring; over its own knots, where the basis does not begin and end at the seam.
    Ring(CyclicSystem, Option<KnotVector>),
}

/// The right-hand side of an end condition.
#[derive(Clone, Copy, Debug)]
pub(super) enum EndRow {
    /// The control point next to the end, as a combination of the three values from the end.
    Values([f64; 3]),
    /// Zero, for a derivative of this order.
    Vanishing(usize),
    /// The control point next to the end, this far along the given derivative.
    Along(f64),
}

impl Interpolator {
    /// For values at the parameters; where these and the ends do not determine a spline of the
    /// degree, of a lower one.
    ///
    /// Of degree 3 the knots stand at the parameters and the ends need their condition: Farin,
    /// *Curves and Surfaces for CAGD*, §9.1 to §9.3. Of any other degree, and with
    /// [`Ends::Averaged`], knots are averages of parameters: Piegl & Tiller, *The NURBS Book*,
    /// (9.8). Farin's last Bessel condition counts from the end.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two; those of [`check_parameters`];
    /// `DegreeError::DegreeTooHigh`; [`CountError::CountTooSmall`] for degree 0.
    pub fn new(parameters: &[f64], degree: usize, ends: Ends) -> Result<Self, GeomError> {
        let got = parameters.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        check_degree(degree)?;
        check_parameters(parameters, got)?;
        match (degree, ends) {
            (3, Ends::Natural | Ends::Clamped) => Self::cubic(parameters, ends),
            (3, Ends::Bessel | Ends::Quadratic) if 2 < got => Self::cubic(parameters, ends),
            (3, Ends::NotAKnot) if 3 < got => Self::not_a_knot(parameters),
            _ => Self::averaged(parameters, degree.min(got - 1)),
        }
    }

    /// For values and first derivatives at the parameters, of degree 2 or 3.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (9.22) and (9.23).
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two; those of [`check_parameters`];
    /// [`FitError::NoFit`] of another degree.
    pub fn with_derivatives(parameters: &[f64], degree: usize) -> Result<Self, GeomError> {
        let got = parameters.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        check_parameters(parameters, got)?;
        let spans = parameters.windows(2);
        let inner: Vec<f64> = match degree {
            2 => {
                let halves = spans.flat_map(|span| [0.5 * (span[0] + span[1]), span[1]]);
                halves.take(2 * got - 3).collect()
            }
            3 if got == 2 => Vec::new(),
            3 => {
                let part = |(i, span): (usize, &[f64])| match i {
                    0 => vec![0.5 * (span[0] + span[1])],
                    i if i + 2 == got => vec![0.5 * (span[0] + span[1])],
                    _ => vec![(2.0 * span[0] + span[1]) / 3.0, (span[0] + 2.0 * span[1]) / 3.0],
                };
                spans.enumerate().flat_map(part).collect()
            }
            _ => return Err(FitError::NoFit.into()),
        };
        let knots = clamped(parameters, degree, inner)?;
        let both = |&t: &f64| [Equation::point(&knots, t), Equation::derivative(&knots, t, 1)];
        let mut rows: Vec<Equation> = parameters.iter().flat_map(both).collect();
        // The last value belongs to the last unknown, as the first to the first.
        let last = rows.len() - 1;
        rows.swap(last - 1, last);
        let equations =
            FactoredEquations::WithDerivatives(BandedSystem::new(&rows).ok_or(FitError::NoFit)?);
        Ok(Self { knots, n_values: got, equations })
    }

    /// The knots of the splines.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    fn averaged(parameters: &[f64], degree: usize) -> Result<Self, GeomError> {
        let n_inner = parameters.len() - degree - 1;
        let mean = |j: usize| parameters[j..j + degree].iter().sum::<f64>() / degree as f64;
        Self::on_knots(parameters, clamped(parameters, degree, (1..=n_inner).map(mean))?)
    }

    fn not_a_knot(parameters: &[f64]) -> Result<Self, GeomError> {
        let inner = &parameters[2..parameters.len() - 2];
        Self::on_knots(parameters, clamped(parameters, 3, inner.iter().copied())?)
    }

    /// For as many values as the knots need, at parameters of which one lies in the support of each
    /// basis function, such as those of Greville.
    ///
    /// # Errors
    /// [`FitError::NoFit`] where the values do not determine a spline.
    pub(crate) fn on_knots(parameters: &[f64], knots: KnotVector) -> Result<Self, GeomError> {
        let band = band_of_points(&knots, parameters).ok_or(FitError::NoFit)?;
        let equations = FactoredEquations::Values(band);
        Ok(Self { knots, n_values: parameters.len(), equations })
    }

    /// Knots at the parameters: two control points more than values.
    fn cubic(parameters: &[f64], ends: Ends) -> Result<Self, GeomError> {
        let n = parameters.len();
        let knots = clamped(parameters, 3, parameters[1..n - 1].iter().copied())?;
        let backwards: Vec<f64> = parameters.iter().rev().take(3).map(|t| -t).collect();
        let sides = [(parameters, 1), (&backwards[..], n)];
        let mut end_rows = sides.map(|(t, column)| match ends {
            Ends::Clamped => (Equation::control_point(column), EndRow::Along((t[1] - t[0]) / 3.0)),
            Ends::Natural => (end_derivative(&knots, column, 2), EndRow::Vanishing(2)),
            Ends::Quadratic => (end_derivative(&knots, column, 3), EndRow::Vanishing(3)),
            _ => (Equation::control_point(column), EndRow::Values(bessel(t))),
        });
        // Forwards at the start is backwards at the end.
        if let EndRow::Along(third) = &mut end_rows[1].1 {
            *third = -*third;
        }
        let [(start, start_row), (end, end_row)] = end_rows;
        let mut rows = vec![Equation::control_point(0), start];
        rows.extend(Equation::points(&knots, &parameters[1..n - 1]));
        rows.extend([end, Equation::control_point(n + 1)]);
        let equations = FactoredEquations::WithEnds(
            BandedSystem::new(&rows).ok_or(FitError::NoFit)?,
            [start_row, end_row],
        );
        Ok(Self { knots, n_values: n, equations })
    }
}

/// The condition that a derivative vanishes at the end beside which control point `column` lies.
pub(super) fn end_derivative(knots: &KnotVector, column: usize, order: usize) -> Equation {
    let domain = knots.domain();
    let end = if column == 1 { domain.start() } else { domain.end() };
    Equation::derivative(knots, end, order).scaled()
}

/// The control point next to the end, for the tangent of the parabola through three values.
///
/// Farin, *Curves and Surfaces for CAGD*, §9.3.
fn bessel(parameters: &[f64]) -> [f64; 3] {
    let d = (parameters[2] - parameters[1]) / (parameters[2] - parameters[0]);
    let e = (parameters[1] - parameters[0]) / (parameters[2] - parameters[0]);
    [(1.0 + d) / 3.0, 1.0 / (3.0 * d), -e * e / (3.0 * d)]
}

/// Knots from the first to the last parameter, which stand p + 1 times.
pub(super) fn clamped(
    parameters: &[f64],
    degree: usize,
    inner: impl IntoIterator<Item = f64>,
) -> Result<KnotVector, GeomError> {
    let ends = [parameters[0], parameters[parameters.len() - 1]];
    let mut knots = Vec::with_capacity(parameters.len() + degree + 1);
    knots.extend(std::iter::repeat_n(ends[0], degree + 1));
    knots.extend(inner);
    knots.extend(std::iter::repeat_n(ends[1], degree + 1));
    KnotVector::new(degree, knots)
}

/// # Errors
/// [`CountError::CountTooSmall`] for degree 0.
pub(super) fn check_degree(degree: usize) -> Result<(), GeomError> {
    let (what, needed) = ("the degree", 1);
    if needed <= degree {
        Ok(())
    } else {
        Err(GeomError::Count(CountError::CountTooSmall { what, got: degree, needed }))
    }
}
