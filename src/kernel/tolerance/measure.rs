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

/// The offset of a region by less than this part of its size leaves it as it is.
///
/// Larger loses small offsets of large regions; smaller asks for parts of sides whose parameters are rounding.
pub(crate) const OFFSET_RELATIVE: f64 = 1e-10;

/// The share of the distance of an offset that places of its border are one within, where that is less than the
/// tolerance.
///
/// Larger takes what the offset tears open for one; smaller asks for arcs that are nearer than anybody needs.
pub(crate) const OFFSET_SHARE: f64 = 0.00390625;

/// Sizes from the origin beyond which what is asked of a shape is affected by the last bits of its coordinates.
///
/// Larger leaves integrals of what is that far to be divided for digits that nobody has; smaller moves the planes of
/// regions that lie beside the origin.
pub(crate) const FAR_SHARE: f64 = 64.0;

/// How far beside a crease, as a fraction of the domain, a function is asked that has no derivative on it.
///
/// Larger takes the value of another place; smaller is on the crease up to rounding.
pub const BESIDE_CREASE: f64 = 1e-12;

/// A step along a surface of a function that its tangents do not explain is a jump where it is larger than this
/// fraction of the surface's size, however narrow.
///
/// Larger passes over tears; smaller follows what only bends.
pub(crate) const GAP_RELATIVE: f64 = 1e-6;

/// So narrow, as a fraction of the domain.
///
/// Larger takes what is steep for torn; smaller asks where the parameter has no digits left.
pub(crate) const GAP_WIDTH_RELATIVE: f64 = 1e-13;

/// A gap of which less than this share is left after eight halvings fades: that of a root does.
///
/// Larger takes what is infinitely steep for connected where it jumps beside; smaller takes it for torn.
pub(crate) const GAP_FADES: f64 = 0.7;

/// The gradient of a length, an area or a volume is computed until two rules agree to this fraction of it;
/// the finer one, which counts, is much nearer than that.
///
/// Larger shows in the last digits that a report prints; smaller halves what is known already.
pub const GRADIENT_RELATIVE: f64 = 1e-11;

/// Surfaces that vary are moved by this fraction of their size to see whether they stay closed.
///
/// Larger takes edges that glide along one another for open, whose gap grows by the square; smaller hides a
/// gap below the tolerance within which surfaces close.
pub const APART_STEP_RELATIVE: f64 = 1e-3;

/// Edges that come apart by more than this fraction of the size of the surfaces on that way, besides the
/// tolerance, open.
///
/// Larger gives a derivative to a volume that leaks; smaller refuses edges that glide.
pub const APART_RELATIVE: f64 = 4e-6;

/// What an operation makes of arguments that move lies on a straight line or a parabola if it misses it by
/// less than this fraction of its numbers.
///
/// Larger takes a bend for none, and its chord for a derivative; smaller takes the rounding of equations
/// that are solved for a bend.
pub const AFFINE_RELATIVE: f64 = 1e-10;

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

/// Seen from a place, a closed shell turns around it a whole number of times, to this fraction of a turn.
///
/// Larger takes a place next to the shell for one inside or outside; smaller refuses what quadrature can tell.
pub(crate) const WHOLE_TURN_SLACK: f64 = 1e-3;

/// The way from its nearest point on a face to a place is at right angles to the face, when its cosine with the normal is
/// this near to 1.
///
/// Larger takes what is beside an edge for what is above a face; smaller sums solid angles where a normal would do.
pub(crate) const STRAIGHT_SLACK: f64 = 1e-9;

/// By how much the parameter lines of a surface may be askew to the circles about an axis, as a share, for integrals over
/// them to be taken in closed form.
///
/// Larger takes lines for circles that are none; smaller asks for the integral over areas where rounding is all that they
/// are askew by.
pub(crate) const ROUND_SKEW: f64 = 1e-9;
