//! The document of the prompt, and the answers to what is asked about it.

use std::{
    collections::BTreeSet,
    path::PathBuf,
    sync::{Arc, Weak},
    time::Duration,
};

use super::{
    super::{
        exit_status::ExitStatus, progress::Progress, reporter::Reporter, run, standard_streams::say,
    },
    concerned::ConcernedPart,
    document::{Draft, PromptDocument, UndoHistory},
    engine::{Engine, EngineRun},
    part_run::{EvaluatedExtent, PartRun},
    show,
};
use crate::{
    diag::{Diagnostic, Severity, Sources},
    eval::{Printed, Work},
    ide::Values,
    limits::Limits,
    session::{Event, Report, Session},
    syntax::{StatementRole, ast::Unit, free_placeholders},
    value::Value,
};

/// Characters of a value that a terminal is shown.
const MOST_CHARS: usize = 4_000;

/// Bytes of the expression that `_` may stand for.
const MOST_LAST: usize = 64 << 10;

/// The name of the last value in the text that is evaluated.
const LAST: &str = "_last";

/// A document and whoever is asked about it.
pub(super) struct Prompt {
    pub(super) engine: Engine,
    pub(super) voice: Reporter,
    pub(super) document: PromptDocument,
    pub(super) undo: UndoHistory,
    /// What `_` stands for, as text.
    pub(super) last: Option<String>,
    /// The findings that the document as it is has been told of.
    pub(super) told: BTreeSet<String>,
    /// What the document came to.
    pub(super) values: Arc<Values>,
    /// The session that they are of.
    pub(super) values_of: Weak<Session>,
    /// Entries that were evaluated in part since all of the document was.
    pub(super) n_joined: usize,
    /// The unit of length of what was evaluated last.
    pub(super) unit: Unit,
    pub(super) folder: PathBuf,
    pub(super) out: Option<PathBuf>,
    /// The file that the document was read from or written to.
    pub(super) file: Option<PathBuf>,
    pub(super) columns: usize,
    /// Columns that are used in the place of those of the terminal.
    pub(super) width: Option<usize>,
    pub(super) is_terminal: bool,
    pub(super) with_color: bool,
    pub(super) worst: ExitStatus,
    pub(super) is_over: bool,
}

impl Prompt {
    pub(super) fn limits(&self) -> &Limits {
        self.engine.session().limits()
    }

    /// Tells a value.
    pub(super) fn answer(&self, value: &Value) {
        let text = value.in_unit(self.unit.name()).to_string();
        if self.is_terminal && text.len() > MOST_CHARS {
            say(&format!("{}\n", show::cut(&text, MOST_CHARS)));
            self.voice.remark(&format!("({} bytes in all; `:show` tells it in short)", text.len()));
        } else {
            say(&format!("{text}\n"));
        }
    }

    /// The values of expressions on the document; the last one is `_` from now on. What is wrong
    /// with them is told.
    pub(super) fn ask(&mut self, question: &str) -> Option<(Vec<Printed>, Duration)> {
        let (printed, time) = self.question(question)?;
        self.remember(question, &printed);
        Some((printed, time))
    }

    /// The same without an effect on `_`.
    pub(super) fn question(&mut self, question: &str) -> Option<(Vec<Printed>, Duration)> {
        let places = free_placeholders(question);
        let (mut text, mut last) = (question.to_owned(), String::new());
        if !places.is_empty() {
            let Some(value) = &self.last else {
                self.refuse("`_` is the last value, and there is none yet");
                return None;
            };
            last = format!("let {LAST} = {value}\n");
            places.into_iter().rev().for_each(|place| text.replace_range(place, LAST));
        }
        last.push_str("print");
        let ran = self.answered(&last, &text)?;
        let EngineRun { report, time, .. } = ran;
        let printed: Vec<Printed> = report
            .events
            .into_iter()
            .filter_map(|event| match event {
                Event::Printed(printed) => Some(printed),
                _ => None,
            })
            .collect();
        Some((printed, time))
    }

    /// Evaluates a question behind what it can reach of the document. Where there is anything to tell it is
    /// evaluated behind all of it: what is told depends on all names, and on what was told before.
    fn answered(&mut self, before: &str, question: &str) -> Option<EngineRun> {
        let names = ["document", "input"];
        let asked = format!("{before} {question}");
        let (base, known) = if self.values_hold() {
            let part = ConcernedPart::of_question(self.document.settings(), &asked);
            let known = self.known(&part.used);
            (part.base, known)
        } else {
            (self.document.reached_from(&asked), Vec::new())
        };
        let Some(ran) = self.engine.run_aside(known, &(base + before), question, names) else {
            return self.stopped();
        };
        if ran.report.diagnostics.is_empty() {
            self.unit = ran.report.document.0;
            return Some(ran);
        }
        let base = self.document.definitions() + before;
        self.evaluate(&base, ' ', question, names)
    }

    /// Tells that there is no answer.
    fn stopped(&self) -> Option<EngineRun> {
        self.voice.remark("stopped; the document is as it was");
        None
    }

    /// Keeps what `_` stands for: a value that can be written as it is, any other as its question.
    pub(super) fn remember(&mut self, question: &str, printed: &[Printed]) {
        let Some(newest) = printed.last() else { return };
        let text = if show::is_written(&newest.value) {
            newest.value_text()
        } else {
            let before = self.last.clone().unwrap_or_default();
            let mut source = match printed {
                [_] => question.to_owned(),
                _ => newest.source.replace(LAST, "_"),
            };
            for place in free_placeholders(&source).into_iter().rev() {
                source.replace_range(place, &before);
            }
            format!("({}\n)", source.trim_end())
        };
        self.last = Some(text).filter(|text| text.len() <= MOST_LAST);
    }

    /// Evaluates a text behind the document. Nothing comes of it when there are errors, which are
    /// told, or when it was stopped. Errors in imported files that take nothing from the document are told
    /// as warnings are, once.
    pub(super) fn evaluate(
        &mut self,
        base: &str,
        gap: char,
        text: &str,
        names: [&str; 2],
    ) -> Option<EngineRun> {
        let Some(mut ran) = self.engine.run(base, gap, text, names) else {
            return self.stopped();
        };
        let is_error = |found: &Diagnostic| found.severity == Severity::Error;
        let is_imported = |found: &Diagnostic| ran.end < found.primary.span.start;
        let mut errors = ran.report.diagnostics.iter().filter(|found| is_error(found));
        if !(ran.report.is_whole && errors.clone().all(is_imported)) && errors.next().is_some() {
            ran.report.diagnostics.retain(|found| found.severity == Severity::Error);
            self.voice.findings(&ran.report.diagnostics, &ran.report.sources);
            self.worst = self.worst.max(ExitStatus::Wrong);
            return None;
        }
        let told = |found: &Diagnostic| format!("{} {}", found.code.id(), found.message);
        let found = std::mem::take(&mut ran.report.diagnostics);
        let (new, old): (Vec<_>, Vec<_>) =
            found.into_iter().partition(|found| !self.told.contains(&told(found)));
        // What was told of a question is told again of the next.
        if gap == '\n' {
            self.told = new.iter().chain(&old).map(told).collect();
        }
        let is_told =
            |found: &Diagnostic| matches!(found.severity, Severity::Warning | Severity::Error);
        let (warnings, others): (Vec<_>, Vec<_>) = new.into_iter().partition(is_told);
        self.voice.findings(&warnings, &ran.report.sources);
        if warnings.iter().any(is_error) {
            self.worst = self.worst.max(ExitStatus::Wrong);
        }
        ran.report.diagnostics = others;
        self.unit = ran.report.document.0;
        Some(ran)
    }

    /// Takes statements into the document and does what they want; what is wrong is told.
    pub(super) fn state(&mut self, text: &str) {
        let draft = match self.document.draft(text, self.limits()) {
            Ok(draft) => draft,
            Err(found) => return self.tell_wrong("input", text, &found),
        };
        match self.joined(&draft, text) {
            PartRun::Holds(ran) => return self.welcome(*ran, draft, EvaluatedExtent::Part),
            PartRun::Stopped => {
                self.stopped();
                return;
            }
            PartRun::WantsAll => {}
        }
        let told = self.told.clone();
        match self.evaluate(&draft.base(&self.document), '\n', text, ["document", "input"]) {
            Some(ran) => self.welcome(ran, draft, EvaluatedExtent::Whole),
            None => self.told = told,
        }
    }

    /// Takes in the statements of a draft that hold, and tells what they came to.
    fn welcome(&mut self, ran: EngineRun, draft: Draft, extent: EvaluatedExtent) {
        let EngineRun { mut report, start, time, .. } = ran;
        let is_new = |span: crate::diag::Span| span.start >= start;
        let (mut news, mut again) = (Vec::new(), Vec::new());
        for defined in &report.definitions {
            match (&defined.value, defined.work) {
                (Some(value), _) if is_new(defined.span) => {
                    news.push(show::line(&defined.name, value, self.unit));
                }
                (_, Work::Evaluated) => again.push(defined.name.as_str()),
                _ => {}
            }
        }
        news.iter().for_each(|line| say(&format!("{line}\n")));
        if draft.replaces() || !again.is_empty() {
            let n_beside = match extent {
                EvaluatedExtent::Whole => 0,
                EvaluatedExtent::Part => self.n_beside(&report, &draft.lost),
            };
            let n_reused = report.n_with(Work::Reused) + n_beside;
            self.voice.remark(&show::evaluated(&again, n_reused, time));
        }
        if !draft.lost.is_empty() {
            let names = draft.lost.join("`, `");
            self.voice.remark(&format!("`{names}` went with what was replaced"));
        }
        report.events.retain(|event| match event {
            Event::Checked(checked) => is_new(checked.span),
            _ => true,
        });
        if self.document.count(StatementRole::Test) < draft.next.count(StatementRole::Test) {
            self.voice.remark("(`virote test` runs it once the document is saved)");
        }
        if !draft.next.is_same(&self.document) {
            let before = std::mem::replace(&mut self.document, draft.next);
            self.undo.push(before, self.last.clone());
        }
        self.act(&mut report);
        match extent {
            EvaluatedExtent::Part => self.know_part(&report, &draft.lost),
            EvaluatedExtent::Whole => self.know(report),
        }
    }

    /// The definitions with their values.
    pub(super) fn defined(&self) -> impl Iterator<Item = (&str, &Value)> {
        let definitions = self.values.report().definitions.iter();
        definitions.filter_map(|defined| Some((defined.name.as_str(), defined.value.as_ref()?)))
    }

    /// Prints, judges, writes.
    pub(super) fn act(&mut self, report: &mut Report) {
        let out = self.out.clone().unwrap_or_else(|| self.folder.clone());
        let mut inputs = self.engine.inputs();
        inputs.extend(self.file.clone());
        let targets = run::targets(report, &out, &inputs);
        let progress = Progress::begin("writing", self.voice.is_lively());
        let mode = run::OutputMode::Write(Some(&out));
        let ending = run::act(report, &targets, (mode, true), progress, &self.voice);
        self.worst = self.worst.max(ending);
    }

    /// Keeps the values of a document that holds.
    pub(super) fn know(&mut self, report: Report) {
        self.values = Arc::new(Values::new(Arc::new(report)));
        self.values_of = Arc::downgrade(self.engine.session());
        self.n_joined = 0;
    }

    pub(super) fn tell_wrong(&mut self, name: &str, text: &str, found: &[Diagnostic]) {
        let mut sources = Sources::default();
        sources.add(name, text.into());
        self.voice.findings(found, &sources);
        self.worst = self.worst.max(ExitStatus::Wrong);
    }

    /// Tells what cannot be done.
    pub(super) fn refuse(&mut self, text: &str) {
        self.voice.trouble(text);
        self.worst = self.worst.max(ExitStatus::Wrong);
    }

    /// The values of an expression that a command wants, which must be there.
    pub(super) fn asked(&mut self, command: &str, text: &str) -> Option<Vec<Value>> {
        if text.is_empty() {
            self.refuse(&format!("of what? `:{command} EXPR`"));
            return None;
        }
        let (printed, _) = self.ask(text)?;
        Some(printed.into_iter().map(|printed| printed.value).collect())
    }
}
