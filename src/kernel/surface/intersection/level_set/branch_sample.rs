//! A point of a branch.

use glam::DVec3;

/// A point of a branch, with the unit tangents before and behind it; zero where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BranchSample {
    pub(super) point: DVec3,
    pub(super) before: DVec3,
    pub(super) behind: DVec3,
}

impl BranchSample {
    pub(super) fn turned(self) -> Self {
        Self { point: self.point, before: -self.behind, behind: -self.before }
    }
}

/// The length of the arc between two near samples: that of a circle with this chord and turn.
pub(super) fn length_between(start: BranchSample, end: BranchSample) -> f64 {
    let turn = start.behind.distance_squared(end.before);
    start.point.distance(end.point) * (1.0 + turn / 24.0)
}
