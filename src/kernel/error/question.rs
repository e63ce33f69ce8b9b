//! Why a question about geometry has no answer.

use glam::DVec3;
use thiserror::Error;

use super::super::digits::{few_digits, plain};

/// A shape at a place that has none.
///
/// ```
/// use virote_kernel::{Curve, GeomError, LocalError, NurbsCurve, Side, glam::DVec3};
///
/// let line = Curve::from(NurbsCurve::line(DVec3::ZERO, DVec3::X)?);
/// let normal = line.local_at(0.5, Side::Right)?.normal();
/// assert!(matches!(normal, Err(GeomError::Local(LocalError::Straight { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum LocalError {
    /// Parameters of a surface that are not of the face.
    #[error("the face does not reach to u = {u}, v = {v}", u = plain(*u), v = plain(*v))]
    OffFace { u: f64, v: f64 },
    /// Every derivative vanishes, so that there is no direction.
    #[error("there is no tangent at parameter {parameter}: every derivative vanishes", parameter = plain(*parameter))]
    VanishingTangent { parameter: f64 },
    /// The curve stands still, and bends without bound on the way there.
    #[error(
        "the derivative vanishes at parameter {parameter}, where the curvature grows without bound: there is no {what}", parameter = plain(*parameter))]
    UnboundedCurvature { what: &'static str, parameter: f64 },
    /// The curve does not bend.
    #[error("the curve is straight at parameter {parameter}: there is no {what}", parameter = plain(*parameter))]
    Straight { what: &'static str, parameter: f64 },
    /// A bend seen from its own plane.
    #[error("at parameter {parameter} the curve bends in a plane that holds the normal ({}, {}, {}): there is no left and right", normal.x, normal.y, normal.z, parameter = plain(*parameter))]
    NoSide { parameter: f64, normal: DVec3 },
    /// The surface has no tangent plane.
    #[error("there is no normal at ({u}, {v}): the tangent plane has no limit there", u = plain(*u), v = plain(*v))]
    NoNormal { u: f64, v: f64 },
    /// The surface has no curvature.
    #[error(
        "there is no curvature at ({u}, {v}): Su × Sv vanishes there, and the curvatures around have no common limit", u = plain(*u), v = plain(*v))]
    NoCurvature { u: f64, v: f64 },
    /// A partial derivative vanishes and has no direction either.
    #[error(
        "there is no tangent along {what} at ({u}, {v}): the derivative vanishes and has no direction", u = plain(*u), v = plain(*v))]
    NoTangentAlong { what: &'static str, u: f64, v: f64 },
    /// A direction along the normal where one of the tangent plane is wanted.
    #[error(
        "the direction runs along the normal of the surface, so that it has no part in the tangent plane"
    )]
    AcrossSurface,
    /// A coordinate of a curve, or of a derivative of it, overflows.
    #[error(
        "at parameter {parameter} the {} is beyond the largest number, 1.8e308",
        if *order == 0 { "point" } else { "derivative" }, parameter = plain(*parameter))]
    BeyondNumbers { order: usize, parameter: f64 },
    /// A coordinate of a surface, or of a derivative of it, overflows.
    #[error("at ({u}, {v}) a point or derivative is beyond the largest number, 1.8e308", u = plain(*u), v = plain(*v))]
    BeyondNumbersAt { u: f64, v: f64 },
    /// A place where a function has no derivative.
    #[error("{what} has no derivative at {at}", at = plain(*at))]
    NotDifferentiable { what: &'static str, at: f64 },
    /// A derivative overflows.
    #[error("a derivative is beyond the largest number, 1.8e308")]
    DerivativeBeyondNumbers,
}

/// Meetings that are no single points.
///
/// ```
/// use virote_kernel::{GeomError, IntersectionError, NurbsCurve, glam::DVec3};
///
/// // They share the stretch from 1 to 2.
/// let line = |from, to| NurbsCurve::line(DVec3::X * from, DVec3::X * to);
/// let found = line(0.0, 2.0)?.intersections(&line(1.0, 3.0)?, 1e-6);
/// let Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) = found else {
///     unreachable!("they run together");
/// };
/// assert!((start - 0.5).abs() < 1e-5 && (end - 1.0).abs() < 1e-5);
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum IntersectionError {
    /// Two curves that share a stretch and not single points.
    #[error(
        "the curves run together from parameter {} to {} of the first",
        few_digits(*start), few_digits(*end)
    )]
    RunTogether { start: f64, end: f64 },
    /// A curve that comes back to a stretch of itself and not to single points.
    #[error("the curve runs along itself from parameter {} to {}", few_digits(*start), few_digits(*end))]
    RunsAlongItself { start: f64, end: f64 },
    /// Curves that are near one another nearly everywhere.
    #[error("the places where the curves come near one another are too many to be told apart")]
    Tangled,
}

/// What has no size that could be told.
///
/// ```
/// use virote_kernel::{GeomError, MeasureError, area_mass};
///
/// assert!(matches!(area_mass(&[]), Err(GeomError::Measure(MeasureError::NothingThere { .. }))));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum MeasureError {
    /// An area or volume of zero.
    #[error("there is no {what} that could have a centre")]
    NothingThere { what: &'static str },
    /// An area or volume, or its moments, that overflow.
    #[error("the {what} or its moments are beyond the largest number, 1.8e308")]
    TooLargeToMeasure { what: &'static str },
    /// An area or volume that underflows.
    #[error("the {what} is below the smallest number, 2.2e-308")]
    TooSmallToMeasure { what: &'static str },
}
