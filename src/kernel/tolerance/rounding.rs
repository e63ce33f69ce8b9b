//! Where the digits of an `f64` end: what rounding leaves, and what is computed to the last bit.

/// Rounding of a coordinate, as a fraction of it: the last bit of an `f64`.
///
/// Larger takes digits for noise; smaller than this nothing is computed.
pub const LAST_BIT: f64 = f64::EPSILON;

/// Roundings of the largest coordinate by which derivatives on both sides of a knot may differ that are the same, for
/// each order over the width of a piece.
///
/// Larger takes a corner of a curve that is small beside its distance from the origin for none; smaller finds corners
/// where rounding has been at work.
pub(crate) const KNOT_DERIVATIVE_ROUNDINGS: f64 = 64.0;

/// A derivative over the whole domain, or the area of two of them, below this fraction of the
/// control polygon's size (squared for areas) has vanished: its direction is rounding.
///
/// Rounding leaves some 1e-16 of the size. Larger takes slow points for singular ones and strips
/// narrower than this fraction of their length for folds; smaller answers with a random direction
/// at a cusp or a pole.
pub const VANISHING_RELATIVE: f64 = 1e-13;

/// Two ways to write one curve agree when their points differ by less than this fraction of the
/// largest: in another form, or without a knot where two of them were joined.
///
/// Larger loses a corner that somebody placed on purpose; smaller refuses to convert a curve that
/// went through a few knot insertions and elevations.
pub const EXACT_RELATIVE: f64 = 1e-11;

/// Weights that differ by less than this fraction of the largest are equal: the curve is not
/// rational.
///
/// Larger takes a weight written as 1.000001 for 1; smaller calls a polynomial curve rational
/// after a knot was inserted.
pub const WEIGHT_RELATIVE: f64 = 1e-13;

/// Bernstein coefficients of a product of polynomials below this fraction of the factors' largest
/// ones are rounding: they have no sign.
///
/// Larger overlooks a slight S in a nearly straight curve; smaller finds inflections in a circle.
pub const SIGN_RELATIVE: f64 = 1e-12;

/// A polynomial vector whose length has a minimum below this fraction of its largest value
/// vanishes there.
///
/// A minimum is known to the root of the rounding. Larger calls a tight bend a cusp; smaller
/// misses cusps at parameters that are no round numbers.
pub const TOUCH_RELATIVE: f64 = 1e-7;

/// A bounding box stops growing when the rest of the hull sticks out by less than this fraction
/// of the largest coordinate.
///
/// Larger leaves a box that is visibly loose on paper; smaller subdivides where the difference is
/// one rounding.
pub const BOUNDS_RELATIVE: f64 = 1e-15;

/// A number of steps within this fraction of a whole number is that whole number: `range` reaches
/// its end, and a parameter lies on its step.
///
/// Larger takes a value for a step that it misses; smaller calls 0.3 no multiple of 0.1.
pub const STEP_RELATIVE: f64 = 1e-9;

/// A coordinate below this part of the largest of its point is told as zero in messages.
///
/// Larger hides where places are; smaller shows what rounding left of nothing.
pub(crate) const SHOWN_RELATIVE: f64 = 1e-9;
