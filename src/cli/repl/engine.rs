//! Evaluation that can be waited for and given up: on a thread of its own, stopped by Ctrl-C.

use std::{
    path::Path,
    sync::{Arc, mpsc},
    thread,
    time::{Duration, Instant},
};

use super::super::{interrupt::INTERRUPTED, run_args::RunArgs};
use crate::{
    diag::Sources,
    disk::ScriptFiles,
    eval::{Defined, Setting},
    limits::{Limits, work::StopToken},
    session::{Report, Session},
};

/// How often a run that is waited for is asked whether Ctrl-C was pressed.
const PATIENCE: Duration = Duration::from_millis(20);

/// How long a run may take to its next step, once it is to stop.
const GRACE: Duration = Duration::from_millis(1500);

/// Evaluates texts; remembers what it evaluated.
pub(super) struct Engine {
    session: Arc<Session>,
    /// The switch that stops the session's run.
    stop: StopToken,
    files: Arc<ScriptFiles>,
    settings: Arc<[Setting]>,
    ceilings: Limits,
    renew: Box<dyn Fn(Limits, StopToken) -> Session>,
}

/// A run that came to its end.
pub(super) struct EngineRun {
    /// What became of it; its places lie in the document or in the input.
    pub(super) report: Report,
    /// The first place of the input.
    pub(super) start: u32,
    /// The place behind it; what lies further on is imported.
    pub(super) end: u32,
    /// How long it took.
    pub(super) time: Duration,
}

impl Engine {
    pub(super) fn new(common: &RunArgs, folder: &Path, settings: Vec<Setting>) -> Self {
        let (ceilings, n_threads) = (common.ceilings(), common.n_threads());
        let renew = move |ceilings, stop| {
            super::super::process::session(ceilings)
                .on_threads(n_threads)
                .incremental()
                .stopped_by(stop)
        };
        let stop = StopToken::default();
        Self {
            session: Arc::new(renew(ceilings, stop.clone())),
            stop,
            files: Arc::new(ScriptFiles::new(folder)),
            settings: settings.into(),
            ceilings,
            renew: Box::new(renew),
        }
    }

    /// Evaluates under other ceilings from now on; what was evaluated before is forgotten.
    pub(super) fn set_limits(&mut self, ceilings: Limits) {
        self.ceilings = ceilings;
        self.session = Arc::new((self.renew)(ceilings, self.stop.clone()));
    }

    pub(super) fn session(&self) -> &Arc<Session> {
        &self.session
    }

    /// The files that were read.
    pub(super) fn inputs(&self) -> Vec<std::path::PathBuf> {
        self.files.inputs()
    }

    /// Reads files beside another document from now on; what was read beside the one before.
    pub(super) fn move_to(&mut self, folder: &Path) -> Arc<ScriptFiles> {
        std::mem::replace(&mut self.files, Arc::new(ScriptFiles::new(folder)))
    }

    /// Goes back to the document that files were read beside before.
    pub(super) fn move_back(&mut self, files: Arc<ScriptFiles>) {
        self.files = files;
    }

    /// Evaluates `input` behind `base`, with `gap` between them; `None` if it was stopped.
    /// The texts are called by `names` in messages.
    pub(super) fn run(
        &mut self,
        base: &str,
        gap: char,
        input: &str,
        names: [&str; 2],
    ) -> Option<EngineRun> {
        self.run_in(Arc::clone(&self.session), (base, gap, input), names)
    }

    /// The same where `base` is a part of a document, which uses what is `known`; the rest stays evaluated.
    pub(super) fn run_aside(
        &mut self,
        known: Vec<Defined>,
        base: &str,
        input: &str,
        names: [&str; 2],
    ) -> Option<EngineRun> {
        self.run_in(Arc::new(self.session.aside(known)), (base, ' ', input), names)
    }

    /// The same where what the part gives is to stay evaluated too.
    pub(super) fn run_joining(
        &mut self,
        known: Vec<Defined>,
        base: &str,
        input: &str,
        names: [&str; 2],
    ) -> Option<EngineRun> {
        self.run_in(Arc::new(self.session.joining(known)), (base, '\n', input), names)
    }

    fn run_in(
        &mut self,
        session: Arc<Session>,
        (base, gap, input): (&str, char, &str),
        names: [&str; 2],
    ) -> Option<EngineRun> {
        let text = format!("{base}{gap}{input}");
        let end = text.len() as u32;
        let files = Arc::clone(&self.files);
        let settings = Arc::clone(&self.settings);
        let (sender, receiver) = mpsc::channel();
        INTERRUPTED.reset();
        let begin = Instant::now();
        let work = move || {
            let report = session.run("input", text.as_bytes(), &*files, &settings);
            // Nobody listens where the run was given up.
            let _ = sender.send(report);
        };
        thread::Builder::new().spawn(work).ok()?;
        let mut report = self.wait(&receiver)?;
        let time = begin.elapsed();
        report.sources = told_apart(&report.sources, base.len(), names);
        let start = base.len() as u32 + gap.len_utf8() as u32;
        Some(EngineRun { report, start, end, time })
    }

    /// Waits for the end of a run, or for Ctrl-C.
    fn wait(&mut self, receiver: &mpsc::Receiver<Report>) -> Option<Report> {
        let mut deadline = None;
        loop {
            match receiver.recv_timeout(PATIENCE) {
                Ok(report) => {
                    let was_stopped = self.stop.reset();
                    return (!was_stopped).then_some(report);
                }
                Err(mpsc::RecvTimeoutError::Disconnected) => return None,
                Err(mpsc::RecvTimeoutError::Timeout) => {}
            }
            if INTERRUPTED.is_stopped() && deadline.is_none() {
                self.stop.stop();
                deadline = Some(Instant::now() + GRACE);
            }
            if deadline.is_some_and(|deadline| deadline < Instant::now()) {
                // An operation that looks at no switch: it is left to itself, and the next run has
                // a session that knows nothing of it.
                self.stop = StopToken::default();
                self.session = Arc::new((self.renew)(self.ceilings, self.stop.clone()));
                return None;
            }
        }
    }
}

/// The sources with the text of the document and that of the input apart: they lie end to end with
/// one byte between them either way, so that every place stays where it is.
fn told_apart(sources: &Sources, base_len: usize, names: [&str; 2]) -> Sources {
    let mut apart = Sources::default();
    for (i, source) in sources.iter().enumerate() {
        if i > 0 {
            apart.add(source.name.as_str(), Arc::clone(&source.text));
        } else if let (Some(base), Some(input)) =
            (source.text.get(..base_len), source.text.get(base_len + 1..))
        {
            apart.add(names[0], Arc::from(base));
            apart.add(names[1], Arc::from(input));
        } else {
            apart.add(names[1], Arc::clone(&source.text));
        }
    }
    apart
}
