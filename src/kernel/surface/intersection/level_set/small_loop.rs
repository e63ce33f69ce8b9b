//! Small closed curves in which two surfaces cross that all but touch, as large as the root of how far they reach
//! through one another.

use super::{
    sample::BranchSamples,
    surface_pair::SurfacePair,
    tangential_contact::{LOOP_SLACK, LoopAround},
    trace::CurveEnds,
};

impl SurfacePair<'_> {
    /// A closed curve about a place, followed once around; none where it does not close.
    pub(super) fn small_loop(
        &self,
        around: &LoopAround,
        ends: &CurveEnds,
    ) -> Option<BranchSamples> {
        let place = self.common(around.start, around.reach.widths)?;
        let away = place.point.distance(around.reach.point) / around.half_axis;
        let is_beside = LOOP_SLACK.recip() <= away && away <= LOOP_SLACK;
        let run = is_beside.then(|| self.run(place, ends))?;
        (run.start() == run.end() && self.tolerance < run.length()).then_some(run)
    }
}
