//! The one polynomial through points.

use glam::{DVec3, DVec4};

use super::{check_parameters, equation::Equation};
use crate::{
    CountError, FitError, GeomError, KnotVector, NurbsCurve, numeric::banded::BandedSystem,
};

/// The polynomial curve through the points at the parameters, as a Bézier curve over them; its
/// degree is one less than the number of points.
///
/// O(n³). Farin, *Curves and Surfaces for CAGD*, §6.2 and §6.3.
///
/// Through four points of y = t³ it is that cubic:
///
/// ```
/// use virote_kernel::{glam::DVec3, lagrange};
///
/// let at = [0.0, 1.0, 2.0, 3.0];
/// let curve = lagrange(&at.map(|t: f64| DVec3::new(t, t * t * t, 0.0)), &at)?;
/// assert!((curve.point_at(1.5).y - 3.375).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// [`CountError::TooFewPoints`] below two; `DegreeError::DegreeTooHigh`; those of
/// [`check_parameters`]; `InputError::NotFinite`.
pub fn lagrange(points: &[DVec3], parameters: &[f64]) -> Result<NurbsCurve, GeomError> {
    let got = points.len();
    if got < 2 {
        return Err(CountError::TooFewPoints { got, needed: 2 }.into());
    }
    check_parameters(parameters, got)?;
    let [start, end] = [parameters[0], parameters[got - 1]].map(|t| vec![t; got]);
    let knots = KnotVector::new(got - 1, [start, end].concat())?;
    let rows: Vec<Equation> = Equation::points(&knots, parameters).collect();
    let mut unknowns: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
    BandedSystem::new(&rows).ok_or(FitError::NoFit)?.solve(&mut unknowns);
    let control_points: Vec<DVec3> = unknowns.into_iter().map(DVec4::truncate).collect();
    NurbsCurve::polynomial(knots, &control_points)
}
