//! A whole file: evaluates its definitions in the order of the graph, then its effects in the
//! order of the source.

use std::sync::Arc;

use super::{
    appearance::Appearances,
    file_run::FileRun,
    globals::{Globals, KeptGlobals},
    ir::{
        Arg, DefinitionRole, Effect, EffectKind, ExportedSubjects, Expr, ExprKind, Kind,
        PrintedExpr, REPORT,
    },
    load::{LoadedScript, load},
    machine::Machine,
    memory::Work,
    outcome::{
        Checked, Defined, EffectOutput, ExportSubject, Exported, Outcome, Printed, in_order,
    },
    ownership::OwningCopies,
    param::GivenValue,
    schedule,
    settings::{Purpose, Settings, unknown_parameter},
    worker::{Inputs, Worker},
};
use crate::{
    diag::{Code, Diagnostic, Fix, Severity, Sources, Span, Spanned},
    value::Value,
};

/// Interprets the script `text`, which messages call `name`; it and the files that it imports are
/// added to `sources`.
#[must_use]
pub fn evaluate(name: &str, text: &str, sources: &mut Sources, settings: Settings<'_>) -> Outcome {
    let mut loaded = load(name, text, sources, settings);
    let diagnostics = std::mem::take(&mut loaded.diagnostics);
    let machine =
        Machine::new(loaded.env(settings), Globals::new(&loaded.program, "", settings.recall));
    let LoadedScript { ref document, unit, ref library, ref program, .. } = loaded;
    let mut run = FileRun { machine, settings, program, diagnostics, document };
    run.definitions();
    let mut definitions = run.defined();
    let mut outputs = match settings.purpose {
        Purpose::Run | Purpose::Test => run.effects(&[&definitions]),
        Purpose::SomeTests(_) => Vec::new(),
    };
    let mut kept = vec![Arc::clone(&run.machine.home)];
    let mut tests = run.tests(&definitions, &mut kept);
    let unknown_settings = run.unknown_settings();
    let is_whole = run.is_whole();
    let mut diagnostics = std::mem::take(&mut run.diagnostics);
    diagnostics.append(&mut run.machine.warnings);
    diagnostics.extend(library.take_findings());
    in_order(&mut diagnostics);
    kept.extend(library.homes());
    let kept = KeptGlobals::new(kept);
    OwningCopies::new(&kept).own(&mut definitions, &mut outputs, &mut tests);
    Outcome {
        definitions,
        outputs,
        tests,
        diagnostics,
        unknown_settings,
        is_whole,
        unit,
        tolerance: program.tolerance,
    }
}

impl FileRun<'_> {
    /// Evaluates every definition.
    fn definitions(&mut self) {
        let (env, settings, program) = (self.machine.env, self.settings, self.program);
        let home = &self.machine.home;
        let given: Vec<GivenValue<'_>> = settings.overrides.iter().map(GivenValue::Text).collect();
        let inputs = Inputs { given: &given, registry: settings.registry };
        let workers = schedule::run(
            program,
            settings.n_threads,
            settings.limits.stack_bytes,
            || Worker::new(Machine::new(env, Arc::clone(home)), settings.recall),
            |worker, members| worker.component(program, members, inputs),
        );
        for mut worker in workers {
            self.diagnostics.append(&mut worker.diagnostics);
            self.diagnostics.append(&mut worker.machine.warnings);
            self.machine.is_full |= worker.machine.is_full;
        }
    }

    /// Every definition with its name and value.
    pub(super) fn defined(&mut self) -> Vec<Defined> {
        let program = self.program;
        let mut defined = Vec::with_capacity(program.definitions.len());
        for (idx, definition) in (program.first..).zip(&program.definitions) {
            let kind = match definition.role {
                DefinitionRole::Hidden | DefinitionRole::Known(_) => continue,
                DefinitionRole::Value(kind) => Some(kind),
                DefinitionRole::Param(_) | DefinitionRole::Function | DefinitionRole::Import => {
                    None
                }
            };
            let name = match (&*definition.name, kind) {
                ("", Some(kind)) => {
                    format!("{}@{}", kind.word(), self.document.line(definition.name_span))
                }
                (name, _) => name.to_owned(),
            };
            let look = self.look(definition);
            let value = self.value(idx).cloned();
            let mark = self.machine.home.mark(idx);
            let identity = mark.map(|mark| mark.result);
            let work = match (&value, mark) {
                (None, _) => Work::Failed,
                (Some(_), None) => Work::Evaluated,
                (Some(_), Some(mark)) => mark.work,
            };
            let span = definition.name_span;
            defined.push(Defined { name, kind, span, value, work, identity, look });
        }
        defined
    }

    /// An option after `with`: its name and value.
    pub(super) fn option(
        &mut self,
        option: &Arg,
        n_slots: usize,
    ) -> Option<(Spanned<String>, Spanned<Value>)> {
        let Some((label, place)) = &option.label else {
            let message = "options are given by name";
            let hint = "for example `with (tolerance = 0.01)`";
            self.diagnostics
                .push(Diagnostic::error(Code::BadCall, option.span, message).hint(hint));
            return None;
        };
        let result = self.machine.run(option.value.as_ref()?, n_slots);
        let value = self.keep(result)?;
        Some((Spanned::new(label.to_string(), *place), Spanned::new(value, option.span)))
    }

    /// Carries out every effect that can act; `definitions` are those that `all` takes from.
    pub(super) fn effects(&mut self, definitions: &[&[Defined]]) -> Vec<EffectOutput> {
        let mut outputs = Vec::new();
        let looks = Appearances::of(definitions);
        for effect in &self.program.effects {
            if self.machine.is_full {
                break;
            }
            let can_act = !effect.is_poisoned && self.is_ready(&effect.dependencies);
            match &effect.kind {
                // Each of its expressions by itself.
                EffectKind::Print(exprs) => self.print(exprs, effect.n_slots, &mut outputs),
                _ if !can_act => {}
                EffectKind::Check { claim, message } => {
                    outputs.extend(
                        self.check(effect, claim, message.as_ref()).map(EffectOutput::Checked),
                    );
                }
                EffectKind::Export { .. } => {
                    let exported = self.export(effect, definitions, &looks);
                    outputs.extend(exported.map(EffectOutput::Exported));
                }
                EffectKind::Expect { code, subject, found } => {
                    let expected =
                        self.expectation(*code, subject, found.as_deref(), effect.n_slots);
                    outputs.push(EffectOutput::Expected(expected));
                }
            }
        }
        outputs
    }

    fn check(&mut self, effect: &Effect, claim: &Expr, message: Option<&Expr>) -> Option<Checked> {
        let judged = self.machine.judge(claim, effect.n_slots, self.program);
        let verdict = self.keep(judged)?;
        let message = match message {
            Some(expr) => Some(self.text(expr, effect.n_slots, "the message of a check")?),
            None => None,
        };
        let checked = Checked {
            source: self.document.excerpt(claim.span),
            span: claim.span,
            message,
            verdict,
        };
        if !checked.verdict.holds {
            self.diagnostics.push(failure(&checked));
        }
        Some(checked)
    }

    fn text(&mut self, expr: &Expr, n_slots: usize, subject: &str) -> Option<String> {
        let result = self.machine.run(expr, n_slots);
        match self.keep(result)? {
            Value::Text(text) => Some(text.to_string()),
            other => {
                let message = format!("{subject} must be a string, found {}", other.phrase());
                self.diagnostics.push(Diagnostic::error(Code::WrongKind, expr.span, message));
                None
            }
        }
    }

    /// What an expression of a print fails at does not silence the others.
    fn print(&mut self, exprs: &[PrintedExpr], n_slots: usize, outputs: &mut Vec<EffectOutput>) {
        for PrintedExpr { expr, dependencies, is_poisoned } in exprs {
            if *is_poisoned || !self.is_ready(dependencies) {
                continue;
            }
            let result = self.machine.run(expr, n_slots);
            if let Some(value) = self.keep(result) {
                outputs.push(EffectOutput::Printed(Printed {
                    source: self.document.excerpt(expr.span),
                    span: expr.span,
                    value,
                    unit: self.machine.env.unit,
                    is_text: expr.is_text(),
                }));
            }
        }
    }

    fn export(
        &mut self,
        effect: &Effect,
        definitions: &[&[Defined]],
        looks: &Appearances<'_>,
    ) -> Option<Exported> {
        let EffectKind::Export { subjects, named, path, options } = &effect.kind else {
            return None;
        };
        let is_report = matches!(subjects, ExportedSubjects::Report);
        let (subjects, names) = match subjects {
            ExportedSubjects::All => all_geometry(definitions)?,
            ExportedSubjects::Report => (Vec::new(), vec![REPORT.to_owned()]),
            ExportedSubjects::These(exprs) => {
                let mut subjects = Vec::new();
                for expr in exprs {
                    let result = self.machine.run(expr, effect.n_slots);
                    let value = self.keep(result)?;
                    let name = self.subject_name(expr, &value);
                    let look = self.look_of_subject(expr, looks);
                    let mark = match expr.kind {
                        ExprKind::Global(idx) => self.machine.home.mark(idx),
                        _ => None,
                    };
                    let identity = mark.map(|mark| mark.result);
                    let value = Spanned::new(value, expr.span);
                    subjects.push(ExportSubject { name, value, look, identity });
                }
                let named = named.iter().filter_map(|&idx| self.program.definition(idx));
                (subjects, named.map(|definition| definition.name.to_string()).collect())
            }
        };
        let place = path.span;
        let path = self.text(path, effect.n_slots, "the path of an export")?;
        let options =
            options.iter().filter_map(|option| self.option(option, effect.n_slots)).collect();
        Some(Exported { path: Spanned::new(path, place), subjects, is_report, names, options })
    }

    /// What a file calls an exported expression: the expression, if it reads as a name, else its
    /// kind and line.
    fn subject_name(&self, expr: &Expr, value: &Value) -> String {
        let source = self.document.excerpt(expr.span);
        let is_name = |c: char| c.is_alphanumeric() || "_.[]".contains(c);
        if source.chars().all(is_name) {
            source
        } else {
            format!("{}@{}", value.kind(), self.document.line(expr.span))
        }
    }

    fn unknown_settings(&self) -> Vec<String> {
        let definitions = &self.program.definitions;
        let names: Vec<&str> = definitions
            .iter()
            .filter(|definition| matches!(definition.role, DefinitionRole::Param(_)))
            .map(|definition| &*definition.name)
            .collect();
        let unknown = self
            .settings
            .overrides
            .iter()
            .filter(|setting| !names.contains(&setting.name.as_str()));
        unknown.map(|setting| unknown_parameter(&setting.name, &names)).collect()
    }
}

/// Every definition that promises geometry and is not hidden, and their names; `None` where the
/// file has a definition without a value.
fn all_geometry(definitions: &[&[Defined]]) -> Option<(Vec<ExportSubject>, Vec<String>)> {
    let mut subjects = Vec::new();
    for defined in definitions.iter().copied().flatten() {
        let value = defined.value.clone()?;
        if !defined.look.is_hidden && defined.kind.is_some_and(Kind::is_geometry) {
            let (name, look) = (defined.name.clone(), defined.look.clone());
            let (value, identity) = (Spanned::new(value, defined.span), defined.identity);
            subjects.push(ExportSubject { name, value, look, identity });
        }
    }
    let names = subjects.iter().map(|subject| subject.name.clone()).collect();
    Some((subjects, names))
}

/// `~=` in the place of a claim's only `==`.
fn nearly_equal(checked: &Checked) -> Option<Fix> {
    let mut places = checked.source.match_indices("==");
    let (at, _) = places.next()?;
    let is_verbatim = checked.source.len() == checked.span.range().len();
    let start = checked.span.start + at as u32;
    let fix = Fix::replace(Span::new(start, start + 2), "~=");
    (is_verbatim && places.next().is_none()).then_some(fix)
}

/// The report of a claim that does not hold.
fn failure(checked: &Checked) -> Diagnostic {
    let message = match &checked.message {
        Some(message) => format!("check failed: {message}"),
        None => format!("check failed: {}", checked.source),
    };
    let mut diagnostic = Diagnostic::error(Code::CheckFailed, checked.span, message);
    diagnostic.severity = Severity::Failure;
    if checked.verdict.differs_by_rounding {
        diagnostic = diagnostic.hint("numbers that were computed are compared with `~=`");
        diagnostic.fixes.extend(nearly_equal(checked));
    }
    let sides = checked.verdict.brief_sides();
    // Sides that are the same are told once.
    let is_one =
        matches!(&sides[..], [a, b] if checked.verdict.witness.is_some() && a.value == b.value);
    let sides = if is_one { &[] } else { &sides[..] };
    sides.iter().fold(diagnostic.label(checked.verdict.figures()), |diagnostic, side| {
        let text = match side.path.as_str() {
            "" => format!("this is {}", side.value),
            path => format!("its {path} is {}", side.value),
        };
        diagnostic.also(side.span, text)
    })
}
