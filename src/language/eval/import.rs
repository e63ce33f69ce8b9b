//! Evaluation of imports, and of calls that name a script.

use std::sync::{Arc, PoisonError};

use super::{
    env::GivenParameters,
    imported::ImportInstance,
    ir::{Arg, ScriptFile},
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Severity, Span, Spanned},
    value::Value,
};

impl Machine<'_> {
    /// The record of what an imported file defines, as far as that has values.
    #[inline(never)]
    pub(super) fn import(&mut self, file: usize, with: &[Arg], span: Span) -> Result<Value> {
        let parameters = self.given(with)?;
        let Some(library) = self.env.library else {
            let message = "nothing can be imported here";
            return Diagnostic::error(Code::FileMissing, span, message).fail();
        };
        let instance = library.value(file, parameters, self.env)?;
        let (value, fields) = instance.shown.clone();
        self.imported = fields;
        self.note(&instance);
        // The mistake itself is told in its file; the importer stays quiet.
        self.import_fault.clone_from(&instance.fault);
        Ok(value)
    }

    /// The record of what a script defines that a call names.
    #[inline(never)]
    pub(super) fn script_file(
        &mut self,
        file: &ScriptFile,
        with: &[Arg],
        span: Span,
    ) -> Result<Value> {
        self.step(span)?;
        let parameters = self.given(with)?;
        let idx = match file.found.get() {
            Some(Ok(idx)) => *idx,
            Some(Err(fault)) => return Err(fault.clone()),
            None => unreachable!("files are looked for before anything is evaluated"),
        };
        let Some(library) = self.env.library else {
            let message = "no other script is evaluated inside the function of a curve or surface";
            return Diagnostic::error(Code::NoDerivative, span, message)
                .hint("call it outside and give its result a name")
                .fail();
        };
        let instance = library.instance(idx, parameters, self.env, (span, self.depth()))?;
        self.take_in(&instance, span)?;
        match &instance.fault {
            None => Ok(instance.shown.0.clone()),
            Some(failed) => {
                let text = format!("`{}` is evaluated from here", file.path);
                let told = failed.first.as_ref().clone().also(span, text);
                Err(Box::new(with_others(told, &instance.findings)))
            }
        }
    }

    /// What an evaluated script used up, read and warned of counts here, once for each expression.
    fn take_in(&mut self, instance: &Arc<ImportInstance>, span: Span) -> Result<()> {
        if !self.scripts.insert(instance.number) {
            return Ok(());
        }
        let is_warning = |finding: &&Diagnostic| finding.severity == Severity::Warning;
        self.warnings.extend(instance.findings.iter().filter(is_warning).cloned());
        self.note(instance);
        self.steps(instance.n_steps, span)
    }

    /// What an evaluated file read, this reads; and where it warns, it is to be asked again.
    fn note(&mut self, instance: &ImportInstance) {
        self.n_doubtful += usize::from(instance.is_doubtful);
        if let Some(reads) = &self.reads {
            let mut reads = reads.lock().unwrap_or_else(PoisonError::into_inner);
            reads.extend(instance.reads.iter().cloned());
        }
    }

    /// The parameters that a file is given.
    fn given(&mut self, with: &[Arg]) -> Result<GivenParameters> {
        let mut parameters = Vec::with_capacity(with.len());
        for arg in with {
            // Lowering has told where one of them is missing.
            let (Some(expr), Some((label, place))) = (&arg.value, &arg.label) else { continue };
            let value = Spanned::new(self.eval(expr)?, arg.span);
            parameters.push((Spanned::new(Arc::clone(label), *place), value));
        }
        Ok(parameters)
    }
}

/// Errors of a script that are told with the first.
const MOST_OTHERS: usize = 4;

/// The first error of a script, with the places of those that stand beside it: what comes of a call is one error.
fn with_others(first: Diagnostic, findings: &[Diagnostic]) -> Diagnostic {
    let is_other = |found: &&Diagnostic| {
        found.severity == Severity::Error && found.primary.span != first.primary.span
    };
    let others: Vec<&Diagnostic> = findings.iter().filter(is_other).collect();
    let mut told = first.clone();
    for (idx, other) in others.iter().enumerate().take(MOST_OTHERS) {
        let left = others.len() - idx - 1;
        let text = match idx + 1 {
            MOST_OTHERS if 0 < left => format!("and here: {}; {left} more follow", other.message),
            _ => format!("and here: {}", other.message),
        };
        told = told.also(other.primary.span, text);
    }
    told
}
