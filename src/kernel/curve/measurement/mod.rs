//! What can be asked of a curve: length, shape at a place, nearest points, what stands out, continuity.

pub(super) mod analytic;
pub(super) mod arc_length;
pub(super) mod closest;
pub(super) mod continuity;
pub(super) mod deviation;
pub(super) mod direction;
pub(super) mod features;
pub(super) mod flat;
pub(super) mod global_queries;
pub(super) mod local;
pub(super) mod measure;
pub(super) mod planar;
pub(super) mod same_places;
pub(super) mod smooth;
