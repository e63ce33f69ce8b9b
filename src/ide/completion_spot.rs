//! The place at which a text is completed, and what is asked about expressions there.

use super::{Document, Values};
use crate::{session::Session, value::Registry};

/// What completion looks at.
pub(super) struct CompletionSpot<'a> {
    pub(super) document: &'a Document,
    pub(super) session: &'a Session,
    pub(super) registry: &'a Registry,
    pub(super) values: Option<&'a Values>,
    pub(super) at: usize,
}
