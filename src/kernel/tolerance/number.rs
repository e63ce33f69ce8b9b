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

/// How far beside a change of sign, as a share of the distance of the places that found it, a function is asked whether
/// it jumps or is steep there.
///
/// Larger takes what the function does beside a jump for its slope; smaller tells no steep root from a jump.
pub const JUMP_LOOK: f64 = 1e-6;

/// A function that is no nearer to zero beside a change of sign than this share of what it is further away jumps over zero.
///
/// Larger refuses jumps beside which the function slopes; smaller loses steep roots, such as that of a tenth root.
pub const JUMP_KEEPS: f64 = 0.99;

/// The power of the distance with which a function shrinks beside a change of sign stays at this share of itself further
/// on, where there is a root with a vertical tangent.
///
/// Larger loses roots beside which the function bends; smaller takes a jump for a root that is small beside its slopes.
pub(crate) const STEEP_POWER_KEEPS: f64 = 0.75;

/// A function whose least distance from zero is this fraction of its values touches zero there.
///
/// Larger takes what comes near for a root; smaller takes rounding for a distance.
pub const ROOT_TOUCH_RELATIVE: f64 = 1e-13;

/// Where a function is exactly zero it is asked this fraction of the interval beside, whether it is zero there too.
///
/// Larger steps over functions that are zero along a short stretch; smaller takes a root around which the function
/// has no digits for a stretch.
pub const ROOT_BESIDE_RELATIVE: f64 = 1e-2;

/// The place of a least value is known to this fraction of itself, half of the digits, since the value
/// changes with the square of the distance.
///
/// Larger loses digits; smaller searches among values that rounding makes equal.
pub const LEAST_PLACE_RELATIVE: f64 = 1.5e-8;

/// Halves of a piece of an integral whose sum stays the whole up to this fraction, though both are off, hold noise alone.
///
/// Larger takes what is not resolved yet for noise; smaller goes on among the last digits of a function.
pub(crate) const INTEGRAL_NOISE_RELATIVE: f64 = 1e-5;

/// What a function is off at a place between those of its integral counts where it would change the integral by this
/// fraction over the distance of such places.
///
/// Larger leaves loads on a part of a range unseen; smaller takes for one what a smooth function is off between nodes.
pub(crate) const INTEGRAL_SEEN_RELATIVE: f64 = 1e-6;

/// How far beyond an end of a range a rate is looked at, as a fraction of the range.
///
/// Larger takes a jump beside the end for one on it; smaller is lost among the last digits of a place.
pub const BEYOND_END_RELATIVE: f64 = 1e-11;

/// How fast a comparison changes along an integral is told over this share of the range.
///
/// Larger leaves the stretch in which it is smooth; smaller leaves rounding.
pub const SWITCH_STEP_RELATIVE: f64 = 1e-3;

/// By how much the steps over which such a speed is told become shorter, where on a longer way another way was gone.
///
/// Larger finds a stretch that is short in more steps; smaller leaves rounding sooner.
pub const SWITCH_STEP_SHRINK: f64 = 0.0625;

/// Places move together if their speeds differ by less than this fraction.
///
/// Larger takes two places that part for one; smaller parts one by the rounding of its differences.
pub const SWITCH_SPEED_RELATIVE: f64 = 1e-6;

/// A function that differs by less than this fraction on both sides of a place does not jump there.
///
/// Larger loses the motion of small jumps from a derivative; smaller looks for that of rounding.
pub const SWITCH_ALIKE_RELATIVE: f64 = 1e-11;

/// How near to a pole a function is asked at most, as a fraction of the unknowns' sizes.
///
/// Larger takes for a pole what is bounded nearer by; smaller asks about a pole at 0 for longer.
pub(crate) const POLE_NEAREST: f64 = 1e-40;

/// The share of its fall over the part of the way to a pole before by which a function falls over the next one at least.
///
/// Larger does not see that a logarithm falls on; smaller takes high roots of a distance for poles.
pub(crate) const POLE_SHRINKAGE: f64 = 0.9;

/// A fall towards a pole is at least this fraction of the value.
///
/// Larger misses logarithms beside large numbers; smaller takes noise for a fall.
pub(crate) const POLE_FALL_RELATIVE: f64 = 1e-6;

/// A limit without a unit beside an angle up to here leaves rounding alone, whichever unit is meant.
///
/// Larger lets claims hold in radians that are meant in degrees; smaller refuses limits for rounding.
pub const LIMIT_WITHOUT_UNIT: f64 = 1e-3;

/// Pieces of an integral of which two rules say things that differ by this fraction may hide a place up to which there
/// is none.
///
/// Larger passes over small poles on large functions; smaller asks more questions where a tolerance is wide.
pub(crate) const INTEGRAL_SUSPECT_RELATIVE: f64 = 1e-6;

/// The power of the logarithm of the distance to a place by which a function's size times the distance falls, at least,
/// where its integral up to there is known: of 1/(x·ln x) it is 1 and there is none, of 1/(x·ln² x) it is 2.
///
/// Larger refuses integrals that are known; smaller takes what numbers reach of an endless one for all of it.
pub(crate) const INTEGRAL_TAIL_LEAST: f64 = 1.5;

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

/// Where a derivative is found by differences, they begin over this fraction of the unknown on both sides.
///
/// Larger leaves where a function is smooth; smaller leaves fewer digits of what is computed within a tolerance.
pub const SLOPE_STEP_RELATIVE: f64 = 1e-2;

/// A derivative by differences is given where it is known to this fraction of itself, or of what would change the value
/// by as much over a length of the unknown.
///
/// Larger gives slopes of what has none; smaller refuses those of what is computed within a tolerance.
pub const SLOPE_RELATIVE: f64 = 1e-4;

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

/// Functions are zero where one more step of Newton leads by this share of the unknowns, or of the way from the start.
///
/// Larger takes for a root what only tends to zero; smaller refuses roots that several unknowns hardly tell.
pub const SYSTEM_STEP_RELATIVE: f64 = 1e-3;

/// Linear conditions are independent where this fraction of one is left beside the others.
///
/// Larger drops conditions that count; smaller divides by rounding.
pub const DEPENDENT_RELATIVE: f64 = 1e-13;

/// The share of the fall that its slope promises which a step must keep.
///
/// Larger shortens good steps; smaller takes steps that hardly lead down.
pub const ARMIJO: f64 = 1e-4;

/// A step of this fraction of the unknowns' sizes ends a search for a least value under conditions or within bounds.
///
/// Larger loses digits; smaller goes on among values that rounding makes equal.
pub const LEAST_STEP_RELATIVE: f64 = 1e-11;

/// A search for a root that ran out of steps is in a valley where more than this share of the squares at the start is
/// left; elsewhere it may be where functions only tend to zero.
///
/// Larger asks for more where a valley is left; smaller follows what only tends to zero until it is none.
pub(crate) const SQUARES_IN_VALLEY: f64 = 1e-12;

/// The share of squares that some steps of Newton leave near a root, and not where functions only tend to zero.
///
/// Larger follows what only tends to zero; smaller asks for more digits than there are.
pub(crate) const SQUARES_AT_ROOT: f64 = 1e-16;

/// How far from the end of such a search better places are looked for, as a fraction of the unknowns' sizes.
///
/// Larger misses narrow valleys beside it; smaller finds rounding.
pub const LEAST_PROBE_RELATIVE: f64 = 1e-3;

/// A function changes beside its least value where it does by this fraction of its value and of how it rises.
///
/// Larger takes poles for least values; smaller looks for poles among roundings.
pub const LEAST_GAIN_RELATIVE: f64 = 1e-9;

/// A way of which this fraction is left beside others is none of its own.
///
/// Larger loses ways that conditions leave free; smaller takes roundings for ways.
pub(crate) const LEAST_SLOPE_RELATIVE: f64 = 1e-11;

/// Steps over which the value falls by less than this fraction of the function's steepness at the start, and by less
/// than [`LEAST_STALL_SHARE`] of itself, end a search.
///
/// Larger ends in flat valleys; smaller goes down among the roundings of differences.
pub(crate) const LEAST_STALL_RELATIVE: f64 = 1e-14;

/// The share of a value by which it still falls to its least, beside [`LEAST_STALL_RELATIVE`].
///
/// Larger ends in valleys that are a billion times as steep across as along; smaller goes down among the roundings of
/// differences.
pub(crate) const LEAST_STALL_SHARE: f64 = 1e-5;

/// A way along which a function bends by less than this fraction of the most is looked along for lower places.
///
/// Larger looks along ways that clearly rise; smaller trusts a curvature that is known from places beside.
pub(crate) const LEAST_BEND_RELATIVE: f64 = 1e-3;

/// A condition holds a place where it keeps the function from a slope of this fraction of that at the start.
///
/// Larger looks along ways that leave it; smaller holds to conditions that only happen to be near.
pub(crate) const HOLDING_RELATIVE: f64 = 1e-6;

/// A search that has come so many times the unknowns' sizes away falls without bound.
///
/// Larger wanders further; smaller refuses what is far from its start.
pub const LEAST_FAR: f64 = 1e8;

/// An unknown that begins near zero counts by a size over which a function changes by this share of its value, or of its
/// growth along others.
///
/// Larger takes small unknowns for larger ones; smaller holds a search to steps that nothing tells of.
pub(crate) const LEAST_UNIT_SHARE: f64 = 1e-3;

/// The share of its fall over a part of the way there by which such a function falls over the next one, equal by powers
/// of the distance; one that falls by less may tend to a least value, and has none.
///
/// Larger says of a logarithm that it may tend to a value; smaller says of what nears its least value slowly that it
/// has no bound.
pub(crate) const FAR_SHRINKAGE: f64 = 0.9;

/// A condition that is broken by this fraction of its steepness at the start holds.
///
/// Larger lets answers break conditions; smaller refuses those that rounding breaks.
pub const CONDITION_RELATIVE: f64 = 1e-8;

/// Conditions that are broken by more than this fraction contradict one another where no step leads further.
///
/// Larger says of what contradicts itself a little that it was not settled; smaller says of what was not settled that
/// it contradicts itself.
pub(crate) const CONTRADICTION_RELATIVE: f64 = 1e-6;

/// How much a relaxed condition costs a step, beside the model's curvature.
///
/// Larger loses digits of steps; smaller gives conditions up that could hold.
pub(crate) const RELAXATION_WEIGHT: f64 = 1e4;

/// A part of this fraction of an interval that may hold a root, or none, or several, is not divided further.
///
/// Larger leaves roots that are near one another unproven; smaller divides around what only touches zero.
pub const PROOF_WIDTH_RELATIVE: f64 = 1e-10;

/// A part of this fraction of an interval along which a function is zero as far as rounding tells holds one root.
///
/// Larger takes a stretch of zeros for a root; smaller takes a root of high order for a stretch of zeros.
pub const OPEN_WIDTH_RELATIVE: f64 = 1e-4;

/// The error in each step of a trajectory is this share of the tolerance at first.
///
/// Larger tells of coarser trajectories that they are other ones; smaller takes more steps than need be.
pub(crate) const TRAJECTORY_FIRST_SHARE: f64 = 0.1;

/// By so much it becomes smaller each time: steps of half the width.
///
/// Larger tells two trajectories alike that are both off; smaller takes many steps at once.
pub(crate) const TRAJECTORY_REFINEMENT: f64 = 0.03;

/// A trajectory is known to this fraction of its size, if that is more than the tolerance.
///
/// Larger loses digits of large states; smaller asks for more than steps compute.
pub(crate) const TRAJECTORY_RELATIVE: f64 = 1e-12;

/// Steps of this fraction of the range are the shortest, a few times [`KNOT_RELATIVE`](super::KNOT_RELATIVE),
/// because knots are made of them.
///
/// Larger ends trajectories where they only bend; smaller makes knots that count as one.
pub(crate) const TRAJECTORY_STEP_RELATIVE: f64 = 1e-11;

/// The second derivative of a trajectory is the change of its rate over this share of a step.
///
/// Larger leaves its fourth derivative in the difference; smaller leaves rounding.
pub(crate) const TRAJECTORY_LOOK_SHARE: f64 = 1e-3;

/// Where in a turn an angle is, is known to this part of the turn, up to a million of them.
///
/// Larger makes bounds of sines wider than need be; smaller misses peaks by rounding.
pub(crate) const TURN_ROOM: f64 = 1e-9;

/// How near to a place at which an integrand may grow without bound it is asked first, as a share of the way there.
///
/// Larger looks where other terms still count; smaller sees rounding alone beside places that are not zero.
pub(crate) const INTEGRAL_NEAR_SHARE: f64 = 1e-6;

/// The share of a piece of an integral next to its end that counts as the end.
///
/// Larger takes bends inside for what happens at the end; smaller misses places a little inside of it.
pub(crate) const INTEGRAL_END_SHARE: f64 = 1e-3;
