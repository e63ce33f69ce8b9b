//! Every tolerance of the kernel, by themes: the only place where a small number may be written.
//!
//! Algorithms that answer to the user's idea of "the same place" take a [`Tolerance`] from their
//! caller and never pick one. The named constants below are different in kind: they say where the
//! digits of an `f64` end, so they are fixed, and all are ratios without a unit.

mod curve;
mod drawing;
mod fit;
mod function;
mod intersection;
mod least;
mod measure;
mod mesh;
mod number;
mod parameters;
mod rounding;
mod surface;

pub use curve::{
    ANALYTIC_RELATIVE, CLEAR_WAY, CUSP_SLACK, ROUND_RELATIVE, SMOOTH_RELATIVE, TURN_ACCURACY,
    TURN_MARGIN, TURN_RELATIVE,
};
pub(crate) use curve::{
    BENT_SHARE, DUAL_CONE, DUAL_MEETING, FRAME_JUMP, JOINT_REMOVAL_SHARE, LEAST_MITRE,
    OFFSET_JOINT_SHARE, SHORTEST_REACH, TANGENT_ACCURACY,
};
pub use drawing::{
    DRAWING_DIGIT, HAIRLINE_WIDTH, HIDDEN_RELATIVE, PATH_RELATIVE, PATH_ROUNDING,
    SEEN_LINE_RELATIVE,
};
pub(crate) use fit::{
    BALANCED_SLIDE_RELATIVE, FIRST_REMOVAL_SHARE, LEAST_ERROR_SHARE, LEAST_KNOT_DENSITY,
    SPREADING_SPARE, UNCHANGED_SHARE,
};
pub use fit::{RANK_RELATIVE, SLIDE_RELATIVE};
pub(crate) use function::SUSPICIOUS_CELL_RELATIVE;
pub use function::{
    BOX_RELATIVE, FOLLOWED_RELATIVE, SINGULAR_RELATIVE, STAND_IN_RELATIVE, SUSPICIOUS_RELATIVE,
    UNBOUNDED_RELATIVE,
};
pub(crate) use intersection::{
    ALONG_EDGE, AREA_REACH, AXIS_RELATIVE, BEND_AGREES, BESIDE_EDGE, BESIDE_POLE, BORDER_END_SHARE,
    CIRCLE_JOINT_RELATIVE, CIRCLE_SHARE, COAXIAL_SINE, CONE_CLEARANCE, CONIC_PART, CONIC_RELATIVE,
    CONIC_SHARE, EDGE_SHARE, FIRST_LOOK, FIRST_STEP_SHARE, FLAT_SHARE, INSCRIBED_SHARE, JUMP_SHARE,
    LEAST_CROSSING_SINE, LEAST_STEP_SHARE, LONGEST_STEP_SHARE, MEETING_SHARE, NORMAL_ROUNDING,
    ONE_MEETING_SHARE, OVERSHOOT_RELATIVE, PARTING_ROUNDINGS, PARTING_SHARE, PINCH_ALIKE,
    PINCH_STEP, POLE_STEP, PULL_RELATIVE, PULL_SHARE, QUARTER_SLACK, RAY_JOINT_SHARE, RIM_RELATIVE,
    ROUNDNESS_RELATIVE, SENSE_LOOK, SHORTEST_EDGE_PIECE, SHORTEST_STEP_SHARE, SLOWEST_SHARE,
    STRAIGHT_REACH, THIN_CUT, TIP_CUT, VERTEX_REACH, WRITTEN_LOOK, WRITTEN_SHARE,
};
pub use intersection::{
    BEND_RELATIVE, CONTACT_SHARE, CORNER_RELATIVE, LIGHT_SHARE, ONE_PLACE_SHARE,
};
pub(crate) use least::{
    CURVATURE_SPREAD, KINK_BEND_MOST, KINK_BESIDE_RELATIVE, KINK_DIFFERENCE_RELATIVE, KINK_FARTHER,
    KINK_FARTHEST_RELATIVE, KINK_HULL_BENDS, KINK_HULL_DIFFERENCE_RELATIVE, KINK_HULL_REACHES,
    KINK_HULL_RELATIVE, KINK_PROMISE_RELATIVE, KINK_ROUNDINGS, KINK_SHARE_MOST, KINK_SIDE_RELATIVE,
    KINK_SLOPE_RELATIVE, KINK_UNLIKE_RELATIVE, LEAST_FALL_REACH, LEAST_FALL_RELATIVE,
    LEAST_LEVEL_RELATIVE, LEAST_LOWER_RELATIVE, LEAST_NEARNESS, LEAST_NEWTON_BEND,
    LEAST_NEWTON_REACH, LEVEL_APPROACH, LEVEL_SHARE, PLANE_RELATIVE,
};
pub use measure::{
    ACCURACY_WORTH_HAVING, ACCURACY_WORTH_TELLING, AFFINE_RELATIVE, APART_RELATIVE,
    APART_STEP_RELATIVE, BESIDE_CREASE, GRADIENT_RELATIVE, LENGTH_RELATIVE, NEAREST_RELATIVE,
    QUADRATURE_RELATIVE,
};
pub(crate) use measure::{
    EXTREMUM_RELATIVE, FAR_SHARE, FEW_DIGITS_SHARE, FINER_FACTOR, GAP_FADES, GAP_RELATIVE,
    GAP_WIDTH_RELATIVE, OFFSET_RELATIVE, OFFSET_SHARE, ROUND_SKEW, STRAIGHT_SLACK,
    WHOLE_TURN_SLACK,
};
pub use mesh::{
    BOOLEAN_RELATIVE, BORDER_SHARE, DEFAULT_CHORD_RELATIVE, FLAT_SLOPE, LEAN_SHARE, LEAST_HEIGHT,
    UNIT_SLACK, VIEW_ANGLE, WELD_SHARE,
};
pub(crate) use mesh::{
    CELL_HAIR, CLEAR_SINE, CROSSING_CHORD_RELATIVE, END_LOOK, FOLD_SINE, LEG_MARGIN, LEG_SHARE,
    OVERLAID_COSINE, OVERLAID_SHARE, PARALLEL_SINE, WEIGHT_SLACK,
};
pub use number::{
    ARMIJO, BEYOND_END_RELATIVE, CONDITION_RELATIVE, DAMPING_FIRST, DEPENDENT_RELATIVE,
    DIFFERENCE_RELATIVE, INTEGRAL_RELATIVE, INTEGRAL_WIDTH_RELATIVE, JUMP_KEEPS, JUMP_LOOK,
    LEAST_FAR, LEAST_GAIN_RELATIVE, LEAST_PLACE_RELATIVE, LEAST_PROBE_RELATIVE,
    LEAST_STEP_RELATIVE, LIMIT_WITHOUT_UNIT, OPEN_WIDTH_RELATIVE, PROOF_WIDTH_RELATIVE,
    ROOT_BESIDE_RELATIVE, ROOT_JUMP_RELATIVE, ROOT_RELATIVE, ROOT_TOUCH_RELATIVE, SLOPE_RELATIVE,
    SLOPE_STEP_RELATIVE, STEP_REST_RELATIVE, SWITCH_ALIKE_RELATIVE, SWITCH_SPEED_RELATIVE,
    SWITCH_STEP_RELATIVE, SWITCH_STEP_SHRINK, SYSTEM_ROOT_RELATIVE, SYSTEM_STEP_RELATIVE,
};
pub(crate) use number::{
    CONTRADICTION_RELATIVE, FAR_SHRINKAGE, HOLDING_RELATIVE, INTEGRAL_END_SHARE,
    INTEGRAL_NEAR_SHARE, INTEGRAL_NOISE_RELATIVE, INTEGRAL_SEEN_RELATIVE,
    INTEGRAL_SUSPECT_RELATIVE, INTEGRAL_TAIL_LEAST, LEAST_BEND_RELATIVE, LEAST_SLOPE_RELATIVE,
    LEAST_STALL_RELATIVE, LEAST_STALL_SHARE, LEAST_UNIT_SHARE, POLE_FALL_RELATIVE, POLE_NEAREST,
    POLE_SHRINKAGE, RELAXATION_WEIGHT, SQUARES_AT_ROOT, SQUARES_IN_VALLEY, STEEP_POWER_KEEPS,
    TRAJECTORY_FIRST_SHARE, TRAJECTORY_LOOK_SHARE, TRAJECTORY_REFINEMENT, TRAJECTORY_RELATIVE,
    TRAJECTORY_STEP_RELATIVE, TURN_ROOM,
};
pub use parameters::{
    KNOT_CLUSTER_RELATIVE, KNOT_RELATIVE, PARAMETER_RELATIVE, PLACE_RELATIVE, SIDE_STEP,
};
pub use rounding::{
    BOUNDS_RELATIVE, EXACT_RELATIVE, LAST_BIT, SIGN_RELATIVE, STEP_RELATIVE, TOUCH_RELATIVE,
    VANISHING_RELATIVE, WEIGHT_RELATIVE,
};
pub(crate) use rounding::{KNOT_DERIVATIVE_ROUNDINGS, SHOWN_RELATIVE};
pub(crate) use surface::{CLEAR_SHAPE, INSIDE_SHARE, NEAR_POLE_REST, NEAR_POLE_SHARE};
pub use surface::{
    FLAT_SIZES, NORMAL_AGREEMENT, NORMAL_STEP, SHADE_RELATIVE, UMBILIC_CIRCLE, UMBILIC_CLEAR,
    UMBILIC_DIFFERENCE, UMBILIC_SHARE,
};

/// The precision that a computation is asked to reach.
///
/// ```
/// use virote_kernel::Tolerance;
///
/// let rough = Tolerance::DEFAULT.with_distance(0.5);
/// assert_eq!(rough.distance_for(1000.0), 0.5);
/// // Never more than a thousandth of what is looked at.
/// assert_eq!(rough.distance_for(1.0), 0.001);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Points closer than this coincide; model units. Larger merges details of the model; smaller
    /// finds gaps in joints that only rounding has opened.
    pub distance: f64,
    /// Directions closer than this are parallel; radians. Larger calls a slow bend straight;
    /// smaller calls two computed copies of one direction different.
    pub angle: f64,
}

impl Tolerance {
    /// Suits models measured in millimetres, up to some metres.
    pub const DEFAULT: Self = Self { distance: 1e-6, angle: 1e-9 };

    /// The distance for geometry of a size: never more than [`DETAIL_RELATIVE`] of it.
    #[must_use]
    pub fn distance_for(self, size: f64) -> f64 {
        self.distance.min(DETAIL_RELATIVE * size)
    }

    /// The same angle with another distance.
    #[must_use]
    pub const fn with_distance(self, distance: f64) -> Self {
        Self { distance, ..self }
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The document's tolerance counts up to this fraction of the size of what is looked at.
///
/// Larger calls a curve of a few micrometres a closed one, and straight; smaller overrules a
/// tolerance that somebody chose for rough work.
pub const DETAIL_RELATIVE: f64 = 1e-3;

/// Numbers of two runs of a script that differ by less than this, as a fraction of the larger one or
/// of 1, are one result; whoever keeps results may say otherwise.
///
/// Larger lets a change of the geometry pass unseen; smaller tells of roundings that come out
/// otherwise where an algorithm takes its steps in another order.
pub const SAME_RESULT: f64 = 1e-9;
