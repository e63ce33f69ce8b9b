//! What an incremental session keeps from run to run.

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
