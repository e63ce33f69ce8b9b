//! What evaluating an imported file came to.

use std::{
    collections::BTreeSet,
    sync::{Arc, OnceLock},
};

use super::{
    globals::Globals,
    import_fault::ImportFault,
    memory::{Fields, FileRead},
};
use crate::{diag::Diagnostic, value::Value};

/// An imported file with its parameters, evaluated.
#[derive(Debug)]
pub(crate) struct ImportInstance {
    /// Which one it is in this run.
    pub(super) number: usize,
    /// Functions of the file look here for its definitions.
    pub(super) home: Arc<Globals>,
    /// The record of what it shows, as far as that has values, and the identities of those.
    pub(super) shown: (Value, Fields),
    /// What went wrong.
    pub(super) fault: Option<ImportFault>,
    /// Whether it warns of something, or a file that it evaluates does.
    pub(super) is_doubtful: bool,
    /// What went wrong, and what is doubtful.
    pub(super) findings: Vec<Diagnostic>,
    /// The files that its definitions read, where results are remembered.
    pub(super) reads: BTreeSet<FileRead>,
    /// The steps that it took.
    pub(super) n_steps: u64,
}

/// The place of an instance, which is made once.
pub(super) type InstanceSlot = Arc<(usize, OnceLock<Arc<ImportInstance>>)>;
