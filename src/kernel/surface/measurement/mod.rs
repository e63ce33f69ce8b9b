//! What can be asked of a surface: shape at a place, area, volume, distance, defects, continuity.

pub(super) mod border;
pub(super) mod closest;
pub(super) mod defects;
pub(super) mod deviation;
pub(super) mod everywhere;
pub(super) mod function_jumps;
pub(super) mod joint;
pub(super) mod local;
pub(super) mod mass;
pub(super) mod quadrature;
mod quadrature_cell;
pub(super) mod shape;
pub(super) mod shell;
pub(super) mod umbilics;
