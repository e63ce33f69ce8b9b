//! What a curve is: of either kind, of functions, its parts, and where it jumps.

pub(super) mod any;
mod far;
pub(super) mod function;
pub(super) mod jumps;
pub(super) mod parametric;
pub(crate) mod part;
pub(super) mod parts;
pub(super) mod units;
