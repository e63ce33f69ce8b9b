//! What is wrong with what geometry is to be made of.

use thiserror::Error;

use super::super::{
    Interval,
    digits::{degrees, not_positive, plain},
};

/// Knots that no spline can have, or that are not where they are looked for.
///
/// ```
/// use virote_kernel::{GeomError, KnotError, KnotVector};
///
/// let found = KnotVector::new(1, vec![0.0, 0.0, 1.0, 0.5]);
/// assert!(matches!(found, Err(GeomError::Knots(KnotError::UnsortedKnots { index: 3, .. }))));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum KnotError {
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
    /// No inner knot where one is to be taken out.
    #[error(
        "{} inner knot stands at {}{}",
        if *stands == 0 { "no".to_owned() } else { format!("only {stands} times an") },
        plain(*parameter),
        nearest.map_or(String::new(), |t| format!("; the nearest is {t}"))
    )]
    NoKnot { parameter: f64, stands: usize, nearest: Option<f64> },
    /// A span of a patch that is rounding beside the others.
    #[error("a span of `patches[{}][{}]`, {} wide, vanishes in a domain of length {total}", patch[0], patch[1], plain(*length), total = plain(*total))]
    VanishingPatch { patch: [usize; 2], length: f64, total: f64 },
    /// A span that is rounding beside the others.
    #[error("a span of `curves[{index}]`, {} wide, vanishes in a domain of length {total}", plain(*length), total = plain(*total))]
    VanishingPiece { index: usize, length: f64, total: f64 },
}

/// Weights that leave places without a point.
///
/// ```
/// use virote_kernel::{GeomError, KnotVector, NurbsCurve, WeightError, glam::DVec3};
///
/// let found = NurbsCurve::rational(KnotVector::bezier(1)?, &[DVec3::ZERO, DVec3::X], &[1.0]);
/// let expected = WeightError::WeightCount { points: 2, weights: 1 };
/// assert_eq!(found, Err(GeomError::Weights(expected)));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum WeightError {
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
}

/// A degree that is not possible there.
///
/// ```
/// use virote_kernel::{DegreeError, GeomError, NurbsCurve, ceiling, glam::DVec3};
///
/// let found = NurbsCurve::bezier(&vec![DVec3::ZERO; ceiling::DEGREE + 2]);
/// assert!(matches!(found, Err(GeomError::Degree(DegreeError::DegreeTooHigh { degree: 101, .. }))));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum DegreeError {
    /// A degree above the ceiling.
    #[error("degree {degree} is above {most}, the highest that is allowed")]
    DegreeTooHigh { degree: usize, most: usize },
    /// A degree that these points cannot have.
    #[error("degree {degree} needs at least {needed} points, got {points}")]
    BadDegree { degree: usize, points: usize, needed: usize },
    /// A degree below the one that the geometry has already.
    #[error("degree {to} is below the degree {from} that it has")]
    DegreeTooLow { from: usize, to: usize },
    /// A curve of the lowest degree.
    #[error("the curve has degree {degree}, below which there is none")]
    LowestDegree { degree: usize },
    /// A derivative beyond the ceiling.
    #[error("derivatives of order {order} are above {most}, the highest that is allowed")]
    OrderTooHigh { order: usize, most: usize },
}

/// Not as many of something as are needed, or too many.
///
/// ```
/// use virote_kernel::{CountError, GeomError, Grid};
///
/// let found = Grid::from_rows(vec![vec![1.0, 2.0], vec![3.0]]);
/// let expected = CountError::RaggedGrid { row: 1, got: 1, expected: 2 };
/// assert_eq!(found, Err(GeomError::Count(expected)));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum CountError {
    /// Fewer points than the construction needs.
    #[error("{needed} points or more are needed, got {got}")]
    TooFewPoints { got: usize, needed: usize },
    /// More control points than the ceiling allows.
    #[error("{got} control points are more than the {most} that are allowed")]
    TooManyPoints { got: usize, most: usize },
    /// Rows of different length.
    #[error(
        "row {row} has {got} {}, row 0 has {expected}; every row needs the same number",
        if *got == 1 { "point" } else { "points" }
    )]
    RaggedGrid { row: usize, got: usize, expected: usize },
    /// Entries that do not fill their rows.
    #[error("{rows} rows of {columns} need {needed} entries, got {got}")]
    GridSize { rows: usize, columns: usize, needed: usize, got: usize },
    /// Fewer curves than the construction needs.
    #[error("{} needed, found {got}", if *needed == 1 { "a curve is".to_owned() } else { format!("{needed} curves or more are") })]
    TooFewCurves { got: usize, needed: usize },
    /// Not as many of something as the construction needs.
    #[error("{needed} {what} are needed, got {got}")]
    WrongCount { what: &'static str, needed: usize, got: usize },
    /// Derivatives and points do not pair up.
    #[error("{points} points need {points} tangents, got {tangents}")]
    TangentCount { points: usize, tangents: usize },
    /// A mesh above the ceiling.
    #[error(
        "the mesh would have {} vertices, more than the {most} that are allowed",
        if *got == usize::MAX { "countless".to_owned() } else { got.to_string() }
    )]
    TooManyVertices { got: usize, most: usize },
    /// A mesh attribute that is not one a vertex.
    #[error("{vertices} vertices need {vertices} {what}, got {got}")]
    AttributeCount { what: &'static str, vertices: usize, got: usize },
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} names vertex {vertex}; there are {vertices}")]
    NoSuchVertex { triangle: usize, vertex: u32, vertices: usize },
    /// A count of zero where something must be divided.
    #[error("{what} is {got}; at least {needed} is needed")]
    CountTooSmall { what: &'static str, got: usize, needed: usize },
    /// Two columns of one name.
    #[error("column {name:?} stands twice")]
    DuplicateColumn { name: String },
    /// Columns of different length.
    #[error("column {name:?} has {got} {}, the first has {expected}", if *got == 1 { "row" } else { "rows" })]
    ColumnLength { name: String, got: usize, expected: usize },
}

/// A number or direction that makes no geometry.
///
/// ```
/// use virote_kernel::{Frame, GeomError, InputError, glam::DVec3};
///
/// let found = Frame::from_normal(DVec3::ZERO, DVec3::ZERO, None);
/// assert!(matches!(found, Err(GeomError::Input(InputError::ZeroAxis { what: "the normal" }))));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum InputError {
    /// NaN or infinity.
    #[error("{what} {index} is not a finite number")]
    NotFinite { what: &'static str, index: usize },
    /// Two points that must differ do not.
    #[error("points {first} and {second} are at one place")]
    CoincidentPoints { first: usize, second: usize },
    /// Three points that lie on one line.
    #[error("the three points lie on one line, so that no circle goes through them")]
    Collinear,
    /// A tension that turns the Beta-spline's weights around.
    #[error("the tension is {tension}; with this bias it must be above {above}", tension = plain(*tension), above = plain(*above))]
    TensionTooLow { tension: f64, above: f64 },
    /// A normal that is not a unit vector.
    #[error("normal {index} has length {length}; normals are unit vectors", length = plain(*length))]
    NotUnit { index: usize, length: f64 },
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
}

/// A parameter or length where there is nothing.
///
/// ```
/// use virote_kernel::{DomainError, GeomError, Interval};
///
/// let found = Interval::new(1.0, 0.0);
/// assert_eq!(found, Err(GeomError::Domain(DomainError::EmptyInterval { start: 1.0, end: 0.0 })));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[expect(missing_docs, reason = "each message names its fields")]
pub enum DomainError {
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
    /// Two domains that should be one.
    #[error("the domains differ: {domain} and {other}")]
    OtherDomain { domain: Interval, other: Interval },
    /// A length that the curve does not have.
    #[error(
        "the curve is {} long, so that it has no place at length {}", plain(*total), plain(*got)
    )]
    LengthOutside { got: f64, total: f64 },
}
