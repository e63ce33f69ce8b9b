//! What curves are and where they bend: joints, cusps, circles, frames along them.

/// Derivatives on both sides of a knot are one where they differ by less than this fraction of the
/// largest along it.
///
/// Larger smooths a slight crease; smaller finds one where rounding is, at every full knot.
pub const SMOOTH_RELATIVE: f64 = 1e-9;

/// The distance of an offset times the curvature counts as one within this: a cusp.
///
/// Larger reports cusps where the offset is merely tight; smaller misses those where the curvature
/// peaks at just that value.
pub const CUSP_SLACK: f64 = 1e-9;

/// Beside a place where an offset turns back, its two sides run together for a while: this share of
/// the stretch between two such places is not asked where the offset crosses itself.
///
/// Larger misses crossings close to cusps; smaller takes the cusp for a crossing, and long.
pub const TURN_MARGIN: f64 = 1e-3;

/// An arc whose points keep their distance from the centre to this fraction is circular.
///
/// Larger takes a flat ellipse for a circle; smaller takes none for one after a rotation.
pub const ROUND_RELATIVE: f64 = 1e-13;

/// A spline is a line, circle, plane, cylinder, cone, sphere or torus when it is nowhere further from
/// it than this fraction of its largest coordinate.
///
/// Larger writes what somebody moved on purpose as what it is not; smaller takes none for one after
/// it was turned, elevated and given knots.
pub const ANALYTIC_RELATIVE: f64 = 1e-13;

/// Two ways to pair the points of two curves count as equally near when the sums over their
/// products differ by less than this fraction.
///
/// Larger leaves a section that runs against its neighbour; smaller turns sections around whose
/// two directions are one to rounding.
pub const TURN_RELATIVE: f64 = 1e-6;

/// The way from one closed section to the next tells on which side of both it leads when its angle to the
/// planes of both has at least this sine.
///
/// Larger compares sections that bend away from one another by their shapes alone, which take a bend of more
/// than a right angle for a section that runs backwards; smaller hears a way that lies in the planes.
pub const CLEAR_WAY: f64 = 0.2;

/// Taking out a knot of a joint moves nothing by more than this part of the tolerance, however large the coordinates are.
///
/// Larger moves pieces in map coordinates visibly beside the tolerance; smaller leaves knots there that rounding alone
/// holds.
pub(crate) const JOINT_REMOVAL_SHARE: f64 = 1.0 / 16.0;

/// The same part of the accuracy of an offset, at whose joints up to five knots go.
///
/// Larger leaves less of the accuracy to the pieces; smaller leaves knots at smooth joints.
pub(crate) const OFFSET_JOINT_SHARE: f64 = 1.0 / 64.0;

/// A frame that turns by more than this at one place of its path jumps there, radians.
///
/// Larger leaves jumps to knots that no number of them comes near to; smaller takes the rounding of second
/// derivatives at the knots of a path for jumps.
pub(crate) const FRAME_JUMP: f64 = 1e-6;

/// Steps along a path are halved until the frame at its end turns by less than this, radians.
///
/// Larger leaves a twist that a long section shows; smaller asks for more steps than rounding
/// allows.
pub const TURN_ACCURACY: f64 = 1e-10;

/// The least squared cosine of half a corner's turn that keeps the corner of an offset: a spike of
/// four times the distance. Beyond it the corner is rounded.
///
/// Larger rounds off corners of an eighth of a turn; smaller makes spikes that no paper holds.
pub(crate) const LEAST_MITRE: f64 = 1.0 / 16.0;

/// The shortest reach, as a fraction of the domain, of a function that winds many times.
///
/// Larger looks over several windings at once; smaller differences rounding.
pub(crate) const SHORTEST_REACH: f64 = 1.0 / 1024.0;

/// The tangents of a part of a curve are looked at as one arc of lines where their normals are within this of the
/// middle one, radians.
///
/// Larger brings weights of lines near zero; smaller makes more parts of a curve than are needed.
pub(crate) const DUAL_CONE: f64 = 0.26;

/// Lines of two curves are one, to be made exact, where their slopes and heights are as near as this, in a plane of
/// the size 1.
///
/// Larger finds more that is no contact, which costs time; smaller loses lines that touch twice by rounding.
pub(crate) const DUAL_MEETING: f64 = 1e-9;

/// A line touches a curve where the sine of their angle is at most this; an arc, where its centre is as near to where
/// it should be, in a plane of the size 1.
///
/// Larger takes for a contact what only comes near; smaller loses those at which a curve bends as its tangent does.
pub(crate) const TANGENT_ACCURACY: f64 = 1e-9;

/// Pieces of arcs that are further from their chord than this share of their size are halved before it is told which
/// come near one another.
///
/// Larger takes for near what lies around one another; smaller makes more pieces than that saves.
pub(crate) const BENT_SHARE: f64 = 0.05;
