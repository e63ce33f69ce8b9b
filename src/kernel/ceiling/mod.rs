//! Ceilings of the kernel: the most that one curve, surface or fit may ask for.

mod iteration;
mod search;

pub(crate) use iteration::{
    BEND_CLIMB_STEPS, BISECTIONS, CROSSING_STEPS, CUBIC_FOOT_STEPS, DOMAIN_DOUBLINGS,
    EDGE_FOOT_STEPS, FLOOR_DOUBLINGS, FOLD_BISECTIONS, GOLDEN_SECTIONS, LENGTH_STEPS,
    NEAREST_STEPS, NEWTON_STEPS, PARAMETER_HALVINGS, POLISHING_STEPS, PROLONGATION_DOUBLINGS,
    PROLONGATION_STEPS, QUICK_LENGTH_STEPS, STEP_HALVINGS, STEP_SHORTENINGS, SURFACE_CLIMB_STEPS,
    SURFACE_FOOT_STEPS, TRIANGLE_CLIMB_STEPS, UMBILIC_STEP_HALVINGS, UMBILIC_STEPS,
    WEIGHT_HALVINGS, WIDTH_BISECTIONS,
};
pub(crate) use search::{
    ALL_ROOT_LOOKS, BRANCH_SAMPLES, CELLS, CONTACT_LOOKS, CONTACT_PLACES, CURVE_PAIR_WORK,
    DISTANT_PAIRS, FOLD_PARTS, HULL_PIECES, INTEGRAL_PIECES, LEAST_LOOKS, LEAST_SQUARES_STEPS,
    LEAST_STEPS, LENGTH_PIECES, MANY_CELLS, OFFSET_PATCHES, QUADRIC_WORK, ROOT_LOOKS, ROOT_STEPS,
    SHARED_STRETCHES, SIGN_PARTS, SURFACE_CUTS, SURFACE_PAIRS, TRACE_SAMPLES, TURN_CUTS,
};
pub use search::{PIECES, STAND_IN_CELLS};

/// Degree of a curve or surface. Above it binomial coefficients lose digits and nobody has a use.
pub const DEGREE: usize = 100;
/// Control points of one curve or surface.
pub const CONTROL_POINTS: usize = 10_000_000;
/// Points that a fit to a tolerance may look at, each time counted, to save control points: below a
/// second. Beyond it the tolerance is kept all the same.
pub const FIT_STEPS: usize = 4_000_000;
