//! Places by their parameters: knots, data, and what is beside a place.

/// Two knots closer than this fraction of the domain are one knot, and a parameter that far
/// outside the domain is its end.
///
/// Larger merges knots that somebody placed on purpose; smaller leaves spans of rounding width,
/// where derivatives are noise, and refuses `c(0.1 * 10)` at the end of 0..1.
pub const KNOT_RELATIVE: f64 = 1e-12;

/// Knots of different splines closer than this fraction of the domain become one where the splines
/// get a common basis.
///
/// Twice the 1e-9 within which other kernels write one knot. Moving a knot moves the spline by a like
/// fraction of its size. Larger moves joints visibly; smaller leaves spans so narrow that
/// second derivatives across them are noise.
pub const KNOT_CLUSTER_RELATIVE: f64 = 2e-9;

/// Two parameters of data closer than this fraction of the domain are one.
///
/// A few times [`KNOT_RELATIVE`], because knots are made between them. Larger refuses data whose
/// spacing varies much; smaller lets knots merge that should each have their own datum.
pub const PARAMETER_RELATIVE: f64 = 1e-11;

/// A parameter that misses a singular place of a curve by less than this fraction of the span is
/// that place, where its kind is told.
///
/// Larger takes a bend beside an inflection for the inflection; smaller misses one whose parameter
/// somebody computed or typed with nine digits.
pub const PLACE_RELATIVE: f64 = 1e-9;

/// How far from a place, as a fraction of its span, its two sides are looked at.
///
/// Larger looks past features that lie close together; smaller looks at rounding.
pub const SIDE_STEP: f64 = 1e-4;
