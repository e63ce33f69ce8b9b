//! Imported files with their parameters: each evaluated once for each set of parameters.
//!
//! The value of an import is the record of what the file defines.

use std::sync::{Arc, OnceLock, PoisonError};

use super::{
    cache_key::{CacheKey, KeySort},
    env::{Env, GivenParameters, ImportedFiles},
    globals::Globals,
    import_fault::ImportFault,
    imported::{ImportInstance, InstanceSlot},
    ir::Program,
    library::{Library, LibraryFile, folder},
    machine::Machine,
    memory::{CacheRun, Fields},
    param::GivenValue,
    worker::{Inputs, Worker},
};
use crate::{
    diag::{Code, Diagnostic, Result, Severity, Span, Spanned, nearest},
    kernel::sorting::sort_by,
    limits::stack,
    value::{Record, Value, exact_key},
};

impl ImportedFiles for Library<'_> {
    fn value(
        &self,
        file: usize,
        parameters: GivenParameters,
        env: Env<'_>,
    ) -> Result<Arc<ImportInstance>> {
        let slot = self.slot(file, &parameters)?;
        // Imports make no circle, so that whoever waits here is not waited for.
        let instance = slot.1.get_or_init(|| self.evaluate(file, slot.0, &parameters, env));
        instance.findings.iter().for_each(|finding| self.report(finding.clone()));
        Ok(Arc::clone(instance))
    }

    fn instance(
        &self,
        file: usize,
        parameters: GivenParameters,
        env: Env<'_>,
        (span, depth): (Span, usize),
    ) -> Result<Arc<ImportInstance>> {
        let slot = self.slot(file, &parameters)?;
        let make = |env: Env<'_>| {
            let made = || self.evaluate(file, slot.0, &parameters, env);
            Arc::clone(slot.1.get_or_init(made))
        };
        let limits = env.limits;
        // All files inside one another together go no deeper than one may, in the other half of the stack.
        let is_shallow = depth.saturating_mul(limits.import_nesting) <= limits.evaluation_depth;
        if is_shallow || slot.1.get().is_some() {
            return Ok(make(env));
        }
        let made = stack::known(0, || {
            stack::with(limits.stack_bytes, |bytes| {
                let limits = limits.on_stack(bytes);
                (0 < bytes).then(|| make(Env { limits: &limits, ..env }))
            })
        });
        made.ok_or_else(|| {
            let message = "a script is called too deep inside other calls";
            Box::new(Diagnostic::error(Code::RecursionTooDeep, span, message))
        })
    }

    fn identity(&self, file: usize) -> u64 {
        let LibraryFile { path, program, identity, fault, .. } = &self.files[file];
        let spell = |recall: &CacheRun<'_>| {
            let all: Vec<usize> = (0..program.definitions.len()).collect();
            let none = Globals::default();
            let mut key = CacheKey::new(KeySort::Script, &none, &all, Some(self));
            key.text(folder(path));
            key.text(&format!("{:?} {:?}", program.unit, program.tolerance));
            // A statement that is broken is no definition.
            key.text(if fault.is_some() { "broken" } else { "" });
            for definition in &program.definitions {
                key.text(&definition.name);
                key.definition(definition, None);
            }
            recall.intern(key.finish())
        };
        *identity.get_or_init(|| self.settings.recall.map_or(0, spell))
    }
}

impl Library<'_> {
    /// The place of the instance of a file with these parameters.
    fn slot(
        &self,
        file: usize,
        parameters: &[(Spanned<Arc<str>>, Spanned<Value>)],
    ) -> Result<InstanceSlot> {
        self.check_parameters(file, parameters)?;
        let mut given: Vec<_> = parameters.iter().collect();
        sort_by(&mut given, |a, b| a.0.value.cmp(&b.0.value));
        let mut key = Vec::new();
        for (name, value) in given {
            exact_key(&Value::Text(Arc::clone(&name.value)), &mut key);
            exact_key(&value.value, &mut key);
        }
        let mut instances = self.instances.lock().unwrap_or_else(PoisonError::into_inner);
        let number = instances.len();
        let slot =
            instances.entry((file, key)).or_insert_with(|| Arc::new((number, OnceLock::new())));
        Ok(Arc::clone(slot))
    }

    fn check_parameters(
        &self,
        file: usize,
        parameters: &[(Spanned<Arc<str>>, Spanned<Value>)],
    ) -> Result<()> {
        let LibraryFile { path, program, .. } = &self.files[file];
        let names: Vec<&str> = program.parameters().collect();
        for (name, _) in parameters {
            if !names.contains(&&*name.value) {
                let message = format!("`{path}` has no parameter `{}`", name.value);
                let diagnostic = Diagnostic::error(Code::UnknownParameter, name.span, message);
                return match (nearest(&name.value, names.iter().copied()), names.as_slice()) {
                    (Some(near), _) => diagnostic.meant(near),
                    (None, []) => diagnostic.hint("it has no parameters at all"),
                    (None, _) => {
                        diagnostic.hint(format!("its parameters are {}", names.join(", ")))
                    }
                }
                .fail();
            }
        }
        Ok(())
    }

    fn evaluate(
        &self,
        file: usize,
        number: usize,
        parameters: &[(Spanned<Arc<str>>, Spanned<Value>)],
        env: Env<'_>,
    ) -> Arc<ImportInstance> {
        let LibraryFile { path, program, fault, is_garbled, .. } = &self.files[file];
        let recall = self.settings.recall;
        let home = Globals::new(program, folder(path), recall);
        let env = Env { tolerance: program.tolerance, library: Some(self), ..env };
        let given: Vec<GivenValue<'_>> =
            parameters.iter().map(|(name, value)| GivenValue::Value(&name.value, value)).collect();
        let inputs = Inputs { given: &given, registry: self.settings.registry };
        let mut worker = Worker::new(Machine::new(env, Arc::clone(&home)), recall);
        for component in &program.components {
            worker.component(program, component, inputs);
        }
        let mut findings = std::mem::take(&mut worker.diagnostics);
        findings.append(&mut worker.machine.warnings);
        let failed = findings.iter().find(|found| found.severity == Severity::Error);
        let lost = || {
            let shown = shown(program).filter(|(idx, _)| home.value(*idx).is_none());
            shown.map(|(_, name)| name).collect()
        };
        let first = fault.clone().or_else(|| failed.cloned().map(Box::new));
        let fault = first.map(|first| ImportFault { first, lost: lost(), is_whole: *is_garbled });
        let shown = public(program, &home);
        let is_doubtful = !findings.is_empty() || 0 < worker.machine.n_doubtful;
        let Worker { reads, n_steps, .. } = worker;
        Arc::new(ImportInstance {
            number,
            home,
            shown,
            fault,
            is_doubtful,
            findings,
            reads,
            n_steps,
        })
    }
}

/// What a file shows: its named definitions but for those that begin with `_`, and their
/// identities.
fn public(program: &Program, home: &Globals) -> (Value, Fields) {
    let shown = || shown(program);
    let record =
        Record::new(shown().filter_map(|(idx, name)| Some((name, home.value(idx)?.clone()))));
    let fields = shown().filter_map(|(idx, name)| Some((name, home.mark(idx)?.result))).collect();
    (Value::Record(Arc::new(record)), fields)
}

/// The named definitions of a file but for those that begin with `_`.
fn shown(program: &Program) -> impl Iterator<Item = (usize, Arc<str>)> {
    let named = program.definitions.iter().enumerate();
    named
        .filter(|(_, definition)| definition.is_named() && !definition.name.starts_with('_'))
        .map(|(idx, definition)| (idx, Arc::clone(&definition.name)))
}
