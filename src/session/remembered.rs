//! What an incremental session remembers, for whoever has the session.

use super::Session;

impl Session {
    /// How many results an incremental session remembers.
    #[must_use]
    pub fn n_remembered(&self) -> usize {
        self.memory.as_ref().map_or(0, |memory| memory.results.len())
    }

    /// Forgets what an incremental session remembers; its next run evaluates all anew.
    #[cfg(feature = "cli")]
    pub(crate) fn forget(&self) {
        if let Some(memory) = &self.memory {
            memory.forget();
        }
    }
}
