//! What went wrong in an imported file.

use std::{collections::BTreeSet, sync::Arc};

use crate::diag::Diagnostic;

/// What is missing of an imported file.
#[derive(Clone, Debug)]
pub(super) struct ImportFault {
    /// The first thing that went wrong.
    pub(super) first: Box<Diagnostic>,
    /// The names without a value; of a text with mistakes nobody knows all.
    pub(super) lost: Option<BTreeSet<Arc<str>>>,
}

impl ImportFault {
    /// Whether it may be its fault that a name means nothing.
    pub(super) fn has_lost(&self, name: &str) -> bool {
        self.lost.as_ref().is_none_or(|lost| lost.contains(name))
    }
}
