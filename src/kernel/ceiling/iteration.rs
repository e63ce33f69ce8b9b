//! How many steps an iteration takes at most.
//!
//! Reaching one is an answer (the place come to is looked at again) or an error, never a hang. Fewer
//! miss what is slow to find; more take longer where there is nothing.

/// Halvings of the bracket of a border or root: all bits of an `f64` on 0..1.
pub(crate) const BISECTIONS: usize = 60;

/// Bisections towards the largest radius of a fillet, which is told with four digits; each rounds all corners.
pub(crate) const RADIUS_BISECTIONS: usize = 16;

/// Golden sections of a bracket towards the least value: all digits that a minimum has, and more.
pub(crate) const GOLDEN_SECTIONS: usize = 60;

/// Doublings of a step from the bottom of a valley to the edge of its floor: from the last bit to
/// the whole.
pub(crate) const FLOOR_DOUBLINGS: usize = 60;

/// Bisections for the ends of a stretch on which a sweep is folded: what is told of it has fewer
/// digits.
pub(crate) const FOLD_BISECTIONS: usize = 40;

/// Bisections towards the widths of steps that use up the last step as well; each walks through all
/// of them.
pub(crate) const WIDTH_BISECTIONS: usize = 30;

/// Halvings of a stretch of parameters, past the last bit of one.
pub(crate) const PARAMETER_HALVINGS: usize = 52;

/// Steps of Newton's method; from places that are clear it needs some five.
pub(crate) const NEWTON_STEPS: usize = 30;

/// Steps of Newton's method towards a place of two surfaces, or of a curve and a surface: the
/// tracer asks for thousands, and takes a shorter step where one is not found.
pub(crate) const CROSSING_STEPS: usize = 25;

/// Steps of Newton's method on a function, from where its stand-in or a seed is.
pub(crate) const POLISHING_STEPS: usize = 20;

/// Steps down to the nearest point of a patch; some five are enough where the squared distance is
/// curved.
pub(crate) const NEAREST_STEPS: usize = 40;

/// Halvings of a step that leads away from the nearest point.
pub(crate) const STEP_HALVINGS: usize = 12;

/// Whole steps one after the other that are to come nearer together, before a step is halved.
pub(crate) const WHOLE_STEPS: usize = 5;

/// Steps of Newton's method towards an umbilic, near which it may be slow.
pub(crate) const UMBILIC_STEPS: usize = 40;

/// Halvings of one of them.
pub(crate) const UMBILIC_STEP_HALVINGS: usize = 8;

/// Steps to the foot of a point of one edge on another, from a place that is near already.
pub(crate) const EDGE_FOOT_STEPS: usize = 6;

/// Steps to the foot of a point on a short cubic.
pub(crate) const CUBIC_FOOT_STEPS: usize = 4;

/// Steps to the point of a surface under a point of the other one.
pub(crate) const SURFACE_FOOT_STEPS: usize = 8;

/// Halvings of a step that leads beyond a surface.
pub(crate) const STEP_SHORTENINGS: usize = 4;

/// Steps of Newton's method towards a parameter by length, each halving the bracket where it fails
/// to do better.
pub(crate) const LENGTH_STEPS: usize = 100;

/// The same where the speed hardly changes.
pub(crate) const QUICK_LENGTH_STEPS: usize = 12;

/// Steps to the parameter of a length beyond the end; Newton's method takes five or so, a bracket
/// with a pole more.
pub(crate) const PROLONGATION_STEPS: usize = 1000;

/// Doublings of the last span's width before a length counts as out of reach: its knots are still
/// told apart from those of the curve. A single piece has none.
pub(crate) const PROLONGATION_DOUBLINGS: [i32; 2] = [30, 1000];

/// Doublings of the domain of a function that is prolonged until it is long enough.
pub(crate) const DOMAIN_DOUBLINGS: usize = 40;

/// Halvings of the last span that make its weights positive; more only where the denominator all
/// but vanishes.
pub(crate) const WEIGHT_HALVINGS: usize = 8;

/// Looks around the farthest place of a triangle, each halving the step where nothing beside it is
/// farther.
pub(crate) const TRIANGLE_CLIMB_STEPS: usize = 20;

/// Looks around the farthest place of a surface.
pub(crate) const SURFACE_CLIMB_STEPS: usize = 26;

/// Looks around the place where a surface bends most.
pub(crate) const BEND_CLIMB_STEPS: usize = 80;

/// Halvings after which a search for a maximum is content with its bound, and more for as many
/// pieces as it begins with.
pub(crate) const MAXIMUM_HALVINGS: usize = 2000;

/// Halvings of a piece with a singular place: all bits of an `f64`.
pub(crate) const SINGULAR_HALVINGS: usize = 120;

/// Halvings towards a place where the curve itself stands still.
pub(crate) const CUSP_HALVINGS: usize = 40;

/// Halvings of a span before its offset counts as having no direction there: their knots are still
/// told apart.
pub(crate) const OFFSET_HALVINGS: usize = 38;

/// Halvings of a piece until it goes by less than half a turn, which its control points show.
pub(crate) const HALF_TURN_HALVINGS: usize = 6;

/// Halvings of a piece whose length does not settle: enough for a cusp, whose error falls by four
/// with each.
pub(crate) const LENGTH_HALVINGS: usize = 40;

/// Halvings of a piece of a spline to follow a number along it.
pub(crate) const FOLLOWING_HALVINGS: usize = 8;

/// How often the points of one trial of a fit slide along it.
pub(crate) const FIT_CORRECTIONS: usize = 12;

/// Rounds of a fit, each of which divides every span that misses: this many divide any number.
pub(crate) const FIT_ROUNDS: usize = 64;

/// Steps of a fit in a row that gain nothing: the last ones.
pub(crate) const IDLE_STEPS: usize = 2;

/// How often the knots of one number of control points are spread anew.
pub(crate) const KNOT_SPREADS: usize = 3;

/// Attempts at a fit whose spans miss alike: halvings of a number of spans, and what spreads their knots.
pub(crate) const BALANCE_ROUNDS: usize = 16;

/// How often the points of one such attempt slide along it.
pub(crate) const BALANCED_SLIDES: usize = 6;

/// How often the curves of a network are made nearer to one another.
pub(crate) const GORDON_ROUNDS: usize = 3;

/// How often the spans of a curve of a network that miss are divided.
pub(crate) const REFIT_ROUNDS: usize = 24;

/// Numbers of knots, fewer each time, that are tried for a curve of a network.
pub(crate) const REFIT_TRIALS: usize = 7;

/// How often the fit of a curve of a network is made finer after its bound was too large.
pub(crate) const REFIT_BOUNDS: usize = 6;

/// Quarterings of a piece whose weights are not all positive: the denominator is, so that some
/// refinement of them is.
pub(crate) const WEIGHT_QUARTERINGS: usize = 12;

/// Steps by which a closed mesh is made flat, for each of its triangles.
pub(crate) const FLATTENING_STEPS: usize = 64;

/// Meshes that are tried for an angle: where normals turn faster between the places where they are
/// compared than there, the cells become smaller.
pub(crate) const TESSELLATION_ROUNDS: usize = 5;

/// Meshes that are tried for a surface in a plane until none of their triangles lies over others: the cells become half
/// as wide each time, as the chords of a narrow ring need it.
pub(crate) const UNFOLDING_ROUNDS: usize = 10;

/// How often the legs of borders that cross are divided: where borders run into one place along one tangent, each
/// round is some way nearer to that.
pub(crate) const CROSSING_ROUNDS: usize = 24;

/// Planes through edges that are tried where one cuts a solid within the tolerance of them.
pub(crate) const RIMS_BESIDE_PLANE: usize = 3;

/// Times that a search for the nearest place becomes content with less.
pub(crate) const NEAREST_LENIENCIES: usize = 4;

/// Halvings of a patch along one direction, to the last bits of its parameter.
pub(crate) const PATCH_HALVINGS: u8 = 48;

/// Halvings of an interval in which several roots cannot be told apart.
pub(crate) const ROOT_CLUSTER_HALVINGS: usize = 40;

/// Halvings of a cell with a crease: all bits of an `f64`.
pub(crate) const CREASE_HALVINGS: usize = 60;

/// Halvings of a piece after which a curve is left as it was found.
pub(crate) const CONIC_HALVINGS: usize = 8;

/// Halvings, along u and v in turns, after which a patch has not told the sign of something.
pub(crate) const SIGN_HALVINGS: usize = 4;

/// Halvings of the stretch between two samples of an intersection.
pub(crate) const SAMPLE_HALVINGS: usize = 24;

/// Halvings of the parts of a patch in which a fold is looked for.
pub(crate) const DEFECT_HALVINGS: usize = 40;

/// Slow steps towards an umbilic one after the other: they lead nowhere.
pub(crate) const SLOW_UMBILIC_STEPS: usize = 3;

/// Doublings of the number of steps by which a frame is moved along a path.
pub(crate) const FRAME_DOUBLINGS: usize = 7;

/// Halvings of a piece of an edge after which its certificate is given up.
pub(crate) const CERTIFICATE_HALVINGS: usize = 20;

/// Times that a box is made larger, because derivatives over it ask for more room.
pub(crate) const BOX_WIDENINGS: usize = 4;

/// Jumps that may follow one another between two steps: over either seam, and one more.
pub(crate) const SEAM_JUMPS: usize = 3;

/// Steps onto a knot of the surface.
pub(crate) const KNOT_STEPS: usize = 40;

/// Halvings of a piece of a curve beside a place where it stands still, where it has no tangent to look at.
pub(crate) const DUAL_HALVINGS: usize = 20;

/// Finer tolerances within which the edges of a solid are compared for its volume.
pub(crate) const VOLUME_REFINEMENTS: usize = 16;

/// Halvings of a piece of an arc of parameters that is written; beside a pole it turns within a small part.
pub(crate) const WRITTEN_HALVINGS: usize = 14;
