//! Why there is no such region.

use glam::DVec3;
use thiserror::Error;

use crate::error::{few_digits, place};

/// What keeps regions from being put together.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, GeomError, NurbsCurve, Region, RegionError, Tolerance, glam::DVec3};
///
/// let disc = |height: f64| {
///     let circle = NurbsCurve::ellipse(Frame::XY.at(DVec3::Z * height), [1.0; 2], CircleForm::NinePoint)?;
///     Region::new(&circle, &[], Tolerance::DEFAULT)
/// };
/// let found = Region::union(&[disc(0.0)?, disc(2.0)?], Tolerance::DEFAULT, 1);
/// assert!(matches!(found, Err(GeomError::Region(RegionError::OtherPlane { index: 1, .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum RegionError {
    /// Regions that do not lie in one plane.
    #[error("region [{index}] lies in another plane than region [0]: it is up to {} away from that", few_digits(*by))]
    OtherPlane { index: usize, by: f64 },
    /// Borders whose course is not certain.
    #[error("the borders near {} come too close to one another to be told apart", place(*point))]
    Unclear { point: DVec3 },
    /// A border that would be lost.
    #[error("a border near {} is one place within the tolerance {}", place(*point), few_digits(*tolerance))]
    TooSmall { point: DVec3, tolerance: f64 },
    /// A part that is next to nothing.
    #[error(
        "a part of the result near {} is {} wide, less than the tolerance {}",
        place(*point),
        few_digits(*width),
        few_digits(*tolerance)
    )]
    Thin { point: DVec3, width: f64, tolerance: f64 },
    /// A corner in which a circle does not fit.
    #[error(
        "a circle of radius {} does not fit at the corner {}{}",
        few_digits(*radius),
        place(*point),
        most.map_or(String::new(), |most| format!(": one up to {} does", few_digits(most)))
    )]
    NoRoom { point: DVec3, radius: f64, most: Option<f64> },
    /// A place without a corner.
    #[error("there is no corner at {}: the nearest is {} away", place(*point), few_digits(*distance))]
    NoCorner { point: DVec3, distance: f64 },
}
