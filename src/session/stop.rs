//! What ends a run from outside: a switch, and the measure of memory.

use std::sync::atomic::AtomicBool;

use super::Session;

/// The switch of a session that nobody stops.
pub(super) static NEVER: AtomicBool = AtomicBool::new(false);

impl Session {
    /// The same with a measure of the memory that is held, in bytes, for the ceiling on it;
    /// without one that ceiling is not kept.
    #[must_use]
    pub fn measured(self, held: fn() -> usize) -> Self {
        Self { held, ..self }
    }

    /// The same with a switch: where it is set, a run under way ends at its next step with an error.
    #[must_use]
    pub fn stopped_by(self, stop: &'static AtomicBool) -> Self {
        Self { stop, ..self }
    }
}
