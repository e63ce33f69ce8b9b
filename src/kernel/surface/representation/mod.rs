//! What a surface is: of either kind, of functions, its parts, and where it jumps or has creases.

pub(super) mod any;
pub(super) mod crease;
pub(super) mod direction;
pub(super) mod edge;
pub(super) mod even;
pub(super) mod jumps;
pub(super) mod parametric;
pub(super) mod parts;
pub(super) mod power;
pub(super) mod translation;
