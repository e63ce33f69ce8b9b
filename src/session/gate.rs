//! Several runs at a time, in one process whose memory they share.

use std::sync::{PoisonError, RwLock};

use super::Report;

/// Lets scripts run side by side, and alone where memory ran out: where it ends then depends on
/// the script and on nothing beside it.
#[derive(Debug, Default)]
pub(crate) struct JobGate(RwLock<()>);

impl JobGate {
    /// What the script came to.
    pub(crate) fn run(&self, work: impl Fn() -> Report) -> Report {
        {
            let _beside = self.0.read().unwrap_or_else(PoisonError::into_inner);
            let report = work();
            if !report.is_out_of_memory() {
                return report;
            }
        }
        let _alone = self.0.write().unwrap_or_else(PoisonError::into_inner);
        work()
    }
}
