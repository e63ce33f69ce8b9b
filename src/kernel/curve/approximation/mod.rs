//! Splines near functions.

pub(super) mod hermite_approximation;
