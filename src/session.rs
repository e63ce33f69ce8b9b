//! A script from text to outcome: parse, evaluate, and plan the files that it exports.
//!
//! The session touches no file, clock or terminal. The doors hand in the text and a [`Files`] to
//! read data through, and write what the [`Report`] plans.

mod ceiling;
mod extra;
mod inspect;
mod options;
mod path;
mod picture;
mod plan;
mod stop;
mod test;

use std::sync::{Arc, atomic::AtomicBool};

pub use ceiling::name_flag;
pub use extra::Extra;
pub use picture::PictureContent;
pub use test::{TestReport, TestVerdict};

use crate::{
    diag::{Code, Diagnostic, Severity, Sources, Span, fault},
    eval::{self, EffectOutput, Memory, Purpose, Setting, Work},
    export::{Format, Job},
    kernel::Tolerance,
    limits::{Ceiling, Limits},
    ops,
    syntax::ast::Unit,
    value::{Files, Registry, stranger},
};

/// Interprets scripts.
#[derive(Debug)]
pub struct Session {
    registry: Registry,
    limits: Limits,
    n_threads: usize,
    /// Of an incremental session.
    memory: Option<Memory>,
    held: fn() -> usize,
    stop: &'static AtomicBool,
}

/// A file that a script exports, ready to be written.
#[derive(Debug)]
pub struct File {
    /// The path below the output folder, with `/` between its parts.
    pub path: String,
    /// Where the script gives the path.
    pub span: Span,
    /// The definitions that its subjects name.
    pub names: Vec<String>,
    /// How it is written.
    pub format: &'static Format,
    /// What is written.
    pub job: Job,
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
    /// What parametric curves and surfaces need to answer: keep it as long as the values.
    pub kept: eval::KeptGlobals,
}

impl Report {
    /// How many findings are of a severity.
    #[must_use]
    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|found| found.severity == severity).count()
    }

    /// Whether memory ran out.
    #[must_use]
    pub fn is_out_of_memory(&self) -> bool {
        self.diagnostics.iter().any(|found| {
            Ceiling::crossed(found.code.id(), &found.message)
                .is_some_and(|ceiling| ceiling.name == Ceiling::MEMORY)
        })
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
        let stop = &stop::NEVER;
        Self { registry: ops::registry(), limits, n_threads: 1, memory: None, held: || 0, stop }
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
    /// use virote::{eval::Work, session::Session, value::Files};
    ///
    /// #[derive(Debug)]
    /// struct NoFiles;
    /// impl Files for NoFiles {
    ///     fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
    ///         Err(format!("there is no `{path}`"))
    ///     }
    /// }
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
        Self { memory: Some(Memory::default()), ..self }
    }

    /// How many results an incremental session remembers.
    #[must_use]
    pub fn n_remembered(&self) -> usize {
        self.memory.as_ref().map_or(0, Memory::len)
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
    /// use virote::{session::{Event, Session}, value::Files};
    ///
    /// #[derive(Debug)]
    /// struct NoFiles;
    /// impl Files for NoFiles {
    ///     fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
    ///         Err(format!("there is no `{path}`"))
    ///     }
    /// }
    ///
    /// let report = Session::default().run("demo", b"print 2 * pi > 6", &NoFiles, &[]);
    /// assert!(report.diagnostics.is_empty());
    /// assert!(matches!(&report.events[0], Event::Printed(line) if line.value.to_string() == "true"));
    /// ```
    #[must_use]
    pub fn run(&self, name: &str, bytes: &[u8], files: &dyn Files, settings: &[Setting]) -> Report {
        self.interpret(name, bytes, files, settings, Purpose::Run)
    }

    fn interpret(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
        settings: &[Setting],
        purpose: Purpose<'_>,
    ) -> Report {
        let attempt = |n_threads| {
            let attempt = || Ok(self.attempt(name, bytes, files, settings, (purpose, n_threads)));
            fault::caught(Span::default(), attempt).unwrap_or_else(|told| {
                let mut sources = Sources::default();
                sources.add(name, String::from_utf8_lossy(bytes).into());
                self.findings(sources, vec![*told])
            })
        };
        let report = attempt(self.n_threads);
        if self.n_threads == 1 || !report.is_out_of_memory() {
            return report;
        }
        // Where memory ends depends on what else is under way: one thread gives one answer.
        drop(report);
        attempt(1)
    }

    fn attempt(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
        settings: &[Setting],
        (purpose, n_threads): (Purpose<'_>, usize),
    ) -> Report {
        let mut sources = Sources::default();
        let text = match self.read(bytes) {
            Ok(text) => text,
            Err((text, diagnostic)) => {
                sources.add(name, Arc::from(text));
                return self.findings(sources, vec![*diagnostic]);
            }
        };
        let recall = self.memory.as_ref().map(Memory::begin);
        let settings = eval::Settings {
            registry: &self.registry,
            limits: &self.limits,
            files,
            overrides: settings,
            n_threads,
            purpose,
            recall: recall.as_ref(),
            held: self.held,
            stop: self.stop,
        };
        let outcome = eval::evaluate(name, text, &mut sources, settings);
        if let Some(recall) = recall {
            recall.end(outcome.diagnostics.iter().any(|found| found.severity == Severity::Error));
        }
        let mut diagnostics = outcome.diagnostics;
        let document = (outcome.unit, outcome.tolerance);
        let events = self.events(outcome.outputs, document, &mut diagnostics);
        let tested =
            outcome.tests.into_iter().map(|test| self.tested(test, document, &mut diagnostics));
        let tests = tested.collect();
        eval::in_order(&mut diagnostics);
        Report {
            events,
            tests,
            document,
            definitions: outcome.definitions,
            unknown_settings: outcome.unknown_settings,
            kept: outcome.kept,
            ..self.findings(sources, diagnostics)
        }
    }

    /// What was found in a script that does not run, with the flags of crossed ceilings.
    fn findings(&self, sources: Sources, mut diagnostics: Vec<Diagnostic>) -> Report {
        diagnostics.iter_mut().for_each(ceiling::name_flag);
        Report {
            sources,
            diagnostics,
            events: Vec::new(),
            tests: Vec::new(),
            document: (Unit::Mm, Tolerance::DEFAULT),
            definitions: Vec::new(),
            unknown_settings: Vec::new(),
            kept: eval::KeptGlobals::default(),
        }
    }

    /// The text of a script, or as much of it as a message can show.
    fn read<'b>(&self, bytes: &'b [u8]) -> Result<&'b str, (String, Box<Diagnostic>)> {
        if bytes.len() > self.limits.source_bytes {
            let most = self.limits.source_bytes;
            let message = format!("the script is larger than the ceiling of {most} bytes");
            return Err((
                String::new(),
                Box::new(Diagnostic::error(Code::SourceTooLarge, Span::default(), message)),
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
        document: (Unit, Tolerance),
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
                        fault::caught(span, || Ok(self.plan(exported, document, diagnostics)));
                    let planned = planned.unwrap_or_else(|told| {
                        diagnostics.push(*told);
                        None
                    });
                    let Some(file) = planned else { continue };
                    match written.add(&file.path, file.span) {
                        Some(((message, hint), first)) => diagnostics.push(
                            Diagnostic::error(Code::DuplicateExport, file.span, message)
                                .also(first, "exported here before")
                                .hint(hint),
                        ),
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
