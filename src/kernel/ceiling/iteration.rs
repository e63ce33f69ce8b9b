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
