//! Splines near functions.

pub(super) mod lines;
pub(super) mod nurbs_approximation;
