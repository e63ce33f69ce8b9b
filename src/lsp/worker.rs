//! The thread that evaluates: the newest text of each document, and never one that was edited since.

use std::{
    collections::BTreeMap,
    path::PathBuf,
    sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError},
    time::{Duration, Instant},
};

use crossbeam_channel::Sender;

use super::paths::OverlaidFiles;
use crate::{
    diag::Code,
    limits::work::StopToken,
    session::{Report, Session},
};

/// A run that is evaluated while the text of another document changes may go on for so long.
const PATIENCE: Duration = Duration::from_millis(300);
/// How long a pause in typing is waited for at least: nobody reads what is told between two keys of a burst.
const SHORTEST_PAUSE: Duration = Duration::from_millis(12);
/// And at most, where runs take long.
const LONGEST_PAUSE: Duration = Duration::from_millis(250);
/// Documents whose results are remembered.
const MOST_REMEMBERED: usize = 16;

/// A text to be evaluated.
#[derive(Clone, Debug)]
pub(super) struct EvaluationRequest {
    /// The address of the document.
    pub(super) uri: String,
    /// Which of its texts it is.
    pub(super) serial: u64,
    /// What messages call it.
    pub(super) name: String,
    /// Where its files lie.
    pub(super) folder: PathBuf,
    pub(super) text: Arc<str>,
    /// The texts of open documents.
    pub(super) open: Arc<BTreeMap<PathBuf, Arc<str>>>,
}

/// What became of it.
#[derive(Debug)]
pub(super) struct Evaluated {
    pub(super) uri: String,
    pub(super) serial: u64,
    pub(super) report: Arc<Report>,
}

#[derive(Default)]
struct EvaluationQueueState {
    /// The newest text of each document, not to be begun before a moment.
    jobs: BTreeMap<String, (Instant, EvaluationRequest)>,
    /// Documents that are closed, whose results are to be forgotten.
    closed: Vec<String>,
    running: Option<(String, Instant)>,
    /// Whether the run under way is to be done again.
    is_interrupted: bool,
    /// How long the last run of each document took.
    took: BTreeMap<String, Duration>,
    is_over: bool,
}

/// What the thread and the server share.
#[derive(Default)]
pub(super) struct EvaluationQueue {
    wanted: Mutex<EvaluationQueueState>,
    changed: Condvar,
    stop: StopToken,
}

impl EvaluationQueue {
    fn lock(&self) -> MutexGuard<'_, EvaluationQueueState> {
        self.wanted.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The switch of the sessions.
    pub(super) fn stop_token(&self) -> StopToken {
        self.stop.clone()
    }

    /// Wants a text evaluated, and no older one of the document.
    pub(super) fn want(&self, job: EvaluationRequest) {
        let mut wanted = self.lock();
        // A document that is opened was not typed.
        let took = wanted.took.get(&job.uri);
        let pause =
            took.map_or(Duration::ZERO, |took| (*took).clamp(SHORTEST_PAUSE, LONGEST_PAUSE));
        match wanted.running.clone() {
            Some((uri, _)) if uri == job.uri => self.stop.stop(),
            Some((_, since)) if PATIENCE < since.elapsed() => {
                wanted.is_interrupted = true;
                self.stop.stop();
            }
            _ => {}
        }
        wanted.jobs.insert(job.uri.clone(), (Instant::now() + pause, job));
        self.changed.notify_all();
    }

    /// The text of a document is another one: what is under way for it is in vain.
    pub(super) fn edited(&self, uri: &str) {
        let mut wanted = self.lock();
        wanted.jobs.remove(uri);
        if wanted.running.as_ref().is_some_and(|(running, _)| running == uri) {
            self.stop.stop();
        }
    }

    /// Nobody wants a document any more.
    pub(super) fn close(&self, uri: &str) {
        self.edited(uri);
        let mut wanted = self.lock();
        wanted.took.remove(uri);
        wanted.closed.push(uri.to_owned());
        self.changed.notify_all();
    }

    /// All is over.
    pub(super) fn end(&self) {
        self.lock().is_over = true;
        self.stop.stop();
        self.changed.notify_all();
    }

    /// Waits for the next text; none when all is over.
    fn next(&self) -> Option<(EvaluationRequest, Vec<String>)> {
        let mut wanted = self.lock();
        loop {
            if wanted.is_over {
                return None;
            }
            let first = wanted.jobs.values().map(|(begin, _)| *begin).min();
            let left = first.map(|begin| begin.saturating_duration_since(Instant::now()));
            wanted = match left {
                Some(Duration::ZERO) => break,
                Some(left) => {
                    self.changed
                        .wait_timeout(wanted, left)
                        .unwrap_or_else(PoisonError::into_inner)
                        .0
                }
                None => self.changed.wait(wanted).unwrap_or_else(PoisonError::into_inner),
            };
        }
        let uri =
            wanted.jobs.iter().min_by_key(|(_, (begin, _))| *begin).map(|(uri, _)| uri.clone())?;
        let (_, job) = wanted.jobs.remove(&uri)?;
        wanted.running = Some((uri, Instant::now()));
        wanted.is_interrupted = false;
        self.stop.reset();
        Some((job, std::mem::take(&mut wanted.closed)))
    }

    /// Ends a run; whether somebody wants to see what it came to.
    fn finish(&self, job: &EvaluationRequest) -> bool {
        let mut wanted = self.lock();
        let since = wanted.running.take().map(|(_, since)| since.elapsed());
        let was_stopped = self.stop.is_stopped();
        if let (Some(since), false) = (since, was_stopped) {
            wanted.took.insert(job.uri.clone(), since);
        }
        if was_stopped && wanted.is_interrupted && !wanted.jobs.contains_key(&job.uri) {
            // After what is typed now.
            let begin = Instant::now() + LONGEST_PAUSE;
            wanted.jobs.insert(job.uri.clone(), (begin, job.clone()));
        }
        !was_stopped && !wanted.is_over
    }
}

/// Evaluates until all is over.
pub(super) fn work(
    queue: &EvaluationQueue,
    session: &dyn Fn(StopToken) -> Session,
    done: &Sender<Evaluated>,
) {
    let new = || session(queue.stop_token()).incremental();
    let mut sessions: Vec<(String, Session)> = Vec::new();
    while let Some((job, closed)) = queue.next() {
        sessions.retain(|(uri, _)| !closed.contains(uri));
        // The one that was used last stands last.
        let session = match sessions.iter().position(|(uri, _)| *uri == job.uri) {
            Some(idx) => sessions.remove(idx).1,
            None => new(),
        };
        if sessions.len() == MOST_REMEMBERED {
            sessions.remove(0);
        }
        let files = OverlaidFiles::new(&job.folder, &job.open);
        let report = session.run(&job.name, job.text.as_bytes(), &files, &[]);
        let is_faulty = report.diagnostics.iter().any(|found| found.code == Code::Fault);
        if queue.finish(&job) {
            let EvaluationRequest { uri, serial, .. } = &job;
            let _ = done.send(Evaluated {
                uri: uri.clone(),
                serial: *serial,
                report: Arc::new(report),
            });
        }
        // What a fault of the program left behind is not trusted.
        sessions.push((job.uri, if is_faulty { new() } else { session }));
    }
}
