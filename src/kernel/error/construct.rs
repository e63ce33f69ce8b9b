//! Why a construction or conversion has no result.

use glam::DVec3;
use thiserror::Error;

use super::super::{
    ceiling::{PIECES, STAND_IN_CELLS},
    digits::{few_digits, how_far, place, plain},
};

/// Nothing that goes through data or stays within a tolerance.
///
/// ```
/// use virote_kernel::{Approximator, FitError, GeomError, KnotVector};
///
/// // Two values and four control points: the two in between could lie anywhere.
/// let found = Approximator::new(&[0.0, 1.0], KnotVector::bezier(3)?);
/// assert!(matches!(found, Err(GeomError::Fit(FitError::Undetermined { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum FitError {
    /// A knot that the curve cannot do without.
    #[error(
        "without the knot {knot} the curve would move {}, more than the tolerance {}",
        how_far(*error), plain(*tolerance), knot = plain(*knot))]
    KnotNeeded { knot: f64, error: f64, tolerance: f64 },
    /// A degree that the curve cannot do without.
    #[error(
        "degree {degree} would move the curve {}, more than the tolerance {}",
        how_far(*error), plain(*tolerance)
    )]
    NotReducible { degree: usize, error: f64, tolerance: f64 },
    /// An offset that no spline surface of a reasonable size comes near.
    #[error(
        "no spline surface of {most} patches is within {} of the offset near ({u}, {v})",
        few_digits(*tolerance), u = plain(*u), v = plain(*v))]
    NoSurfaceNear { most: usize, tolerance: f64, u: f64, v: f64 },
    /// A parameter of data that is not above its predecessor.
    #[error(
        "parameter {index} is {parameter}, not above the {previous} before it; parameters increase", previous = plain(*previous), parameter = plain(*parameter))]
    ParametersNotIncreasing { index: usize, previous: f64, parameter: f64 },
    /// Conditions on a spline that contradict or repeat one another.
    #[error("the conditions do not determine a curve")]
    NoFit,
    /// Too few data for so many control points.
    #[error("the points leave some of the {control_points} control points open")]
    Undetermined { control_points: usize },
    /// A tolerance below what rounding leaves.
    #[error(
        "the tolerance {} cannot be kept: even a curve through all points misses one by {}",
        plain(*tolerance), few_digits(*found)
    )]
    ToleranceNotKept { tolerance: f64, found: f64 },
    /// A function that no spline of a reasonable size comes near.
    #[error("no spline of {} pieces is within {} of the function at {parameter}", PIECES, few_digits(*tolerance), parameter = plain(*parameter))]
    NoSplineNear { tolerance: f64, parameter: f64 },
    /// A function of two parameters that no spline of a reasonable size comes near.
    #[error("no spline of {} patches is within {} of the function at ({u}, {v})", STAND_IN_CELLS, few_digits(*tolerance), u = plain(*u), v = plain(*v))]
    NoSplineNearAt { tolerance: f64, u: f64, v: f64 },
}

/// What another form cannot hold exactly.
///
/// ```
/// use virote_kernel::{FormError, GeomError, NurbsCurve, glam::DVec3};
///
/// let line = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// assert!(matches!(line.conic_kind(), Err(GeomError::Form(FormError::NoConic { .. }))));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum FormError {
    /// A piece of a line where a conic is wanted.
    #[error("the curve is straight from parameter {parameter}, which is no conic", parameter = plain(*parameter))]
    NoConic { parameter: f64 },
    /// Pieces of different conics.
    #[error("the curve changes its kind at parameter {parameter}: its pieces are different conics", parameter = plain(*parameter))]
    MixedConics { parameter: f64 },
    /// A curve that should lie in one plane.
    #[error("the curve is not planar: it leaves its plane by {}", few_digits(*by))]
    NotPlanar { by: f64 },
    /// Weights in a form that has none.
    #[error("{what} has no weights, but those of the curve differ")]
    RationalFor { what: &'static str },
    /// A degree above that of the form.
    #[error("{what} has degree {most}, but the curve has degree {degree}")]
    DegreeTooHighFor { what: &'static str, degree: usize, most: usize },
    /// Segments that do not take the same part of the parameter.
    #[error(
        "the segments of {what} are equally long in parameter, but the curve has some of {width} and of {other}", width = plain(*width), other = plain(*other))]
    UnevenSegments { what: &'static str, width: f64, other: f64 },
    /// A joint that is not smooth enough.
    #[error(
        "{what} is C{needed} at its joints, but the curve is only C{order} at parameter {parameter}", parameter = plain(*parameter))]
    TooRough { what: &'static str, parameter: f64, order: usize, needed: usize },
    /// Several segments where one is wanted.
    #[error("{what} has one segment, but the curve has {got}")]
    TooManySegments { what: &'static str, got: usize },
    /// A surface that has not the form that is wanted.
    #[error("{wanted}, but {found}")]
    OtherForm { wanted: &'static str, found: String },
    /// Coordinates where only x may be.
    #[error("a scalar spline has its values in x, but y or z of point {index} is not zero")]
    NotScalar { index: usize },
    /// A question that only a NURBS has an answer to.
    #[error("a parametric {what} is a function and no NURBS")]
    NotNurbs { what: &'static str },
}

/// Curves and patches that do not meet as they should.
///
/// ```
/// use virote_kernel::{GeomError, JointError, NurbsCurve, glam::DVec3, join};
///
/// let first = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let second = NurbsCurve::line(DVec3::new(1.5, 0.0, 0.0), DVec3::new(2.0, 0.0, 0.0))?;
/// let found = join(&[first, second], 1e-6);
/// assert!(matches!(found, Err(GeomError::Joint(JointError::Gap { gap, .. })) if gap == 0.5));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum JointError {
    /// Curves that do not meet.
    #[error(
        "`curves[{}]` starts {} from where `curves[{index}]` ends, more than the tolerance {}",
        index + 1,
        few_digits(*gap),
        plain(*tolerance)
    )]
    Gap { index: usize, gap: f64, tolerance: f64, reversed: Option<usize> },
    /// Patches that do not meet along their sides.
    #[error(
        "`patches[{}][{}]` begins {} from where `patches[{}][{}]` ends along {along}, more than the tolerance {}",
        next[0], next[1], few_digits(*gap), before[0], before[1], plain(*tolerance)
    )]
    PatchGap { along: &'static str, before: [usize; 2], next: [usize; 2], gap: f64, tolerance: f64 },
    /// Patches that meet, but run along their common side at different speeds.
    #[error(
        "`patches[{}][{}]` and `patches[{}][{}]` meet with weights of different proportions along their side, which no one surface has",
        before[0], before[1], next[0], next[1]
    )]
    UnlikeWeights { before: [usize; 2], next: [usize; 2] },
}

/// A construction that comes to nothing there.
///
/// ```
/// use virote_kernel::{CircleForm, ConstructionError, Frame, GeomError, NurbsCurve, Tolerance, glam::DVec3};
///
/// // Inward by its radius nothing is left of a circle but its centre.
/// let circle = NurbsCurve::ellipse(Frame::XY, [2.0, 2.0], CircleForm::NinePoint)?;
/// let Err(GeomError::Construction(found)) = circle.offset(-2.0, DVec3::Z, Tolerance::DEFAULT) else {
///     unreachable!("it is refused");
/// };
/// assert!(matches!(found, ConstructionError::VanishingOffset { .. }));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum ConstructionError {
    /// A parameter line where the normal leaps.
    #[error(
        "the surface has a crease at {along} = {parameter}: its offset would be torn there by {}",
        few_digits(*gap), parameter = plain(*parameter))]
    Crease { along: &'static str, parameter: f64, gap: f64 },
    /// A continuation that is shorter than asked for.
    #[error(
        "the curve goes on for a length of {} only, less than {}",
        few_digits(*reached), plain(*wanted)
    )]
    EndOfContinuation { wanted: f64, reached: f64 },
    /// A continuation without digits.
    #[error(
        "prolonged by {} a curve of degree {degree} has no digits left: rounding grows with its degree",
        plain(*length)
    )]
    ContinuationLost { degree: usize, length: f64 },
    /// A curve along the direction about which it should turn.
    #[error("the curve runs along the normal at parameter {parameter}, so that it has no side", parameter = plain(*parameter))]
    AlongNormal { parameter: f64 },
    /// A curve that turns within its last digits.
    #[error("at parameter {parameter} the curve turns too fast for an offset to follow", parameter = plain(*parameter))]
    NoOffset { parameter: f64 },
    /// An offset beside which its curve is rounding.
    #[error(
        "at a distance of {} the shape of the curve is lost in the rounding of the coordinates",
        few_digits(distance.abs())
    )]
    OffsetTooFar { distance: f64 },
    /// An offset that is one point.
    #[error("the offset shrinks to a point: the distance is the radius {} of the arc", few_digits(*radius))]
    VanishingOffset { radius: f64 },
    /// A section that is scaled away.
    #[error("the section is scaled to a point all along the path")]
    VanishingSection,
    /// A section of a sweep that is a point.
    #[error("the section is one point")]
    PointSection,
    /// A path of a sweep that is a point.
    #[error("the path is one point, so that it leads nowhere")]
    PointPath,
    /// A path of a sweep that turns back.
    #[error("the path has a cusp at parameter {}, where it has no direction", plain(*parameter))]
    PathCusp { parameter: f64 },
    /// A path of a sweep with corners that nothing is said about.
    #[error("the path has {}", corners_at(parameters))]
    PathCorners { parameters: Vec<f64> },
    /// A closed section whose ends two rails should hold.
    #[error("the section ends where it begins, so that two rails cannot hold its ends")]
    ClosedBetweenRails,
    /// A section between others that is a point.
    #[error("`sections[{index}]` is a point; only the first and the last may be one")]
    PointBetween { index: usize },
    /// Sections that are points, all of them.
    #[error("both sections are points; one of them must be a curve")]
    OnlyPoints,
    /// A closed section among open ones.
    #[error(
        "`sections[{closed}]` is closed, `sections[{open}]` is open, so that it is not clear where the closed one begins"
    )]
    MixedSections { closed: usize, open: usize },
    /// A straight section along the spine.
    #[error(
        "a straight section that lies along the spine can be turned across it in any direction"
    )]
    NoTurn,
    /// What a tangent is asked for between.
    #[error("what the tangent should start from and come to does not lie in one plane: it leaves it by {}", few_digits(*by))]
    NotInOnePlane { by: f64 },
    /// Curves with as many tangents as places.
    #[error("as many {what} touch as there are places of a stretch that the curves run along together, near {}", place(*point))]
    TangentAllAlong { what: &'static str, point: DVec3 },
    /// Something to turn that lies on the axis.
    #[error("the curve lies on the axis, so that turning it makes no surface")]
    OnAxis,
}

/// How many corners there are, and where.
fn corners_at(parameters: &[f64]) -> String {
    let at: Vec<String> = parameters.iter().copied().map(plain).collect();
    match &at[..] {
        [only] => format!("a corner at parameter {only}"),
        many => format!("{} corners, at the parameters {}", many.len(), many.join(", ")),
    }
}
