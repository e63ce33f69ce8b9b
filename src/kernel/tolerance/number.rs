//! Searches of numbers: roots, least values, integrals.

/// A root is at rest where its bracket is this fraction of the interval in which it was looked for, or
/// two neighbouring numbers.
///
/// Larger loses digits of roots near zero; smaller goes on through numbers that are zero to everybody.
pub const ROOT_RELATIVE: f64 = 1e-18;

/// A function whose values on both sides of a change of sign differ by this fraction of its values in
/// the interval jumps there, or has a pole.
///
/// Larger takes a jump for a root; smaller takes a steep root, such as that of a cube root, for a jump.
pub const ROOT_JUMP_RELATIVE: f64 = 1e-3;

/// A function whose least distance from zero is this fraction of its values touches zero there.
///
/// Larger takes what comes near for a root; smaller takes rounding for a distance.
pub const ROOT_TOUCH_RELATIVE: f64 = 1e-13;

/// The place of a least value is known to this fraction of itself, half of the digits, since the value
/// changes with the square of the distance.
///
/// Larger loses digits; smaller searches among values that rounding makes equal.
pub const LEAST_PLACE_RELATIVE: f64 = 1.5e-8;

/// A piece of this fraction of an interval is not divided any more.
///
/// Larger refuses integrals of functions that grow fast at an end; smaller goes on to the end of all
/// numbers where there is no integral.
pub const INTEGRAL_WIDTH_RELATIVE: f64 = 1e-150;

/// An integral is known to this fraction of the integral of the function's size, unless asked otherwise.
///
/// Larger shows in its digits; smaller asks for more digits than functions compute.
pub const INTEGRAL_RELATIVE: f64 = 1e-13;

/// Derivatives of functions that have none of their own are taken over this fraction of the unknown on
/// both sides: the cube root of the last bit.
///
/// Larger leaves third derivatives in the difference; smaller leaves rounding.
pub const DIFFERENCE_RELATIVE: f64 = 6e-6;

/// A step that moves unknowns by this fraction of themselves moves them no more.
///
/// Larger ends a search early; smaller goes on in the last bit.
pub const STEP_REST_RELATIVE: f64 = 2e-16;

/// The share of its diagonal by which the first equations of a search for least squares are damped.
///
/// Larger begins with short steps down the steepest way; smaller leaps from starts that are far.
pub const DAMPING_FIRST: f64 = 1e-3;

/// Functions of which this fraction is left of what they were at the start are zero.
///
/// Larger takes a place near a root for one; smaller takes rounding for a distance.
pub const SYSTEM_ROOT_RELATIVE: f64 = 1e-9;
