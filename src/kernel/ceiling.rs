//! Ceilings of the kernel: the most that one curve, surface or fit may ask for.

/// Degree of a curve or surface. Above it binomial coefficients lose digits and nobody has a use.
pub const DEGREE: usize = 100;
/// Control points of one curve or surface.
pub const CONTROL_POINTS: usize = 10_000_000;
/// Points that a fit to a tolerance may look at, each time counted, to save control points: below a
/// second. Beyond it the tolerance is kept all the same.
pub const FIT_STEPS: usize = 4_000_000;

/// Halvings of the bracket of a border or root: all bits of an `f64` on 0..1.
pub(crate) const BISECTIONS: usize = 60;
