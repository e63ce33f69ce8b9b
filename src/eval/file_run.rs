//! The evaluation of one file or test under way.

use super::{
    ir::{Dependency, Program},
    load::LoadingScript,
    machine::Machine,
    settings::Settings,
};
use crate::{
    diag::{Diagnostic, Result},
    value::Value,
};

/// The evaluation of one file or test under way.
pub(super) struct FileRun<'a> {
    pub(super) machine: Machine<'a>,
    pub(super) settings: Settings<'a>,
    pub(super) program: &'a Program,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) document: LoadingScript<'a>,
}

impl FileRun<'_> {
    pub(super) fn value(&self, idx: usize) -> Option<&Value> {
        self.machine.home.value(idx)
    }

    /// Whether everything that is used has a value.
    pub(super) fn is_ready(&self, dependencies: &[Dependency]) -> bool {
        dependencies.iter().all(|used| self.machine.home.has(used))
    }

    /// The value, or a diagnostic more.
    pub(super) fn keep<T>(&mut self, result: Result<T>) -> Option<T> {
        result.map_err(|diagnostic| self.diagnostics.push(*diagnostic)).ok()
    }
}
