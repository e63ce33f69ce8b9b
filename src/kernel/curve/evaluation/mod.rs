//! Points and derivatives of a curve, at one parameter and at many.

pub(super) mod eval;
pub(super) mod evaluator;
pub(super) mod series;
