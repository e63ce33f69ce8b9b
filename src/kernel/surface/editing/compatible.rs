//! Several surfaces on one pair of degrees and one pair of knot vectors.

use crate::{
    GeomError,
    compatible::on_common_knots,
    surface::{Direction, NurbsSurface},
};

/// The same surfaces on the highest degrees among them, the domains of the first, and, along both
/// directions, one knot vector with every knot of any of them as often as it stands in one.
///
/// Knots of different surfaces closer than [`KNOT_CLUSTER_RELATIVE`] of the domain become one,
/// which moves a surface by a like fraction of its size. Along a direction in which the surfaces
/// agree already they stay as they are; else they are clamped there.
///
/// # Errors
/// `KnotError::KnotMultiplicity` where knots fall together for lack of digits on that domain.
///
/// [`KNOT_CLUSTER_RELATIVE`]: crate::tolerance::KNOT_CLUSTER_RELATIVE
pub fn make_surfaces_compatible(surfaces: &[NurbsSurface]) -> Result<Vec<NurbsSurface>, GeomError> {
    let mut common = surfaces.to_vec();
    for along in Direction::BOTH {
        let lines = on_common_knots(common.iter().map(|surface| surface.lines(along)).collect())?;
        let both = common.iter().zip(lines);
        common = both.map(|(surface, lines)| surface.with_lines(along, lines)).collect();
    }
    Ok(common)
}
