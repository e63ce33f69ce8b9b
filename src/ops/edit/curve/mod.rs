//! Edits of curves: each makes a new curve.

pub(super) mod decompose;
pub(super) mod elevate;
pub(super) mod insert_knot;
pub(super) mod refine;
pub(super) mod reparametrize;
pub(super) mod reversed;
pub(super) mod split;
pub(super) mod trim;
