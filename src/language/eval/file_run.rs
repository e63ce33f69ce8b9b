//! The evaluation of one file or test under way.

use super::{
    ir::{Definition, DefinitionRole, Dependency, Effect, EffectKind, Program},
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
    pub(super) document: &'a LoadingScript<'a>,
}

impl FileRun<'_> {
    pub(super) fn value(&self, idx: usize) -> Option<&Value> {
        self.machine.home.value(idx)
    }

    /// Whether everything that is used has a value.
    pub(super) fn is_ready(&self, dependencies: &[Dependency]) -> bool {
        dependencies.iter().all(|used| self.machine.home.has(used))
    }

    /// Whether nothing of the file itself lacks a value; of what it imports a part is enough.
    pub(super) fn is_whole(&self) -> bool {
        let home = &self.machine.home;
        let is_there = |(idx, definition): (usize, &Definition)| match definition.role {
            DefinitionRole::Import | DefinitionRole::Hidden => home.known(idx).is_some(),
            _ => home.value(idx).is_some(),
        };
        let can_act = |effect: &Effect| match &effect.kind {
            EffectKind::Print(exprs) => {
                exprs.iter().all(|expr| !expr.is_poisoned && self.is_ready(&expr.dependencies))
            }
            _ => !effect.is_poisoned && self.is_ready(&effect.dependencies),
        };
        let Program { first, definitions, effects, .. } = self.program;
        (*first..).zip(definitions).all(is_there) && effects.iter().all(can_act)
    }

    /// The value, or a diagnostic more.
    pub(super) fn keep<T>(&mut self, result: Result<T>) -> Option<T> {
        result.map_err(|diagnostic| self.diagnostics.push(*diagnostic)).ok()
    }
}
