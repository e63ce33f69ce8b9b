//! What one thread does: evaluates components of the graph and keeps what it finds.

use std::{
    collections::BTreeSet,
    sync::{Arc, PoisonError},
};

use super::{
    cache_key::{CacheKey, KeySort},
    env::ImportedFiles,
    globals::{DefinitionState, Globals},
    ir::{Definition, DefinitionRole, ExprKind, Program},
    machine::{FileReads, Machine},
    memory::{CacheRun, CachedResult, FileRead, ResultId, Work},
    param::{self, GivenValue},
};
use crate::{
    diag::Diagnostic,
    kernel::sorting::sort_by_key,
    value::{Registry, Value},
};

/// What the definitions of a file are evaluated with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inputs<'a> {
    /// Values for its parameters.
    pub(super) given: &'a [GivenValue<'a>],
    /// The built-ins.
    pub(super) registry: &'a Registry,
}

impl Inputs<'_> {
    /// The value that is given for a definition. Of two the last one counts.
    fn of(&self, definition: &Definition) -> Option<&GivenValue<'_>> {
        match definition.role {
            DefinitionRole::Param(_) => {
                self.given.iter().rfind(|given| given.name() == &*definition.name)
            }
            _ => None,
        }
    }
}

/// What one thread keeps while it evaluates definitions of a file.
pub(super) struct Worker<'a> {
    pub(super) machine: Machine<'a>,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// The files that definitions read, where results are remembered.
    pub(super) reads: BTreeSet<FileRead>,
    /// The steps that all definitions took together.
    pub(super) n_steps: u64,
    /// What earlier runs gave, and the identity of what holds for the whole file.
    memory: Option<(&'a CacheRun<'a>, u64)>,
}

impl<'a> Worker<'a> {
    /// A worker that has found nothing yet.
    pub(super) fn new(machine: Machine<'a>, recall: Option<&'a CacheRun<'a>>) -> Self {
        let memory = recall.map(|recall| {
            let (env, home) = (machine.env, &machine.home);
            let mut file = CacheKey::new(KeySort::File, home, &[], None);
            file.text(&home.folder);
            file.text(&format!("{:?} {:?} {:?}", env.unit, env.tolerance, env.limits));
            (recall, recall.intern(file.finish()))
        });
        let (diagnostics, reads) = (Vec::new(), BTreeSet::new());
        Self { machine, diagnostics, reads, n_steps: 0, memory }
    }

    /// Evaluates a component; a member that fails takes the others along.
    pub(super) fn component(&mut self, program: &Program, members: &[usize], inputs: Inputs<'_>) {
        let is_ready = members.iter().all(|&idx| {
            let Some(definition) = program.definition(idx) else { return false };
            let mut outside =
                definition.dependencies.iter().filter(|used| !members.contains(&used.definition));
            !definition.is_poisoned && outside.all(|used| self.machine.home.has(used))
        });
        if let &[idx] = members
            && let Some(definition) = program.definition(idx)
            && let DefinitionRole::Known(result) = definition.role
            && let ExprKind::Constant(value) = &definition.value.kind
        {
            let mark = result.map(|result| ResultId::new(result, Work::Reused));
            self.machine.home.keep_marked(idx, DefinitionState::Whole(value.clone()), mark);
            return;
        }
        match self.memory {
            _ if !is_ready => {
                members
                    .iter()
                    .for_each(|&idx| self.machine.home.keep(idx, DefinitionState::Failed));
            }
            None => {
                for &idx in members {
                    let definition = program.definition(idx);
                    let value =
                        definition.and_then(|definition| self.definition(definition, inputs));
                    let kept = self.kept(value);
                    self.machine.home.keep(idx, kept);
                }
            }
            Some((recall, file)) => {
                let home = Arc::clone(&self.machine.home);
                for (idx, key) in keys(
                    (&home, self.machine.env.library),
                    program,
                    members,
                    inputs,
                    (recall, file),
                ) {
                    let definition = program.definition(idx);
                    let found = definition
                        .and_then(|definition| self.recalled(definition, key, inputs, recall));
                    let (value, mark) = found.unzip();
                    home.keep_marked(idx, self.kept(value), mark);
                }
            }
        }
    }

    /// What a definition came to, whose value is this; of an import what is wrong in its file is wrong here.
    fn kept(&mut self, value: Option<Value>) -> DefinitionState {
        let fault = self.machine.import_fault.take();
        match (value, fault) {
            (None, _) => DefinitionState::Failed,
            (Some(value), None) => DefinitionState::Whole(value),
            (Some(value), Some(fault)) => {
                self.diagnostics.push(fault.first.as_ref().clone());
                if fault.is_whole {
                    DefinitionState::Failed
                } else {
                    DefinitionState::Part(value, fault)
                }
            }
        }
    }

    /// The value of a definition from an earlier run, or a new one.
    fn recalled(
        &mut self,
        definition: &Definition,
        key: Box<[u8]>,
        inputs: Inputs<'_>,
        recall: &CacheRun<'_>,
    ) -> Option<(Value, ResultId)> {
        if matches!(definition.value.kind, ExprKind::Import(..)) {
            return self.imported(definition, inputs, recall);
        }
        let known = recall.find(&key, self.machine.env.files);
        let old = known.as_ref().map(|known| known.result);
        if let Some(CachedResult { result, value: Some(value), reads, n_steps }) = known {
            self.reads.extend(reads.iter().cloned());
            self.n_steps += n_steps;
            return Some((value, ResultId::new(result, Work::Reused)));
        }
        let n_warnings = |machine: &Machine<'_>| machine.warnings.len() + machine.n_doubtful;
        let n_before = n_warnings(&self.machine);
        let n_steps = self.n_steps;
        let (value, reads) = self.with_reads(definition, inputs)?;
        let is_kept = !value.extent().holds_functions && n_warnings(&self.machine) == n_before;
        let n_steps = self.n_steps - n_steps;
        let result = recall.keep(key, is_kept.then(|| value.clone()), reads, n_steps);
        let work = if old == Some(result) { Work::Renewed } else { Work::Evaluated };
        Some((value, ResultId::new(result, work)))
    }

    /// What an import brings, put together again from the definitions of its file, which have
    /// results of their own. It is what they are.
    fn imported(
        &mut self,
        definition: &Definition,
        inputs: Inputs<'_>,
        recall: &CacheRun<'_>,
    ) -> Option<(Value, ResultId)> {
        let (value, _) = self.with_reads(definition, inputs)?;
        let fields = std::mem::take(&mut self.machine.imported);
        let mut key = CacheKey::new(KeySort::Import, &self.machine.home, &[], None);
        for (name, result) in &*fields {
            key.text(name);
            key.result(*result);
        }
        let key = key.finish();
        let known = recall.find(&key, self.machine.env.files);
        let work = if known.is_some() { Work::Reused } else { Work::Evaluated };
        let result = recall.intern(key);
        Some((value, ResultId { fields, ..ResultId::new(result, work) }))
    }

    /// The value of a definition, and the files that were read for it.
    fn with_reads(
        &mut self,
        definition: &Definition,
        inputs: Inputs<'_>,
    ) -> Option<(Value, BTreeSet<FileRead>)> {
        let reads = self.machine.reads.insert(FileReads::default()).clone();
        let value = self.definition(definition, inputs)?;
        let reads = std::mem::take(&mut *reads.lock().unwrap_or_else(PoisonError::into_inner));
        self.reads.extend(reads.iter().cloned());
        Some((value, reads))
    }

    fn definition(&mut self, definition: &Definition, inputs: Inputs<'_>) -> Option<Value> {
        if self.machine.is_full {
            return None;
        }
        let result = match &definition.role {
            DefinitionRole::Param(rules) => {
                let given = inputs.of(definition);
                param::evaluate(&mut self.machine, definition, rules, given, inputs.registry)
            }
            _ => self.machine.run(&definition.value, definition.n_slots),
        };
        self.n_steps += 1 + self.machine.steps;
        result.map_err(|diagnostic| self.diagnostics.push(*diagnostic)).ok()
    }
}

/// The members of a component with their keys.
fn keys(
    (home, library): (&Globals, Option<&dyn ImportedFiles>),
    program: &Program,
    members: &[usize],
    inputs: Inputs<'_>,
    (recall, file): (&CacheRun<'_>, u64),
) -> Vec<(usize, Box<[u8]>)> {
    let spell = |sort, members: &[usize]| {
        let mut key = CacheKey::new(sort, home, members, library);
        key.result(file);
        for &idx in members {
            let Some(definition) = program.definition(idx) else { continue };
            key.definition(definition, inputs.of(definition));
        }
        key.finish()
    };
    if let &[only] = members {
        return vec![(only, spell(KeySort::Definition, members))];
    }
    // Functions that use one another, in an order that does not depend on their places.
    let mut members = members.to_vec();
    sort_by_key(&mut members, |&idx| program.definition(idx).map(|definition| &definition.name));
    let component = recall.intern(spell(KeySort::Component, &members));
    let member = |(place, idx)| {
        let mut key = CacheKey::new(KeySort::Member, home, &[], None);
        key.result(component);
        key.number(place);
        (idx, key.finish())
    };
    members.into_iter().enumerate().map(member).collect()
}
