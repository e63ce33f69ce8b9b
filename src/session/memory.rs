//! What an incremental session keeps from run to run.

use super::Session;
use crate::{eval::Memory, export::MeshMemory};

/// What is kept from run to run.
#[derive(Debug, Default)]
pub(super) struct SessionMemory {
    pub(super) results: Memory,
    pub(super) meshes: MeshMemory,
}

impl SessionMemory {
    /// Forgets all of it.
    pub(super) fn forget(&self) {
        self.results.forget();
        self.meshes.forget();
    }
}

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
