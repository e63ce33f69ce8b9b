//! Points, derivatives and normals of a surface, at one place, at many, and on its curves.

pub(super) mod eval;
pub(super) mod evaluator;
pub(super) mod expansion;
pub(super) mod grid_eval;
pub(super) mod iso;
pub(super) mod near_pole;
pub(super) mod normal;
pub(super) mod pole;
pub(super) mod two_sided;
