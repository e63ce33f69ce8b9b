//! Tolerances of searches for least values.

/// A place at which a search for a least value settled is none where another, by other sizes, is lower by this fraction of
/// its value.
///
/// Larger keeps what is no least value; smaller goes on where a function's own roundings are lower.
pub(crate) const LEAST_LOWER_RELATIVE: f64 = 1e-11;

/// A way along which a function bends by this share of the most bends by no less, for a step of Newton's method.
///
/// Larger takes steps in narrow valleys that are too short; smaller divides by roundings of the curvature.
pub(crate) const LEAST_NEWTON_BEND: f64 = 1e-13;

/// How far beside a place gradients tell the curvature for a step of Newton's method, as a fraction of the unknowns' sizes.
///
/// Larger looks over valleys that are narrow; smaller sees roundings of gradients.
pub(crate) const LEAST_NEWTON_REACH: f64 = 1e-6;

/// A place that is nearer to zero than this share of an unknown's size counts as so far from it where the curvature is
/// looked at.
///
/// Larger looks at it too far beside; smaller between numbers that are no different.
pub(crate) const LEAST_NEARNESS: f64 = 1e-12;

/// Over ways that are longer than this fraction of the unknowns' sizes [`LEAST_FALL_RELATIVE`] does not count.
///
/// Larger ends where an exponential function fell by much and falls on; smaller follows powers for longer.
pub(crate) const LEAST_FALL_REACH: f64 = 1e-5;

/// A change of a function by this share of its fall so far means nothing to a descent towards its least value.
///
/// Larger ends far from what a power comes to; smaller follows powers of what comes to zero to where numbers end.
pub(crate) const LEAST_FALL_RELATIVE: f64 = 1e-48;

/// A function lies level where it is above its least value by less than this share of its whole fall.
///
/// Larger ends before its level; smaller takes roundings of the function for a slope.
pub(crate) const LEAST_LEVEL_RELATIVE: f64 = 1e-10;

/// The share of all powers of ten of its fall by which a function still falls over the last tenth of the way to where it lies
/// level, if it comes down to that at a place; one that falls by less tends to it, as exponential functions do by a tenth.
///
/// Larger refuses what is smooth where it becomes level; smaller takes what rounding reaches for what is attained.
pub(crate) const LEVEL_APPROACH: f64 = 0.2;

/// A function that falls by more than this share of its whole fall over that tenth comes down to a level, however it does.
///
/// Larger takes what tends to a value by few of its digits for what attains it; smaller refuses levels behind a step.
pub(crate) const LEVEL_SHARE: f64 = 0.05;

/// A search for a least value that settled where its steps are still this share as steep as some before settled beside
/// kinks; slopes that differ by this share of themselves are those of two sides of one.
///
/// Larger takes kinks on gentle slopes for smooth; smaller looks for kinks where a valley is only narrow.
pub(crate) const KINK_SLOPE_RELATIVE: f64 = 1e-3;

/// Slopes on one side of a kink that differ by no more than this share of themselves are one.
///
/// Larger loses how a side is curved; smaller keeps planes apart that rounding makes contradict one another.
pub(crate) const PLANE_RELATIVE: f64 = 1e-7;

/// A fall that is promised beside kinks and not found counts as this fraction of the value, or of the whole fall.
///
/// Larger takes for least values what is none; smaller refuses values that are right to all digits that their function has.
pub(crate) const KINK_PROMISE_RELATIVE: f64 = 1e-10;

/// Differences beside kinks are taken over this fraction of the unknowns.
///
/// Larger mixes both sides of a kink; smaller leaves rounding.
pub(crate) const KINK_DIFFERENCE_RELATIVE: f64 = 1e-8;

/// How far beside a kink its sides are asked for their slopes, as a fraction of the unknowns.
///
/// Larger asks beyond the next kink; smaller leaves the place within the rounding of the kink.
pub(crate) const KINK_SIDE_RELATIVE: f64 = 1e-11;

/// How far beside a place such differences are taken, as a fraction of the unknowns.
///
/// Larger misses the sides that meet at a place; smaller takes differences across its kinks.
pub(crate) const KINK_BESIDE_RELATIVE: f64 = 1e-7;

/// By how many times farther beside such differences are taken where they are across a kink, and how far at most, as a
/// fraction of the unknowns.
///
/// A larger step misses the sides that meet at a place, as farther does; a smaller one asks more often, and nearer finds no
/// side where many meet.
pub(crate) const KINK_FARTHER: f64 = 4.0;
pub(crate) const KINK_FARTHEST_RELATIVE: f64 = 1e-4;

/// Near by a place beside kinks is within these fractions of the unknowns' sizes, one after the other.
///
/// A larger first one finds a fall sooner where kinks are straight; without the smaller ones a kink that is bent passes for
/// what meets there on all sides.
pub(crate) const KINK_HULL_REACHES: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];

/// A fall that is promised near by counts as this share of what the steepest slope there promises, by gradients and by
/// differences.
///
/// Larger takes for least values what lies on gentle slopes along a steep kink; smaller refuses values by rounding.
pub(crate) const KINK_HULL_RELATIVE: f64 = 1e-9;
pub(crate) const KINK_HULL_DIFFERENCE_RELATIVE: f64 = 1e-7;

/// Changes of a function over the same way before and behind a place that differ by this share of themselves are those of
/// two sides of a kink.
///
/// Larger takes differences across kinks for slopes; smaller takes a bend for a kink.
pub(crate) const KINK_UNLIKE_RELATIVE: f64 = 1e-2;

/// Last bits by which a value beside kinks may be wrong.
///
/// Larger hides falls; smaller follows rounding.
pub(crate) const KINK_ROUNDINGS: f64 = 16.0;

/// How many times as much as it changes over a way, in the unknowns' sizes, a slope does at a kink at least.
///
/// Larger takes kinks for bends; smaller takes bends for kinks.
pub(crate) const KINK_BEND_MOST: f64 = 100.0;

/// How many times less or more than it was learned the curvature counts between kinks at most.
///
/// Larger follows what rounding promises; smaller ends before ways are long enough.
pub(crate) const KINK_SHARE_MOST: f64 = 1e16;

/// How many times as much as it does least a function bends at most, as far as it has no kinks.
///
/// Larger takes kinks for bends, so that steps beside them are short; smaller takes narrow valleys for kinks.
pub(crate) const CURVATURE_SPREAD: f64 = 1e8;

/// Curvatures that hold a step from a kink within reach, as shares of the steepest slope over the reach: what narrow
/// valleys promise shows with little of it.
pub(crate) const KINK_HULL_BENDS: [f64; 4] = [1.0, 1e-2, 1e-4, 1e-6];
