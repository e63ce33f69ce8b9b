//! Why a piece of geometry cannot exist, or a question about it has no answer.

use glam::DVec3;
use thiserror::Error;

use super::{FunctionFailure, Interval, JumpError, MeshError, PictureError, ShellError};

/// A request that has no geometric answer.
///
/// Carries numbers, never places in a script; the messages tell what was expected and what was found.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum GeomError {
    /// Work that whoever started it has ended, and tells why.
    #[error("the work was ended")]
    Ended,
    /// Fewer points than the construction needs.
    #[error("{needed} points or more are needed, got {got}")]
    TooFewPoints { got: usize, needed: usize },
    /// More control points than the ceiling allows.
    #[error("{got} control points are more than the {most} that are allowed")]
    TooManyPoints { got: usize, most: usize },
    /// A degree above the ceiling.
    #[error("degree {degree} is above {most}, the highest that is allowed")]
    DegreeTooHigh { degree: usize, most: usize },
    /// A degree that these points cannot have.
    #[error("degree {degree} needs at least {needed} points, got {points}")]
    BadDegree { degree: usize, points: usize, needed: usize },
    /// A degree below the one that the geometry has already.
    #[error("degree {to} is below the degree {from} that it has")]
    DegreeTooLow { from: usize, to: usize },
    /// Knots and control points do not go together.
    #[error("{points} control points of degree {degree} need {needed} knots, got {got}")]
    KnotCount { points: usize, degree: usize, needed: usize, got: usize },
    /// Too few knots for any curve of the degree.
    #[error("degree {degree} needs at least {needed} knots, got {got}")]
    TooFewKnots { degree: usize, needed: usize, got: usize },
    /// A knot below its predecessor.
    #[error("knot {index} is {knot}, below the {previous} before it; knots never decrease", previous = plain(*previous), knot = plain(*knot))]
    UnsortedKnots { index: usize, previous: f64, knot: f64 },
    /// A knot repeated more often than the degree allows.
    #[error("knot {knot} stands {times} times from index {index}; at most {most} are possible", knot = plain(*knot))]
    KnotMultiplicity { index: usize, knot: f64, times: usize, most: usize },
    /// All knots of the domain are one.
    #[error("the knots leave no domain: it would begin and end at {at}", at = plain(*at))]
    EmptyDomain { at: f64 },
    /// Knots whose difference overflows.
    #[error("the knots span {start}..{end}, wider than the largest number, 1.8e308", start = plain(*start), end = plain(*end))]
    DomainTooWide { start: f64, end: f64 },
    /// NaN or infinity.
    #[error("{what} {index} is not a finite number")]
    NotFinite { what: &'static str, index: usize },
    /// Weights and points do not pair up.
    #[error("{points} control points need {points} weights, got {weights}")]
    WeightCount { points: usize, weights: usize },
    /// A weight below zero.
    #[error("weight {index} is {weight}; weights are not negative", weight = plain(*weight))]
    BadWeight { index: usize, weight: f64 },
    /// A weight of zero at an end.
    #[error("weight {index} is {weight}; the first and the last weight are positive", weight = plain(*weight))]
    BadEndWeight { index: usize, weight: f64 },
    /// The weights leave a parameter without a point.
    #[error("the weights vanish together at parameter {parameter}, which leaves no point there", parameter = plain(*parameter))]
    VanishingWeights { parameter: f64 },
    /// The weights leave a place of a surface without a point.
    #[error("the weights vanish together at ({u}, {v}), which leaves no point there", u = plain(*u), v = plain(*v))]
    VanishingWeightsAt { u: f64, v: f64 },
    /// Rows of different length.
    #[error(
        "row {row} has {got} {}, row 0 has {expected}; every row needs the same number",
        if *got == 1 { "point" } else { "points" }
    )]
    RaggedGrid { row: usize, got: usize, expected: usize },
    /// Entries that do not fill their rows.
    #[error("{rows} rows of {columns} need {needed} entries, got {got}")]
    GridSize { rows: usize, columns: usize, needed: usize, got: usize },
    /// An interval without an inside.
    #[error("an interval needs its start below its end, got {start}..{end}", start = plain(*start), end = plain(*end))]
    EmptyInterval { start: f64, end: f64 },
    /// An interval between two parameters that count as one.
    #[error("the range {start}..{end} is too narrow to tell its ends apart", start = plain(*start), end = plain(*end))]
    NarrowInterval { start: f64, end: f64 },
    /// A parameter where there is nothing.
    #[error("parameter {} is outside the domain {domain}", plain(*parameter))]
    ParameterOutside { parameter: f64, domain: Interval },
    /// A parameter where nothing can be cut off.
    #[error("parameter {parameter} is an end of the domain {domain}; there is nothing to split", parameter = plain(*parameter))]
    ParameterAtEnd { parameter: f64, domain: Interval },
    /// No inner knot where one is to be taken out.
    #[error(
        "{} inner knot stands at {}{}",
        if *stands == 0 { "no".to_owned() } else { format!("only {stands} times an") },
        plain(*parameter),
        nearest.map_or(String::new(), |t| format!("; the nearest is {t}"))
    )]
    NoKnot { parameter: f64, stands: usize, nearest: Option<f64> },
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
    /// A curve of the lowest degree.
    #[error("the curve has degree {degree}, below which there is none")]
    LowestDegree { degree: usize },
    /// Fewer curves than the construction needs.
    #[error("{needed} curves or more are needed, found {got}")]
    TooFewCurves { got: usize, needed: usize },
    /// Curves that do not meet.
    #[error(
        "`curves[{}]` starts {} from where `curves[{index}]` ends, more than the tolerance {}",
        index + 1,
        few_digits(*gap),
        plain(*tolerance)
    )]
    Gap { index: usize, gap: f64, tolerance: f64, reversed: Option<usize> },
    /// A parameter line where the normal leaps.
    #[error(
        "the surface has a crease at {along} = {parameter}: its offset would be torn there by {}",
        few_digits(*gap), parameter = plain(*parameter))]
    Crease { along: &'static str, parameter: f64, gap: f64 },
    /// An offset that no spline surface of a reasonable size comes near.
    #[error(
        "no spline surface of {most} patches is within {} of the offset near ({u}, {v})",
        few_digits(*tolerance), u = plain(*u), v = plain(*v))]
    NoSurfaceNear { most: usize, tolerance: f64, u: f64, v: f64 },
    /// Lines on surfaces and regions that do not exist.
    #[error(transparent)]
    Picture(#[from] PictureError),
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
    /// A span of a patch that is rounding beside the others.
    #[error("a span of `patches[{}][{}]`, {} wide, vanishes in a domain of length {total}", patch[0], patch[1], plain(*length), total = plain(*total))]
    VanishingPatch { patch: [usize; 2], length: f64, total: f64 },
    /// A span that is rounding beside the others.
    #[error("a span of `curves[{index}]`, {} wide, vanishes in a domain of length {total}", plain(*length), total = plain(*total))]
    VanishingPiece { index: usize, length: f64, total: f64 },
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
    /// A derivative beyond the ceiling.
    #[error("derivatives of order {order} are above {most}, the highest that is allowed")]
    OrderTooHigh { order: usize, most: usize },
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
    /// Surfaces that enclose nothing.
    #[error(transparent)]
    Shell(#[from] ShellError),
    /// An area or volume of zero.
    #[error("there is no {what} that could have a centre")]
    NothingThere { what: &'static str },
    /// An area or volume, or its moments, that overflow.
    #[error("the {what} or its moments are beyond the largest number, 1.8e308")]
    TooLargeToMeasure { what: &'static str },
    /// An area or volume that underflows.
    #[error("the {what} is below the smallest number, 2.2e-308")]
    TooSmallToMeasure { what: &'static str },
    /// Two points that must differ do not.
    #[error("points {first} and {second} are at one place")]
    CoincidentPoints { first: usize, second: usize },
    /// Not as many of something as the construction needs.
    #[error("{needed} {what} are needed, got {got}")]
    WrongCount { what: &'static str, needed: usize, got: usize },
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
        plain(*tolerance), plain(*found)
    )]
    ToleranceNotKept { tolerance: f64, found: f64 },
    /// Three points that lie on one line.
    #[error("the three points lie on one line, so that no circle goes through them")]
    Collinear,
    /// A piece of a line where a conic is wanted.
    #[error("the curve is straight from parameter {parameter}, which is no conic", parameter = plain(*parameter))]
    NoConic { parameter: f64 },
    /// Pieces of different conics.
    #[error("the curve changes its kind at parameter {parameter}: its pieces are different conics", parameter = plain(*parameter))]
    MixedConics { parameter: f64 },
    /// A curve that should lie in one plane.
    #[error("the curve is not planar: it leaves its plane by {}", few_digits(*by))]
    NotPlanar { by: f64 },
    /// A straight section along the spine.
    #[error(
        "a straight section that lies along the spine can be turned across it in any direction"
    )]
    NoTurn,
    /// Derivatives and points do not pair up.
    #[error("{points} points need {points} tangents, got {tangents}")]
    TangentCount { points: usize, tangents: usize },
    /// A tension that turns the Beta-spline's weights around.
    #[error("the tension is {tension}; with this bias it must be above {above}", tension = plain(*tension), above = plain(*above))]
    TensionTooLow { tension: f64, above: f64 },
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
    /// Two domains that should be one.
    #[error("the domains differ: {domain} and {other}")]
    OtherDomain { domain: Interval, other: Interval },
    /// A mesh above the ceiling.
    #[error(
        "the mesh would have {} vertices, more than the {most} that are allowed",
        if *got == usize::MAX { "countless".to_owned() } else { got.to_string() }
    )]
    TooManyVertices { got: usize, most: usize },
    /// A mesh attribute that is not one a vertex.
    #[error("{vertices} vertices need {vertices} {what}, got {got}")]
    AttributeCount { what: &'static str, vertices: usize, got: usize },
    /// A mesh that encloses nothing, or has colours that are none.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} names vertex {vertex}; there are {vertices}")]
    NoSuchVertex { triangle: usize, vertex: u32, vertices: usize },
    /// A normal that is not a unit vector.
    #[error("normal {index} has length {length}; normals are unit vectors", length = plain(*length))]
    NotUnit { index: usize, length: f64 },
    /// A count of zero where something must be divided.
    #[error("{what} is {got}; at least {needed} is needed")]
    CountTooSmall { what: &'static str, got: usize, needed: usize },
    /// A direction of length zero, or along the direction that it should differ from.
    #[error("{what} has no direction")]
    ZeroAxis { what: &'static str },
    /// Two directions along one line where they should span a plane.
    #[error("{first} is parallel to {second}")]
    ParallelAxes { first: &'static str, second: &'static str },
    /// A radius, tolerance or the like that is not positive.
    #[error("{}", not_positive(what, *got))]
    NotPositive { what: &'static str, got: f64 },
    /// A transformation that flattens space.
    #[error("the transformation flattens space: its determinant is zero")]
    SingularTransform,
    /// A function that something is made of has no value.
    #[error(transparent)]
    Function(#[from] FunctionFailure),
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
    /// A question that only a NURBS has an answer to.
    #[error("a parametric {what} is a function and no NURBS")]
    NotNurbs { what: &'static str },
    /// A function that no spline of a reasonable size comes near.
    #[error("no spline of 4096 pieces is within {} of the function at {parameter}", few_digits(*tolerance), parameter = plain(*parameter))]
    NoSplineNear { tolerance: f64, parameter: f64 },
    /// A function of two parameters that no spline of a reasonable size comes near.
    #[error("no spline of 16384 patches is within {} of the function at ({u}, {v})", few_digits(*tolerance), u = plain(*u), v = plain(*v))]
    NoSplineNearAt { tolerance: f64, u: f64, v: f64 },
    /// What is in pieces that do not meet.
    #[error(transparent)]
    Jump(#[from] JumpError),
    /// A length that the curve does not have.
    #[error(
        "the curve is {} long, so that it has no place at length {}", plain(*total), plain(*got)
    )]
    LengthOutside { got: f64, total: f64 },
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
    /// Something to turn that lies on the axis.
    #[error("the curve lies on the axis, so that turning it makes no surface")]
    OnAxis,
    /// An angle that makes no surface of revolution.
    #[error(
        "{}",
        if *turns == 0.0 {
            "a turn by an angle of zero makes no surface".to_owned()
        } else {
            format!("a turn by {} goes around more than once", degrees(*turns))
        }
    )]
    BadTurn { turns: f64 },
    /// Two columns of one name.
    #[error("column {name:?} stands twice")]
    DuplicateColumn { name: String },
    /// Columns of different length.
    #[error("column {name:?} has {got} {}, the first has {expected}", if *got == 1 { "row" } else { "rows" })]
    ColumnLength { name: String, got: usize, expected: usize },
}

pub(crate) use super::digits::few_digits;
use super::digits::{degrees, how_far, not_positive, plain};
