//! Where the values of definitions stay while a file runs, and those of a test inside it.

use std::{
    fmt,
    sync::{Arc, OnceLock},
};

use super::{
    import_fault::ImportFault,
    ir::{Dependency, Program},
    memory::{CacheRun, ResultId},
};
use crate::value::Value;

/// What runs: the values of a file's definitions, and where the file lies.
#[derive(Debug, Default)]
pub(crate) struct Globals {
    /// Empty where not evaluated yet.
    values: Vec<OnceLock<DefinitionState>>,
    /// The identities of the values, where they are remembered.
    marks: Vec<OnceLock<ResultId>>,
    /// The number of the first of them; those before it belong to the file around a test.
    first: usize,
    around: Option<Arc<Globals>>,
    /// The folder that the file's paths are relative to; empty for that of the script.
    pub(crate) folder: String,
}

/// What a definition came to.
#[derive(Debug)]
pub(crate) enum DefinitionState {
    /// Nothing: it failed.
    Failed,
    /// A value.
    Whole(Value),
    /// The record of an imported file in which something failed: what has values nonetheless.
    Part(Value, ImportFault),
}

/// Keeps the definitions that functions in values use: while it lives, these functions answer, and curves and
/// surfaces of them.
#[derive(Clone, Default)]
pub(crate) struct KeptGlobals {
    homes: Vec<Arc<Globals>>,
}

/// What they hold does not show in the values that they are kept for.
impl fmt::Debug for KeptGlobals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("KeptGlobals")
    }
}

impl KeptGlobals {
    /// Keeps these homes.
    pub(super) fn new(homes: Vec<Arc<Globals>>) -> Self {
        Self { homes }
    }

    /// Keeps what another one keeps as well.
    pub(crate) fn keep(&mut self, other: &Self) {
        for home in &other.homes {
            if !self.homes.iter().any(|known| Arc::ptr_eq(known, home)) {
                self.homes.push(Arc::clone(home));
            }
        }
    }
}

impl Globals {
    /// The home of a program, before anything is evaluated.
    pub(super) fn new(program: &Program, folder: &str, recall: Option<&CacheRun<'_>>) -> Arc<Self> {
        Arc::new(Self::of(program, folder, recall, None))
    }

    /// The home of a test's program inside this file.
    pub(super) fn of_test(
        self: &Arc<Self>,
        program: &Program,
        recall: Option<&CacheRun<'_>>,
    ) -> Arc<Self> {
        Arc::new(Self::of(program, &self.folder, recall, Some(Arc::clone(self))))
    }

    fn of(
        program: &Program,
        folder: &str,
        recall: Option<&CacheRun<'_>>,
        around: Option<Arc<Self>>,
    ) -> Self {
        let values = program.definitions.iter().map(|_| OnceLock::new()).collect();
        let marked = if recall.is_some() { program.definitions.as_slice() } else { &[] };
        let marks = marked.iter().map(|_| OnceLock::new()).collect();
        Self { values, marks, first: program.first, around, folder: folder.to_owned() }
    }

    /// The value of a definition.
    pub(crate) fn value(&self, idx: usize) -> Option<&Value> {
        match self.kept(idx)? {
            DefinitionState::Whole(value) => Some(value),
            DefinitionState::Part(..) | DefinitionState::Failed => None,
        }
    }

    /// The value of a definition, or what is known of it; whoever uses it has asked whether that is enough.
    pub(crate) fn known(&self, idx: usize) -> Option<&Value> {
        match self.kept(idx)? {
            DefinitionState::Whole(value) | DefinitionState::Part(value, _) => Some(value),
            DefinitionState::Failed => None,
        }
    }

    /// Whether what is used of a definition has a value.
    pub(super) fn has(&self, used: &Dependency) -> bool {
        match (self.kept(used.definition), &used.fields) {
            (Some(DefinitionState::Whole(_)), _) => true,
            // What it never had is a mistake of whoever asks.
            (Some(DefinitionState::Part(Value::Record(record), fault)), Some(fields)) => {
                fields.iter().all(|name| record.get(name).is_some() || !fault.has_lost(name))
            }
            _ => false,
        }
    }

    fn kept(&self, idx: usize) -> Option<&DefinitionState> {
        match idx.checked_sub(self.first) {
            Some(own) => self.values.get(own)?.get(),
            None => self.around.as_ref()?.kept(idx),
        }
    }

    /// The identity of a definition's value.
    pub(super) fn mark(&self, idx: usize) -> Option<&ResultId> {
        match idx.checked_sub(self.first) {
            Some(own) => self.marks.get(own)?.get(),
            None => self.around.as_ref()?.mark(idx),
        }
    }

    /// Keeps what a definition of its own came to; each belongs to one component, so that it is
    /// kept once.
    pub(crate) fn keep(&self, idx: usize, value: DefinitionState) {
        if let Some(place) = idx.checked_sub(self.first).and_then(|own| self.values.get(own)) {
            let _ = place.set(value);
        }
    }

    /// The same with the value's identity.
    pub(super) fn keep_marked(&self, idx: usize, value: DefinitionState, mark: Option<ResultId>) {
        let place = idx.checked_sub(self.first).and_then(|own| self.marks.get(own));
        if let (Some(place), Some(mark)) = (place, mark) {
            let _ = place.set(mark);
        }
        self.keep(idx, value);
    }
}
