//! Work that goes no further: memory or steps ran out, or nobody waits for it any more.

use super::GeomError;
use crate::work;

impl GeomError {
    /// Counts steps of work.
    ///
    /// # Errors
    /// [`Self::Ended`] where it is to go no further.
    pub(crate) fn go_on(n_steps: usize) -> Result<(), Self> {
        if work::goes_on(n_steps as u64) { Ok(()) } else { Err(Self::Ended) }
    }
}
