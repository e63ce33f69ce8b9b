//! Several runs at a time, in one process whose memory they share.

use std::sync::{PoisonError, RwLock};

use super::Report;

/// Lets scripts run side by side, and alone where memory ran out: where it ends then depends on
/// the script and on nothing beside it.
#[derive(Debug, Default)]
pub struct JobGate(RwLock<()>);

impl JobGate {
    /// What the script came to.
    pub fn run(&self, work: impl Fn() -> Report) -> Report {
        self.told(work, || {}, |report| report)
    }

    /// What is told of what the script came to. While one runs alone no other report is there, and before it
    /// whatever else is kept is given up by `make_room`.
    pub fn told<R>(
        &self,
        work: impl Fn() -> Report,
        make_room: impl FnOnce(),
        tell: impl FnOnce(Report) -> R,
    ) -> R {
        {
            let _beside = self.0.read().unwrap_or_else(PoisonError::into_inner);
            let report = work();
            if !report.is_out_of_memory() {
                return tell(report);
            }
        }
        let _alone = self.0.write().unwrap_or_else(PoisonError::into_inner);
        make_room();
        tell(work())
    }
}
