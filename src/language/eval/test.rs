//! The tests of a file, one after another, each by itself: what one of them meets stops no other.

use std::sync::Arc;

use super::{
    claim::shown,
    file_run::FileRun,
    globals::Globals,
    ir::{EffectKind, Expr, Test},
    machine::Machine,
    outcome::{Defined, ExpectedMistake, TestOutcome},
    settings::Purpose,
    worker::{Inputs, Worker},
};
use crate::diag::{Code, Diagnostic, Severity};

impl FileRun<'_> {
    /// Runs the tests that are asked for; `definitions` are those of the file. `homes` are told where their own stay.
    pub(super) fn tests(
        &self,
        definitions: &[Defined],
        homes: &mut Vec<Arc<Globals>>,
    ) -> Vec<TestOutcome> {
        let is_wanted = |test: &&Test| match self.settings.purpose {
            Purpose::Run => false,
            Purpose::Test => true,
            Purpose::SomeTests(filter) => filter.takes(&test.name),
        };
        let tests = self.program.tests.iter().filter(is_wanted);
        tests.map(|test| self.test(test, definitions, homes)).collect()
    }

    fn test(
        &self,
        test: &Test,
        definitions: &[Defined],
        homes: &mut Vec<Arc<Globals>>,
    ) -> TestOutcome {
        let mut tested = TestOutcome {
            name: test.name.to_string(),
            span: test.span,
            outputs: Vec::new(),
            diagnostics: Vec::new(),
            is_poisoned: test.is_poisoned,
            is_whole: false,
        };
        if test.is_poisoned || self.machine.is_full {
            return tested;
        }
        let program = &test.program;
        let home = self.machine.home.of_test(program, self.settings.recall);
        homes.push(Arc::clone(&home));
        let machine = Machine::new(self.machine.env, home);
        let mut worker = Worker::new(machine, self.settings.recall);
        let inputs = Inputs { given: &[], registry: self.settings.registry };
        for component in &program.components {
            worker.component(program, component, inputs);
        }
        let Worker { machine, diagnostics, .. } = worker;
        let mut run = FileRun { machine, program, diagnostics, ..*self };
        let own = run.defined();
        tested.outputs = run.effects(&[definitions, &own]);
        let have_values = |defined: &[Defined]| defined.iter().all(|one| one.value.is_some());
        let takes_all = |kind: &EffectKind| matches!(kind, EffectKind::Export { subjects, .. } if subjects.is_of_whole_file());
        tested.is_whole = have_values(&own)
            && program.effects.iter().all(|effect| {
                run.is_ready(&effect.dependencies)
                    && (!takes_all(&effect.kind) || have_values(definitions))
            });
        tested.diagnostics = run.diagnostics;
        tested.diagnostics.append(&mut run.machine.warnings);
        tested
    }

    /// Whether an expression fails with a code; `found` is how it does without being evaluated.
    pub(super) fn expectation(
        &mut self,
        code: Code,
        subject: &Expr,
        found: Option<&Diagnostic>,
        n_slots: usize,
    ) -> ExpectedMistake {
        let n_warnings = self.machine.warnings.len();
        let found = match found {
            Some(found) => Err(Box::new(found.clone())),
            None => {
                self.machine.run(subject, n_slots).map(|value| shown(&value, self.machine.env.unit))
            }
        };
        // Whatever else was said of what must fail is of no interest.
        self.machine.warnings.truncate(n_warnings);
        let source = self.document.excerpt(subject.span);
        let expected = ExpectedMistake { source, span: subject.span, code, found };
        if !expected.holds() {
            self.diagnostics.push(failure(&expected));
        }
        expected
    }
}

/// The report of an expected error that did not come.
fn failure(expected: &ExpectedMistake) -> Diagnostic {
    let code = expected.code.id();
    let failure = |message: String| Diagnostic {
        severity: Severity::Failure,
        ..Diagnostic::error(Code::ErrorMissing, expected.span, message)
    };
    match &expected.found {
        Ok(value) => failure(format!("error {code} was expected, but there is none"))
            .label(format!("this is {value}")),
        Err(other) => {
            let found = other.code.id();
            let told =
                failure(format!("error {code} was expected, found {found}: {}", other.message));
            let told = if other.primary.span == expected.span {
                told.label(format!("this fails with {found}"))
            } else {
                told.label(format!("{code} was expected of this"))
                    .also(other.primary.span, format!("{found} comes from here"))
            };
            other.hints.iter().fold(told, Diagnostic::hint)
        }
    }
}
