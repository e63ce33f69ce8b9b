//! Where curves and surfaces meet, touch, and run together.

/// Ends of pieces of a line on a surface that are nearer than this fraction of the tolerance are one
/// place.
///
/// Larger joins lines that only pass one another; smaller leaves gaps where a patch ends, whose two
/// sides rounding tells apart.
pub const ONE_PLACE_SHARE: f64 = 1e-2;

/// Unit tangents of a line on a surface that differ by less than this make no corner.
///
/// Larger rounds off a slight kink; smaller keeps a triple knot at each end of a patch.
pub const CORNER_RELATIVE: f64 = 1e-4;

/// Part of the tolerance within which surfaces whose normals are parallel touch, and cross only
/// where they part beside that.
///
/// Larger joins curves that pass one another; smaller follows rounding, and needs splines in the
/// place of functions that are nearer still.
pub const CONTACT_SHARE: f64 = 1e-2;

/// Where two surfaces touch they part along two directions; along one in which they do so by less
/// than this fraction of the other they may touch further on.
///
/// Larger follows a line of contact where there is a crossing at a flat angle, and finds that there
/// is none; smaller takes a line of contact that rounding bends for a crossing.
pub const BEND_RELATIVE: f64 = 1e-3;

/// Part of the tolerance within which a spline stands in for a function where light is followed:
/// lines of light move with the normals, which are less near than the points.
///
/// Larger shifts the lines visibly; smaller asks for more patches than anybody sees.
pub const LIGHT_SHARE: f64 = 1e-3;

/// Part of the tolerance within which a place that Newton's method found is on both surfaces.
///
/// Larger uses up what the spline through such places may miss them by; smaller refuses places of
/// large surfaces, of which rounding leaves no more.
pub(crate) const MEETING_SHARE: f64 = 0.01;

/// Part of the tolerance within which parts are flat, and near enough to touch.
///
/// Larger takes parts that pass one another for a touch; smaller halves them down to rounding.
pub(crate) const FLAT_SHARE: f64 = 0.02;

/// How far cones of directions must be apart to be told to be so, radians: bounds of products have
/// their rounding.
///
/// Larger halves parts that are clear of one another; smaller trusts cones that touch.
pub(crate) const CONE_CLEARANCE: f64 = 0.05;

/// Where along an edge, as a fraction of it, a second place tells an area beside it from a line.
///
/// Larger misses short areas; smaller takes lines that cross there at a flat angle for areas.
pub(crate) const ALONG_EDGE: f64 = 0.03125;

/// Where it is looked beside an edge whether surfaces share an area, as fractions of the domain.
///
/// Larger misses narrow areas; smaller calls surfaces one that part at a flat angle.
pub(crate) const BESIDE_EDGE: [f64; 2] = [0.02, 0.04];

/// The first step along a curve in which surfaces cross, by their size.
///
/// Larger is shortened before it is taken; smaller samples what is nearly straight.
pub(crate) const FIRST_STEP_SHARE: f64 = 0.02;

/// The longest step along such a curve, by the size of the surfaces.
///
/// Larger steps over a curve beside this one; smaller samples what is nearly straight.
pub(crate) const LONGEST_STEP_SHARE: f64 = 0.05;

/// The shortest step along such a curve, by the tolerance; where that is too long it ends.
///
/// Larger gives up where a curve bends sharply; smaller walks on within what counts as one place.
pub(crate) const SHORTEST_STEP_SHARE: f64 = 0.1;

/// The least part of a step beyond a surface that tells anything of what is before its end.
///
/// Larger learns nothing near an edge; smaller compares roundings.
pub(crate) const LEAST_STEP_SHARE: f64 = 0.01;

/// Surfaces that are one over this fraction of their size share an area.
///
/// Larger misses small areas; smaller takes a touch of high order for one.
pub(crate) const AREA_REACH: f64 = 0.02;

/// Meetings of two curves that are one place in space are one where their parameters, too, are nearer
/// than this fraction of the domain.
///
/// Larger makes one of the two meetings at a loop; smaller tells a flat meeting twice.
pub(crate) const ONE_MEETING_SHARE: f64 = 0.01;

/// How much further than on a patch its polynomials may reach beyond it, as a fraction of its least weight,
/// for a piece of a curve to be compared with that patch alone.
///
/// Larger trusts polynomials where they no longer count; smaller halves pieces that run along a knot.
pub(crate) const OVERSHOOT_RELATIVE: f64 = 0.1;

/// Part of the tolerance within which the curve of an edge and its parameters are fitted: what is proven
/// of them needs some room of its own.
///
/// Larger leaves less of the tolerance to the proof; smaller takes more pieces.
pub(crate) const EDGE_SHARE: f64 = 0.125;

/// Part of the tolerance within which a curve must be a circle for its crossings to be told in a closed form.
///
/// Larger lets a curve cross a circle more often than circles do; smaller leaves arcs with rounding to the search.
pub(crate) const CIRCLE_SHARE: f64 = 0.0078125;

/// The part of the square of its radius within which a place of a circle is at a joint of two pieces, and the angle by
/// which a whole turn is one.
///
/// Larger looks at a joint's wrong side; smaller finds a place on neither.
pub(crate) const CIRCLE_JOINT_RELATIVE: f64 = 1e-9;

/// The fraction of a piece of an edge within which a ray begins in its end instead.
///
/// Larger moves more rays; smaller cuts off parts that are rounding.
pub(crate) const RAY_JOINT_SHARE: f64 = 1e-6;

/// How near splines along plane rims are to these, as a fraction of the size of a face: the areas within differ by no more
/// than that times their border.
///
/// Larger shows in areas and volumes; smaller takes more pieces, as its sixth root.
pub(crate) const RIM_RELATIVE: f64 = 1e-10;

/// Part of the tolerance within which the end of a curve is on the border of a surface.
///
/// Larger moves ends that stop short of a border; smaller leaves a crumb between both.
pub(crate) const BORDER_END_SHARE: f64 = 0.1;

/// The shortest piece of a curve that is lifted to the parameters of surfaces, as a fraction of its domain.
///
/// Larger gives up beside a junction; smaller halves where parameters no longer tell places apart.
pub(crate) const SHORTEST_EDGE_PIECE: f64 = 1e-9;

/// The sine of the angle between normals below which surfaces have no place across a curve, but each its
/// nearest one.
///
/// Larger takes nearest places where surfaces cross; smaller asks Newton's method for what rounding decides.
pub(crate) const LEAST_CROSSING_SINE: f64 = 1e-7;

/// How far beside a pole parameters tell what they come to in it, as a fraction of the curve's domain.
///
/// Larger misses how they turn; smaller divides by what rounding leaves.
pub(crate) const BESIDE_POLE: f64 = 1e-5;

/// A step in a plane of parameters of this part of its size may be a jump over a seam or through a pole.
///
/// Larger takes a jump for a bend; smaller bisects where a curve only runs fast.
pub(crate) const JUMP_SHARE: f64 = 0.05;

/// Even steps beside a pole, as a part of a part of a curve, from three of which a parameter is extrapolated to it.
///
/// Larger takes the bends of the parameter with it; smaller divides rounding by the distance from the pole.
pub(crate) const POLE_STEP: f64 = 0.02;

/// Part of its size that arcs in a plane of parameters may be away from what they are solved for.
///
/// Larger gives areas of cut faces fewer digits; smaller halves pieces that rounding keeps apart.
pub(crate) const PULL_RELATIVE: f64 = 1e-13;

/// The same as a part of the tolerance, at most.
///
/// Larger lets arcs use up the tolerance; smaller takes more pieces of what is tiny.
pub(crate) const PULL_SHARE: f64 = 1e-3;

/// How much of a length in the plane of parameters that in space is at least, where a descent to a foot is
/// followed.
///
/// Larger asks the whole surface where that is not needed; smaller follows descents that hardly move beside a pole.
pub(crate) const SLOWEST_SHARE: f64 = 0.0625;

/// An arc in a plane of parameters that is no longer than so many tolerances, and for which no polynomial is
/// found, is straight.
///
/// Larger gives areas beside junctions fewer digits; smaller follows what rounding leaves of places there.
pub(crate) const STRAIGHT_REACH: f64 = 32.0;

/// Part of its largest coordinate that a curve on a surface may be away from the conic that it is.
///
/// Larger takes a curve for a conic that is none; smaller approximates conics, whose arcs of parameters have
/// rounding of their own.
pub(crate) const CONIC_RELATIVE: f64 = 2e-12;

/// The least height of a conic over its chord, as a part of that.
///
/// Larger approximates flat arcs; smaller computes weights of rounding.
pub(crate) const CONIC_SHARE: f64 = 1e-6;

/// The shortest part of an arc of parameters that tells whether it is a conic in space, as a fraction of its domain.
///
/// Larger misses conics beside a corner; smaller asks pieces that are all but straight.
pub(crate) const CONIC_PART: f64 = 0.015625;

/// The least quotient of the squared radii of an ellipse that is made about its centre.
///
/// Larger makes pieces between tangents of what is round; smaller computes with a centre that is far away.
pub(crate) const ROUNDNESS_RELATIVE: f64 = 1e-3;

/// Curves that run together part where they are apart by this fraction of the tolerance, if they are nearer before.
///
/// Larger lets borders change over a long way behind the place where they part; smaller takes rounding for parting.
pub(crate) const PARTING_SHARE: f64 = 1e-7;

/// The same in last bits of a coordinate, where that is more.
pub(crate) const PARTING_ROUNDINGS: f64 = 16.0;

/// What curves that part in one direction are apart falls below this fraction at half of the way: a quarter, and less
/// where they bend alike.
///
/// Larger takes curves for one that are near one another by chance; smaller misses those that rounding bends.
pub(crate) const QUARTER_SLACK: f64 = 0.35;

/// Tolerances within which what comes back to a vertex of borders has not left it.
///
/// Larger takes short edges away; smaller keeps what rounding leaves of two vertices that are one.
pub(crate) const VERTEX_REACH: f64 = 4.0;

/// A cut that fails is told to be too thin where an edge runs along the plane within so many tolerances of it.
///
/// Larger blames slivers for what else may fail; smaller tells open rims where the sides of slivers are one.
pub(crate) const THIN_CUT: f64 = 8.0;

/// A cut that fails is told to pass too near where a face narrows to a point within so many tolerances of the plane:
/// there its border bends within less than what it may be away.
///
/// Larger blames tips for what else may fail; smaller tells that no spline is near the border.
pub(crate) const TIP_CUT: f64 = 64.0;

/// How far beside a line of parameters that is a point the ways out of it are looked at, as a fraction of the domain.
///
/// Larger looks where the surface bends; smaller differences rounding.
pub(crate) const PINCH_STEP: f64 = 1e-3;

/// Unit vectors of such ways are one where they are nearer than this.
///
/// Larger takes sides that only touch there for one disc; smaller parts a disc that bends.
pub(crate) const PINCH_ALIKE: f64 = 0.02;

/// The most that rounding of points is taken to turn normals of small parts by, radians.
///
/// Larger takes surfaces that cross for parallel ones; smaller takes parallel ones far from the origin for crossing.
pub(crate) const NORMAL_ROUNDING: f64 = 1e-8;

/// Faces bend alike along an edge where their normal curvatures differ by this part of the larger one at most: edges
/// that are splines are no nearer to the true ones.
///
/// Larger takes for one bend what a stripe of light tells apart; smaller tells apart what is one but for the edge.
pub(crate) const BEND_AGREES: f64 = 1e-6;

/// What is nearer to the axis of a surface than this part of its distance from the middle has no angle about it.
///
/// Larger takes the angle of what is beside a pole from elsewhere; smaller takes it from rounding.
pub(crate) const AXIS_RELATIVE: f64 = 1e-9;

/// Part of the tolerance within which polynomials that stand for an arc of parameters in a file keep to it.
///
/// Larger changes areas of faces that are read back; smaller takes more pieces.
pub(crate) const WRITTEN_SHARE: f64 = 1e-4;

/// The fraction of a piece of a curve of parameters, near its start, at which it is compared with its arc first.
///
/// Larger sees later how an arc leaves a pole; smaller looks where both agree whatever they do.
pub(crate) const WRITTEN_LOOK: f64 = 0.02;

/// The fraction of a domain over which the sense of an angle is told, that may be anything by full turns.
///
/// Larger could be half a turn of what goes around several times; smaller looks at rounding.
pub(crate) const SENSE_LOOK: f64 = 1.0 / 64.0;

/// The sine of the angle at which surfaces about one axis cross clearly, so that the circles of their meridians are all
/// that they share.
///
/// Larger searches where the closed form would do; smaller takes the closed form where what touches is told as such.
pub(crate) const COAXIAL_SINE: f64 = 1e-2;

/// Part of the tolerance within which the curves of cylinders and cones that all but go around one sphere keep to the
/// conics of those that do.
///
/// Larger cuts at junctions what passes them by; smaller searches where rounding alone is in the way.
pub(crate) const INSCRIBED_SHARE: f64 = 0.5;

/// How far ahead of its start, as a part of a curve, is looked which way its parameters go.
///
/// Larger sees where it turns back; smaller does not tell rounding from a way.
pub(crate) const FIRST_LOOK: f64 = 1e-3;
