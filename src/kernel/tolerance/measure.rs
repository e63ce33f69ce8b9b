//! Lengths, areas, volumes and distances.

/// Arc length is computed to this fraction of itself.
///
/// Larger shows in the last digits that a report prints; smaller asks for less than the rounding
/// of the sum, so that the subdivision runs to its ceiling everywhere.
pub const LENGTH_RELATIVE: f64 = 1e-13;

/// Areas and volumes are computed to this fraction of themselves, as far as a cell and its quarters
/// tell; the quarters are much nearer than that.
///
/// Larger shows in the last digits that a report prints; smaller asks for less than the rounding
/// of the sum.
pub const QUADRATURE_RELATIVE: f64 = 1e-12;

/// An area or volume of which less than this fraction may be wrong is told without a word.
///
/// Larger hides a fold that the integral misses; smaller warns of digits that nobody reads.
pub const ACCURACY_WORTH_TELLING: f64 = 1e-9;

/// An integral of which a larger fraction than this may be wrong is refused.
///
/// Larger tells numbers of which not two digits are right; smaller refuses what a warning would do
/// for.
pub const ACCURACY_WORTH_HAVING: f64 = 1e-2;

/// A search for the nearest point is content when nothing is nearer by more than this fraction of
/// the coordinates.
///
/// Larger answers with a place that is visibly not the nearest; smaller looks at ever smaller parts
/// around it, whose distances differ by rounding.
pub const NEAREST_RELATIVE: f64 = 1e-13;

/// Each finer tolerance within which surfaces are told apart is this fraction of the one before.
///
/// Larger tries more of them; smaller leaps over the one that tells.
pub(crate) const FINER_FACTOR: f64 = 0.01;

/// Where the bottom of a valley is so near to a number of few digits, as a fraction of its floor, that
/// number is the bottom.
///
/// Larger moves the place of a touch visibly; smaller tells digits that are rounding.
pub(crate) const FEW_DIGITS_SHARE: f64 = 0.02;

/// What of a face reaches farthest or is nearest is looked for inside until no more than this fraction of the
/// size is to be gained over the border.
///
/// Larger answers with the border where the inside reaches visibly farther; smaller divides boxes for the
/// rounding of their ends.
pub(crate) const EXTREMUM_RELATIVE: f64 = 1e-13;
