//! What evaluation has used up, counted over all who ask one another on a thread.

use std::cell::Cell;

/// What evaluation has used up on its way to a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Meter {
    pub(super) n_calls: usize,
    pub(super) depth: usize,
    pub(super) steps: u64,
}

thread_local! {
    /// What the machine that waits for a built-in on this thread has used up.
    pub(super) static USED: Cell<Meter> = const { Cell::new(Meter { n_calls: 0, depth: 0, steps: 0 }) };
}

impl Meter {
    /// Runs something that may ask functions of the script, which go on counting from here; what
    /// has been used up then.
    pub(super) fn lend<T>(self, run: impl FnOnce() -> T) -> (T, Self) {
        let before = USED.replace(self);
        let result = run();
        (result, USED.replace(before))
    }
}
