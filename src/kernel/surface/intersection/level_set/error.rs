//! Why lines on surfaces, and regions within lines, are refused.

use glam::DVec3;
use thiserror::Error;

use crate::error::{few_digits, place};

/// Why there is no picture.
///
/// ```
/// use virote_kernel::{GeomError, NurbsSurface, PictureError, Surface, Tolerance, glam::DVec3};
///
/// let square = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y)?;
/// let [one, same] = [Surface::from(square.clone()), Surface::from(square)];
/// let found = one.intersections(&same, Tolerance::DEFAULT);
/// assert!(matches!(found, Err(GeomError::Picture(PictureError::SurfacesRunTogether { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum PictureError {
    /// A line on a surface that rounding decides where it runs.
    #[error(
        "the line does not resolve near ({u}, {v}): the surface runs along it there up to rounding"
    )]
    Unresolved { u: f64, v: f64 },
    /// Surfaces that share more than curves in which they cross.
    #[error("the surfaces run together near {}: they share more than curves there", place(*point))]
    SurfacesRunTogether { point: DVec3 },
    /// Surfaces whose curves are too many or too close.
    #[error("the surfaces cross too often, or run too close to one another, near {}", place(*point))]
    TooTangled { point: DVec3 },
    /// A curve that was found and is not on a surface.
    #[error(
        "no curve can be told for certain near {}: what was found is {} off a surface",
        place(*point),
        few_digits(*distance)
    )]
    OffSurface { point: DVec3, distance: f64 },
    /// Two curves that are one for a stretch.
    #[error("no curve can be told for certain near {}: two that were found are one there", place(*point))]
    ToldTwice { point: DVec3 },
    /// A curve of which a part is missing.
    #[error(
        "no curve can be told for certain near {}: what was found ends there, inside the surfaces",
        place(*point)
    )]
    EndsInside { point: DVec3 },
    /// An edge of a surface on the other one, along which nothing was found.
    #[error(
        "no curve can be told for certain near {}: an edge of one surface lies on the other there, and was not found",
        place(*point)
    )]
    EdgeLost { point: DVec3 },
    /// A closed curve so small that it could not be followed.
    #[error(
        "no curve can be told for certain near {}: the surfaces cross there in a small loop, which could not be followed",
        place(*point)
    )]
    SmallLoop { point: DVec3 },
    /// A curve that shares a stretch with a surface.
    #[error("the curve runs along the surface from parameter {} to {}", few_digits(*start), few_digits(*end))]
    RunsAlong { start: f64, end: f64 },
    /// A border that does not close.
    #[error("{} is not closed: its ends are {} apart", curve(*index, *of), few_digits(*gap))]
    Open { index: usize, of: usize, gap: f64 },
    /// A border that is not in the plane.
    #[error("{} leaves the plane by {}", curve(*index, *of), few_digits(*by))]
    OffPlane { index: usize, of: usize, by: f64 },
    /// A border around nothing.
    #[error("{} encloses no area", curve(*index, *of))]
    NoArea { index: usize, of: usize },
    /// Borders that cross or touch.
    #[error(
        "{} {} at {}",
        curve(*index, *of),
        if index == other { "crosses or touches itself".to_owned() } else { format!("meets `curves[{other}]`") },
        place(*point)
    )]
    Crossing { index: usize, other: usize, of: usize, point: DVec3 },
    /// A hole elsewhere.
    #[error("`curves[{index}]` is no hole: it does not lie within `curves[0]`")]
    Outside { index: usize },
    /// A hole in a hole.
    #[error("`curves[{index}]` lies within `curves[{other}]`, which is a hole already")]
    HoleInHole { index: usize, other: usize },
}

/// What a curve is called: alone, or in a list.
fn curve(index: usize, of: usize) -> String {
    if of < 2 { "the curve".to_owned() } else { format!("`curves[{index}]`") }
}
