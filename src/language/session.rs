//! A script from text to outcome: parse, evaluate, and plan the files that it exports.
//!
//! The session touches no file, clock or terminal. The doors hand in the text and a [`Files`] to
//! read data through, and write what the [`Report`] plans.

mod call;
mod exact_data;
mod extra;
mod file;
mod gate;
mod inspect;
mod memory;
mod options;
mod path;
mod picture;
mod plan;
mod remembered;
mod review;
mod stop;
mod test;
mod text_extent;

use std::sync::Arc;

pub use call::Arguments;
pub use extra::{ControlStyle, Extra, STRIPES};
pub use file::File;
pub use gate::JobGate;
use memory::SessionMemory;
pub use picture::PictureContent;
pub use picture::{drawable, exported, small_picture};
pub use test::{TestReport, TestVerdict};
use text_extent::TextExtent;

pub use crate::ops::loaded_endings;

use crate::{
    diag::{Code, Diagnostic, Severity, Sources, Span, fault, n_errors},
    eval::{self, EffectOutput, Purpose, Setting, Work},
    export::MeshMemory,
    kernel::Tolerance,
    limits::{
        Ceiling, Limits, stack,
        work::{MemoryGauge, StopToken},
    },
    ops,
    syntax::ast::Unit,
    value::{Files, Registry, Value, stranger},
};

/// Interprets scripts. Clones share what they remember.
#[derive(Clone, Debug)]
pub struct Session {
    registry: Arc<Registry>,
    limits: Limits,
    n_threads: usize,
    /// Of an incremental session.
    memory: Option<Arc<SessionMemory>>,
    /// What of a text it runs.
    extent: TextExtent,
    gauge: MemoryGauge,
    stop: StopToken,
}

/// One thing that a script says or does, in the order of the source.
#[derive(Debug)]
pub enum Event {
    /// `source = value`
    Printed(eval::Printed),
    /// A claim and how it came out.
    Checked(eval::Checked),
    /// A file to be written.
    File(Box<File>),
    /// An error that a test expects, and what happened.
    Expected(eval::ExpectedMistake),
}

/// What became of a script.
#[derive(Debug)]
pub struct Report {
    /// The texts that places point into.
    pub sources: Sources,
    /// Every finding, in the order of the source.
    pub diagnostics: Vec<Diagnostic>,
    /// What the script says and does.
    pub events: Vec<Event>,
    /// What its tests came to, as far as they were run.
    pub tests: Vec<TestReport>,
    /// The unit of length, and the tolerance.
    pub document: (Unit, Tolerance),
    /// Its definitions.
    pub definitions: Vec<eval::Defined>,
    /// Settings that no parameter takes, each a sentence.
    pub unknown_settings: Vec<String>,
    /// Meshes of its files.
    pub(crate) meshes: MeshMemory,
    /// Whether nothing of the script itself lacks a value; of what it imports a part is enough.
    pub is_whole: bool,
    /// Errors outside of its tests.
    n_untested_errors: usize,
}

impl Report {
    /// The value of a definition, if there is one of this name and it could be evaluated. Like every
    /// value that a report tells it owns what it needs to answer, also when the report is gone.
    ///
    /// ```
    /// use virote_language::{session::Session, value::{NoFiles, Value}};
    ///
    /// let report = Session::default().run("demo", b"curve c = parametric(t => (t, t^2), 0..1)", &NoFiles, &[]);
    /// let value = report.value("c").expect("it is defined");
    /// drop(report);
    /// let Value::Curve(curve) = value else { panic!("it is a curve") };
    /// assert_eq!(curve.point_at(0.5)?.y, 0.25);
    /// # Ok::<(), virote_language::kernel::GeomError>(())
    /// ```
    #[must_use]
    pub fn value(&self, name: &str) -> Option<Value> {
        self.definitions.iter().find(|defined| defined.name == name)?.value.clone()
    }

    /// How many findings are of a severity.
    #[must_use]
    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|found| found.severity == severity).count()
    }

    /// Whether memory ran out.
    #[must_use]
    pub fn is_out_of_memory(&self) -> bool {
        self.diagnostics.iter().any(|found| found.ceiling == Some(Ceiling::MEMORY))
    }

    /// How many definitions came by their value in this way.
    #[must_use]
    pub fn n_with(&self, work: Work) -> usize {
        self.definitions.iter().filter(|defined| defined.work == work).count()
    }
}

impl Default for Session {
    fn default() -> Self {
        Self::new(Limits::DEFAULT)
    }
}

impl Session {
    /// A session with all built-ins and these ceilings.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        Self {
            registry: Arc::new(ops::registry()),
            limits,
            n_threads: 1,
            memory: None,
            extent: TextExtent::Whole,
            gauge: MemoryGauge::default(),
            stop: StopToken::default(),
        }
    }

    /// The same on up to `n_threads` threads; results and messages do not depend on their number.
    #[must_use]
    pub fn on_threads(self, n_threads: usize) -> Self {
        Self { n_threads: n_threads.max(1), ..self }
    }

    /// The same with a memory: a run evaluates only definitions that are new, and those that use
    /// something that changed, wherever they stand. Its report is that of a session without a memory
    /// but for [`Defined::work`](eval::Defined::work), which tells what was evaluated.
    ///
    /// A change is one of the definition itself, of a definition that it uses, of the document's
    /// unit or tolerance, of the value that a parameter is given, or of a file that it reads.
    /// Comments, places and the order of definitions are none. `check`, `print` and `export` are
    /// carried out in each run. What a run did not use is forgotten; after one with errors also
    /// what the last one without errors used is kept.
    ///
    /// ```
    /// use virote_language::{eval::Work, session::Session, value::NoFiles};
    ///
    /// let session = Session::default().incremental();
    /// let run = |text: &str| session.run("demo", text.as_bytes(), &NoFiles, &[]);
    ///
    /// assert_eq!(run("let a = 1  let b = a + 1  let c = 3").n_with(Work::Evaluated), 3);
    /// // An edit of `b`, and a comment.
    /// let report = run("let a = 1 /* one */  let b = a + 2  let c = 3");
    /// assert_eq!(report.n_with(Work::Reused), 2);
    /// assert_eq!(report.definitions[1].work, Work::Evaluated);
    /// ```
    #[must_use]
    pub fn incremental(self) -> Self {
        Self { memory: Some(Arc::default()), ..self }
    }

    /// The built-ins.
    #[must_use]
    pub fn registry(&self) -> &Registry {
        &self.registry
    }

    /// The ceilings.
    #[must_use]
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Interprets the script `bytes`, which messages call `name`.
    ///
    /// ```
    /// use virote_language::{session::{Event, Session}, value::NoFiles};
    ///
    /// let report = Session::default().run("demo", b"print 2 * pi > 6", &NoFiles, &[]);
    /// assert!(report.diagnostics.is_empty());
    /// assert!(matches!(&report.events[0], Event::Printed(line) if line.value.to_string() == "true"));
    /// ```
    #[must_use]
    pub fn run(&self, name: &str, bytes: &[u8], files: &dyn Files, settings: &[Setting]) -> Report {
        self.interpret(name, bytes, files, settings, Purpose::Run)
    }

    /// Does the work with the stack that the ceilings need, or with ceilings that fit the stack that is
    /// to be had.
    fn on_stack<R: Send>(&self, mut work: impl FnMut(&Limits) -> R + Send) -> R {
        stack::with(self.limits.stack_bytes, |bytes| work(&self.limits.on_stack(bytes)))
    }

    fn interpret(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
        settings: &[Setting],
        purpose: Purpose<'_>,
    ) -> Report {
        let attempt_on = |n_threads, limits: &Limits| {
            let how = (purpose, n_threads, limits);
            let attempt = || Ok(self.attempt(name, bytes, files, settings, how));
            fault::caught(Span::default(), attempt).unwrap_or_else(|told| {
                let mut sources = Sources::default();
                sources.add(name, String::from_utf8_lossy(bytes).into());
                self.findings(sources, vec![*told])
            })
        };
        let attempt = |n_threads| self.on_stack(|limits| attempt_on(n_threads, limits));
        let remembers = self.memory.as_ref().filter(|memory| !memory.results.is_empty());
        let report = attempt(self.n_threads);
        if self.n_threads == 1 && remembers.is_none() || !report.is_out_of_memory() {
            return report;
        }
        // Where memory ends depends on what else is under way, and on what runs before have left: one thread
        // with nothing remembered gives one answer.
        drop(report);
        if let Some(memory) = remembers {
            memory.forget();
        }
        attempt(1)
    }

    fn attempt(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
        settings: &[Setting],
        (purpose, n_threads, limits): (Purpose<'_>, usize, &Limits),
    ) -> Report {
        let mut sources = Sources::default();
        let text = match self.read(bytes) {
            Ok(text) => text,
            Err((text, diagnostic)) => {
                sources.add(name, Arc::from(text));
                return self.findings(sources, vec![*diagnostic]);
            }
        };
        let recall = self.memory.as_ref().map(|memory| memory.results.begin());
        let meshes = self.memory.as_ref().map(|memory| memory.meshes.begin()).unwrap_or_default();
        let settings = eval::Settings {
            registry: &self.registry,
            limits,
            files,
            overrides: settings,
            n_threads,
            purpose,
            recall: recall.as_ref(),
            known: self.extent.known(),
            gauge: &self.gauge,
            stop: &self.stop,
        };
        let outcome = eval::evaluate(name, text, &mut sources, settings);
        if let Some(recall) = recall {
            self.extent.end(recall, 0 < n_errors(&outcome.diagnostics));
        }
        let mut diagnostics = outcome.diagnostics;
        let document = (outcome.unit, outcome.tolerance);
        let context = (document, &meshes);
        let events = self.events(outcome.outputs, context, &mut diagnostics);
        eval::in_order(&mut diagnostics);
        let n_untested_errors = n_errors(&diagnostics);
        let tested =
            outcome.tests.into_iter().map(|test| self.tested(test, context, &mut diagnostics));
        let tests = tested.collect();
        let mut report = Report {
            events,
            tests,
            document,
            definitions: outcome.definitions,
            unknown_settings: outcome.unknown_settings,
            meshes,
            is_whole: outcome.is_whole,
            n_untested_errors,
            ..self.findings(sources, diagnostics)
        };
        self.compose(&mut report, (name, text), (files, limits));
        eval::in_order(&mut report.diagnostics);
        report
    }

    /// What was found in a script that does not run.
    fn findings(&self, sources: Sources, diagnostics: Vec<Diagnostic>) -> Report {
        let n_untested_errors = n_errors(&diagnostics);
        Report {
            sources,
            diagnostics,
            events: Vec::new(),
            tests: Vec::new(),
            document: (Unit::Mm, Tolerance::DEFAULT),
            definitions: Vec::new(),
            unknown_settings: Vec::new(),
            meshes: MeshMemory::default(),
            is_whole: false,
            n_untested_errors,
        }
    }

    /// The text of a script, or as much of it as a message can show.
    fn read<'b>(&self, bytes: &'b [u8]) -> Result<&'b str, (String, Box<Diagnostic>)> {
        if bytes.len() > self.limits.source_bytes {
            let most = self.limits.source_bytes;
            let message = format!("the script is larger than the ceiling of {most} bytes");
            return Err((
                String::new(),
                Box::new(
                    Diagnostic::error(Code::SourceTooLarge, Span::default(), message)
                        .crossing(Ceiling::SOURCE_BYTES),
                ),
            ));
        }
        std::str::from_utf8(bytes).map_err(|err| {
            let at = err.valid_up_to();
            let text = String::from_utf8_lossy(bytes).into_owned();
            // The replacement of the first bad byte stands at the same place.
            let place = Span::new(at as u32, at as u32 + 3);
            let message = format!("byte {} of the file is not UTF-8 text", at + 1);
            let diagnostic = Diagnostic::error(Code::NotUtf8, place, message)
                .label(format!("the byte {:#04x}", bytes[at]))
                .hint(stranger(bytes).unwrap_or("save the file as UTF-8 in the editor"));
            (text, Box::new(diagnostic))
        })
    }

    /// Outputs as events, with the files that they make; what is wrong with these goes to
    /// `diagnostics`.
    fn events(
        &self,
        outputs: Vec<EffectOutput>,
        context: plan::PlanContext<'_>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Vec<Event> {
        let mut events = Vec::new();
        let mut written = path::WrittenPaths::default();
        for output in outputs {
            match output {
                EffectOutput::Printed(printed) => events.push(Event::Printed(printed)),
                EffectOutput::Checked(checked) => events.push(Event::Checked(checked)),
                EffectOutput::Expected(expected) => events.push(Event::Expected(expected)),
                EffectOutput::Exported(exported) => {
                    let span = exported.path.span;
                    let planned =
                        fault::caught(span, || Ok(self.plan(exported, context, diagnostics)));
                    let planned = planned.unwrap_or_else(|told| {
                        diagnostics.push(*told);
                        None
                    });
                    let Some(file) = planned else { continue };
                    match written.add(&file.path, file.span) {
                        Some(((message, hint), first)) => {
                            diagnostics.push(
                                Diagnostic::error(Code::DuplicateExport, file.span, message)
                                    .also(first, "exported here before")
                                    .hint(hint),
                            );
                            // Nobody knows which of the two is meant.
                            events.retain(|event| match event {
                                Event::File(file) => file.span != first,
                                _ => true,
                            });
                        }
                        None => {
                            events.push(Event::File(Box::new(file)));
                        }
                    }
                }
            }
        }
        events
    }
}
