//! Surfaces from curves and numbers: ruled, revolved, within boundaries, beside others, primitives.

pub(super) mod coons;
pub(super) mod offset;
pub(super) mod revolve;
pub(super) mod round;
pub(super) mod ruled;
pub(super) mod sum;
