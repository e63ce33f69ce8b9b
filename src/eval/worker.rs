//! What one thread does: evaluates components of the graph and keeps what it finds.

use super::{
    ir::{Definition, Program, Role},
    machine::Machine,
    param::{self, Given},
};
use crate::{
    diag::Diagnostic,
    value::{Registry, Value},
};

/// What one thread keeps while it evaluates definitions.
pub(super) struct Worker<'a> {
    pub(super) machine: Machine<'a>,
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'a> Worker<'a> {
    /// A worker that has found nothing yet.
    pub(super) fn new(machine: Machine<'a>) -> Self {
        Self { machine, diagnostics: Vec::new() }
    }

    /// Evaluates a component; a member that fails takes the others along.
    pub(super) fn component(
        &mut self,
        program: &Program,
        members: &[usize],
        given: &[Given<'_>],
        registry: &Registry,
    ) {
        let is_ready = members.iter().all(|&idx| {
            let Some(definition) = program.definition(idx) else { return false };
            let mut outside = definition.dependencies.iter().filter(|idx| !members.contains(idx));
            !definition.is_poisoned && outside.all(|&idx| self.machine.home.value(idx).is_some())
        });
        for &idx in members {
            let definition = program.definition(idx).filter(|_| is_ready);
            let value =
                definition.and_then(|definition| self.definition(definition, given, registry));
            self.machine.home.keep(idx, value);
        }
    }

    fn definition(
        &mut self,
        definition: &Definition,
        given: &[Given<'_>],
        registry: &Registry,
    ) -> Option<Value> {
        let result = match &definition.role {
            Role::Param(rules) => {
                let given = given.iter().rfind(|given| given.name() == &*definition.name);
                param::evaluate(&mut self.machine, definition, rules, given, registry)
            }
            _ => self.machine.run(&definition.value, definition.n_slots),
        };
        result.map_err(|diagnostic| self.diagnostics.push(*diagnostic)).ok()
    }
}
