//! Curves from points and numbers: conics, chains of segments, curves beside others.

pub(super) mod arc;
pub(super) mod chain;
pub(super) mod circle;
pub(super) mod conic;
pub(super) mod hermite;
pub(super) mod offset;
pub(super) mod tangent;
pub(super) mod trajectory;
