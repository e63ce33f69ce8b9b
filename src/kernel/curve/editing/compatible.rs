//! Several curves on one degree and one knot vector.

use crate::{GeomError, compatible::on_common_knots, curve::NurbsCurve};

/// The same curves on the highest degree among them, the domain of the first, and one knot vector
/// with every knot of any of them as often as it stands in one.
///
/// Knots of different curves closer than [`KNOT_CLUSTER_RELATIVE`] of the domain become one, which
/// moves a curve by a like fraction of its size. Curves that agree already come back as they are;
/// others are clamped. Piegl & Tiller, *The NURBS Book*, §10.3.
///
/// # Errors
/// `KnotError::KnotMultiplicity` where knots fall together for lack of digits on that domain.
///
/// [`KNOT_CLUSTER_RELATIVE`]: crate::tolerance::KNOT_CLUSTER_RELATIVE
pub fn make_compatible(curves: &[NurbsCurve]) -> Result<Vec<NurbsCurve>, GeomError> {
    let lines = on_common_knots(curves.iter().map(NurbsCurve::lines).collect())?;
    Ok(lines.into_iter().map(NurbsCurve::from_lines).collect())
}
