//! What went wrong in an imported file.

use std::{collections::BTreeSet, sync::Arc};

use crate::diag::Diagnostic;

/// What is missing of an imported file.
#[derive(Clone, Debug)]
pub(super) struct ImportFault {
    /// The first thing that went wrong.
    pub(super) first: Box<Diagnostic>,
    /// The names without a value.
    pub(super) lost: BTreeSet<Arc<str>>,
    /// Whether nothing of it can be used: in a text with mistakes of form names may mean something else.
    pub(super) is_whole: bool,
}

impl ImportFault {
    /// Whether it may be its fault that a name means nothing.
    pub(super) fn has_lost(&self, name: &str) -> bool {
        self.lost.contains(name)
    }
}
