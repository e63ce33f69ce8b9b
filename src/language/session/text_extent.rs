//! What of a text a session runs.

use std::sync::Arc;

use crate::eval::{CacheRun, Defined};

/// What of a text a session runs, and so what it remembers afterwards.
#[derive(Clone, Debug)]
pub(super) enum TextExtent {
    /// All of it: what is not used is forgotten.
    Whole,
    /// A part beside runs of all of it, which use these definitions: nothing is remembered.
    Aside(Arc<[Defined]>),
    /// A part that changed, which uses these definitions of the rest: what it gave is remembered too.
    Joining(Arc<[Defined]>),
}

impl TextExtent {
    /// The definitions beside the part that is run.
    pub(super) fn known(&self) -> &[Defined] {
        match self {
            Self::Whole => &[],
            Self::Aside(known) | Self::Joining(known) => known,
        }
    }

    /// Ends a run.
    pub(super) fn end(&self, run: CacheRun<'_>, has_errors: bool) {
        match self {
            Self::Whole => run.end(has_errors),
            Self::Aside(_) => run.end_aside(),
            Self::Joining(_) => run.end_joining(has_errors),
        }
    }
}
