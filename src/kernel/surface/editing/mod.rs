//! The same surface in another form, and surfaces cut, joined and continued.

pub(super) mod compatible;
pub(super) mod continuation;
pub(super) mod edit;
pub(super) mod join;
pub(super) mod rearrange;
