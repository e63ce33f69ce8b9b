//! Where curves meet, and the polynomials that this takes.

pub(super) mod bend;
pub(super) mod intersect;
