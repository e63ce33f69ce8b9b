//! What the answers of all addresses need.

use std::{
    path::PathBuf,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use super::hub::Hub;
use crate::session::Session;

/// What answers need.
#[derive(Debug)]
pub(super) struct Doors {
    pub(super) hub: Arc<Hub>,
    /// For questions; without a memory, and nobody stops it.
    pub(super) session: Session,
    pub(super) script: PathBuf,
    /// The folder for exported files.
    pub(super) out: PathBuf,
    /// One writes at a time.
    pub(super) writing: Mutex<()>,
}

impl Doors {
    /// Waits until nobody else writes.
    pub(super) fn alone(&self) -> MutexGuard<'_, ()> {
        self.writing.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
