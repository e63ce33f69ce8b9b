//! The equations of closed splines through points.

use glam::DVec4;

use super::{
    check_parameters,
    equation::Equation,
    interpolate::{FactoredEquations, Interpolator, check_degree},
};
use crate::{
    CountError, FitError, GeomError, Interval, KnotVector, NurbsCurve,
    numeric::cyclic::CyclicSystem,
};

impl Interpolator {
    /// For values at all but the last of the parameters, where it comes back to the first value:
    /// periodic, as smooth at the seam as anywhere.
    ///
    /// Knots stand at the parameters for odd degrees, halfway between for even ones. Too few
    /// values lower the degree to their number.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below three values; those of [`check_parameters`];
    /// [`CountError::CountTooSmall`] for degree 0, `DegreeError::DegreeTooHigh`.
    pub fn periodic(parameters: &[f64], degree: usize) -> Result<Self, GeomError> {
        let got = parameters.len().saturating_sub(1);
        if got < 3 {
            return Err(CountError::TooFewPoints { got, needed: 3 }.into());
        }
        check_degree(degree)?;
        check_parameters(parameters, got + 1)?;
        let degree = degree.min(got);
        let is_even = degree.is_multiple_of(2);
        let period = parameters[got] - parameters[0];
        // The i-th parameter of a ring that goes on and on; the degree is not above their number.
        let at = |i: usize| match i / got {
            2 => parameters[i % got],
            3 if i.is_multiple_of(got) => parameters[got],
            turn => parameters[i % got] + period * (turn as f64 - 2.0),
        };
        let knot = |i: usize| {
            let i = i + 2 * got - degree;
            if is_even { 0.5 * (at(i - 1) + at(i)) } else { at(i) }
        };
        // Halfway knots begin before the seam, and have one more span to end behind it.
        let n_points = got + degree + usize::from(is_even);
        let ring = KnotVector::new(degree, (0..=n_points + degree).map(knot).collect())?;

        // Unknown i is the middle one of those that act at parameter i.
        let reach = degree / 2;
        let centred =
            |equation: Equation| Equation { first: got + equation.first - reach, ..equation };
        let rows: Vec<Equation> =
            Equation::points(&ring, &parameters[..got]).map(centred).collect();
        let cyclic = CyclicSystem::new(&rows, reach).ok_or(FitError::NoFit)?;
        if !is_even {
            return Ok(Self {
                knots: ring,
                n_values: got,
                equations: FactoredEquations::Ring(cyclic, None),
            });
        }
        let anything = vec![DVec4::W; ring.n_points()];
        let knots = cut_to(parameters, &ring, anything)?.knots().clone();
        Ok(Self { knots, n_values: got, equations: FactoredEquations::Ring(cyclic, Some(ring)) })
    }
}

/// The spline over the parameters only.
pub(super) fn cut_to(
    parameters: &[f64],
    knots: &KnotVector,
    points: Vec<DVec4>,
) -> Result<NurbsCurve, GeomError> {
    let domain = Interval::new(parameters[0], parameters[parameters.len() - 1])?;
    NurbsCurve::new_unchecked(knots.clone(), points).trimmed(domain)
}
