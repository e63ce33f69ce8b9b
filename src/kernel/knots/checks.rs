//! Numbers of control points for which there are knots.

use crate::{CountError, DegreeError, GeomError, ceiling::CONTROL_POINTS, knots::check_degree};

/// # Errors
/// [`DegreeError::DegreeTooHigh`], [`DegreeError::BadDegree`] with no more points than the degree,
/// [`CountError::TooManyPoints`].
pub(crate) fn check_points(degree: usize, n_points: usize) -> Result<(), GeomError> {
    check_degree(degree)?;
    if n_points <= degree {
        return Err(DegreeError::BadDegree { degree, points: n_points, needed: degree + 1 }.into());
    }
    let most = CONTROL_POINTS;
    if most < n_points {
        return Err(CountError::TooManyPoints { got: n_points, most }.into());
    }
    Ok(())
}
