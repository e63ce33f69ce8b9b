//! Splines in the place of functions.

/// The spline that stands in for a function in questions about all of it agrees with it to this
/// fraction of its size.
///
/// Larger shows in the digits of a length; smaller asks for more digits than functions compute, so
/// that no number of pieces suffices.
pub const STAND_IN_RELATIVE: f64 = 1e-13;

/// A piece of this fraction of a function's domain that no spline comes near is looked at for a
/// place without derivatives.
///
/// Larger looks at pieces that are only too wide; smaller overlooks jumps of second derivatives.
pub const SUSPICIOUS_RELATIVE: f64 = 2e-3;

/// Terms of a Taylor series over the last bits of a parameter that grow by more than this are those
/// of a function without derivatives.
///
/// Larger takes the slope of a square root beside zero for one; smaller takes rounding for it.
pub const UNBOUNDED_RELATIVE: f64 = 1e-3;

/// The box around the surface of a function is known to this fraction of its size.
///
/// Larger shows beside a box that is known otherwise; smaller takes seconds for a few bends.
pub const BOX_RELATIVE: f64 = 1e-8;

/// Beside a place where a function has no derivatives, a spline may miss it by this fraction of its
/// size.
///
/// Larger answers for functions that jump; smaller refuses a square root down to zero.
pub const SINGULAR_RELATIVE: f64 = 1e-6;

/// What is computed of a function's derivatives is followed through its zeros with polynomials that
/// agree with it to this fraction of what it is made of.
///
/// Larger takes a touch for two crossings; smaller follows rounding.
pub const FOLLOWED_RELATIVE: f64 = 1e-11;

/// A cell of this fraction of a function's domain that no patch comes near is looked at for a crease.
///
/// Larger looks at cells that are only too wide; smaller makes many patches before a crease is seen.
pub(crate) const SUSPICIOUS_CELL_RELATIVE: f64 = 0.02;
