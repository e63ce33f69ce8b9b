//! Variants side by side, their rows in the order of the plan.
//!
//! Each worker owns an incremental session, so that a variant evaluates only what its parameters touch.
//! No worker runs far ahead of the slowest: what waits for its turn is bounded, whatever the plan.

use std::{
    collections::BTreeMap,
    io,
    path::{Path, PathBuf},
    sync::{
        Condvar, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
        mpsc,
    },
    thread,
    time::{Duration, Instant},
};

use serde_json::json;

use super::{
    plan::Variant,
    row::{Row, RowMaker},
};
use crate::{
    diag::Severity,
    disk,
    eval::Setting,
    export::{Format, PICTURES, io_reason},
    limits::{
        stack,
        work::{self, StopToken},
    },
    session::{JobGate, PictureContent, Report, Session},
    value::Files,
};

/// What is evaluated, and how.
#[allow(missing_debug_implementations, reason = "it holds a function")]
pub struct Evaluation<'a> {
    /// The script.
    pub name: &'a str,
    /// Its text.
    pub bytes: &'a [u8],
    /// Its data.
    pub files: &'a dyn Files,
    /// Values for parameters that do not vary.
    pub settings: &'a [Setting],
    /// Makes the session of a worker, which a switch stops.
    pub session: &'a (dyn Fn(StopToken) -> Session + Sync),
    /// Makes the rows.
    pub maker: &'a RowMaker,
    /// How many variants are evaluated at a time.
    pub n_workers: usize,
    /// How long each may take.
    pub time_limit: Option<Duration>,
    /// Pictures that are to be made.
    pub pictures: Option<StudyPictures<'a>>,
    /// Set by whoever no longer wants the rows.
    pub stop: &'a StopToken,
}

/// A picture for each variant.
#[derive(Debug)]
pub struct StudyPictures<'a> {
    /// Where they go.
    pub folder: &'a Path,
    /// What they show.
    pub content: PictureContent<'a>,
    /// Digits of the numbers in their names.
    pub n_digits: usize,
}

impl StudyPictures<'_> {
    /// The name of the picture of a variant.
    #[must_use]
    pub fn name(&self, number: u64) -> String {
        format!("{number:0digits$}.png", digits = self.n_digits)
    }
}

/// Rows that may wait for one before them, for each worker.
const MOST_AHEAD: u64 = 64;
/// How often it is asked whether a variant takes too long.
const TICK: Duration = Duration::from_millis(5);

/// Evaluates variants, and hands out their rows in order; with fewer if the evaluation is stopped.
///
/// # Errors
/// What `each` or a variant refuses.
pub fn in_order(
    evaluation: &Evaluation<'_>,
    variants: impl Iterator<Item = Result<Variant, String>> + Send,
    mut each: impl FnMut(Row) -> Result<(), String>,
) -> Result<(), String> {
    let n_workers = evaluation.n_workers.max(1);
    let queue = VariantQueue::new(variants, MOST_AHEAD * n_workers as u64);
    let clocks: Vec<Clock> = (0..n_workers).map(|_| Clock::default()).collect();
    let session = |clock: &Clock| (evaluation.session)(clock.stop.clone()).incremental();
    let sessions: Vec<Session> = clocks.iter().map(session).collect();
    let is_over = AtomicBool::new(false);
    let workers = Workers { sessions: &sessions, gate: JobGate::default() };
    thread::scope(|scope| {
        let (sender, results) = mpsc::channel();
        let mut n_started = 0;
        for worker in clocks.iter().zip(&sessions) {
            let (sender, queue, workers) = (sender.clone(), &queue, &workers);
            let serve = move || serve(evaluation, (worker, workers), queue, &sender);
            let stack_bytes = stack::own_bytes();
            let serve = move || stack::known(stack_bytes, serve);
            let started = thread::Builder::new().stack_size(stack_bytes).spawn_scoped(scope, serve);
            n_started += usize::from(started.is_ok());
        }
        if n_started == 0 {
            return Err("the system has no room for a thread".to_owned());
        }
        drop(sender);
        scope.spawn(|| watch(&clocks, evaluation, &is_over));
        let told = deliver_rows(&queue, &results, &mut each);
        // Workers end when nobody takes their rows.
        queue.close();
        drop(results);
        if told.is_err() {
            clocks.iter().for_each(|clock| clock.stop.stop());
        }
        is_over.store(true, Ordering::Relaxed);
        told
    })
}

/// What workers have to do with one another.
struct Workers<'a> {
    sessions: &'a [Session],
    gate: JobGate,
}

impl Workers<'_> {
    /// Forgets what all remember, so that the limit of memory is that of one variant.
    fn make_room(&self) {
        self.sessions.iter().for_each(Session::forget);
    }
}

/// A worker's clock and session, among the others.
type SessionOfWorker<'a> = ((&'a Clock, &'a Session), &'a Workers<'a>);

/// A row with its place, or what ends the study.
type NumberedRow = (u64, Result<Row, String>);

/// Hands out rows in order.
fn deliver_rows(
    queue: &VariantQueue<impl Iterator<Item = Result<Variant, String>>>,
    results: &mpsc::Receiver<NumberedRow>,
    each: &mut impl FnMut(Row) -> Result<(), String>,
) -> Result<(), String> {
    let (mut early, mut n_told) = (BTreeMap::new(), 0);
    for (place, row) in results {
        early.insert(place, row);
        while let Some(row) = early.remove(&n_told) {
            each(row?)?;
            n_told += 1;
            queue.advance_to(n_told);
        }
    }
    Ok(())
}

/// Evaluates one variant after the other.
fn serve(
    evaluation: &Evaluation<'_>,
    worker: SessionOfWorker<'_>,
    queue: &VariantQueue<impl Iterator<Item = Result<Variant, String>>>,
    sender: &mpsc::Sender<NumberedRow>,
) {
    while let Some((place, variant)) = queue.next() {
        let row = variant.and_then(|variant| row(evaluation, worker, &variant));
        // What was stopped from outside has no row, and those that wait for its turn have none either.
        if evaluation.stop.is_stopped() {
            queue.close();
            return;
        }
        if sender.send((place, row)).is_err() {
            return;
        }
    }
}

fn row(
    evaluation: &Evaluation<'_>,
    ((clock, session), workers): SessionOfWorker<'_>,
    variant: &Variant,
) -> Result<Row, String> {
    let mut settings = evaluation.settings.to_vec();
    settings.retain(|setting| variant.settings.iter().all(|varied| varied.name != setting.name));
    settings.extend(variant.settings.iter().cloned());
    let time = Mutex::new((Duration::ZERO, false, None));
    let evaluate = || {
        clock.start(evaluation.time_limit);
        let begin = Instant::now();
        let report = session.run(evaluation.name, evaluation.bytes, evaluation.files, &settings);
        let took = begin.elapsed();
        let picture = evaluation
            .pictures
            .as_ref()
            .map(|pictures| picture(session, &report, pictures, variant.number));
        let is_late = clock.end();
        *time.lock().unwrap_or_else(PoisonError::into_inner) = (took, is_late, picture);
        report
    };
    let make_room = || workers.make_room();
    workers.gate.told(evaluate, make_room, |report| {
        if !report.unknown_settings.is_empty() {
            return Err(report.unknown_settings.join("\n"));
        }
        let mut time = time.lock().unwrap_or_else(PoisonError::into_inner);
        let (took, is_late, picture) = std::mem::take(&mut *time);
        // Of one that ended by itself all is there, however late it was.
        let lacks = report.count(Severity::Error) > 0 || matches!(picture, Some(Ok(None)));
        let late = evaluation.time_limit.filter(|_| is_late && lacks);
        let late = late.map(|limit| format!("it takes more than {} s", limit.as_secs_f64()));
        let milliseconds = 1e3 * took.as_secs_f64();
        let mut row = evaluation.maker.row(variant, &report, milliseconds, late.as_deref())?;
        if let Some(picture) = picture {
            row.insert(super::row::PICTURE.to_owned(), json!(picture?));
        }
        Ok(row)
    })
}

/// Draws a variant; the name of the picture, or nothing where there is nothing to draw.
///
/// # Errors
/// That the picture cannot be written.
fn picture(
    session: &Session,
    report: &Report,
    pictures: &StudyPictures<'_>,
    number: u64,
) -> Result<Option<String>, String> {
    let Some(format) = Format::among(PICTURES, "a.png") else { return Ok(None) };
    let Ok(job) = session.picture(report, &pictures.content, format) else { return Ok(None) };
    let mut bytes = Vec::new();
    let draw = || (format.write)(&job, &mut bytes);
    let (drawn, done) = work::under(session.watch(), draw);
    if drawn.is_err() || done.end.is_some() {
        return Ok(None);
    }
    let name = pictures.name(number);
    let path: PathBuf = pictures.folder.join(&name);
    let write = |out: &mut dyn io::Write| out.write_all(&bytes);
    disk::replace(&path, None, write)
        .map_err(|err| format!("cannot write `{}`: {}", path.display(), io_reason(&err)))?;
    Ok(Some(name))
}

/// The clock of a worker, and the switch that ends its variant.
#[derive(Debug, Default)]
struct Clock {
    stop: StopToken,
    deadline: Mutex<Option<Instant>>,
}

impl Clock {
    fn deadline(&self) -> MutexGuard<'_, Option<Instant>> {
        self.deadline.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn start(&self, limit: Option<Duration>) {
        *self.deadline() = limit.and_then(|limit| Instant::now().checked_add(limit));
    }

    /// Ends the time of a variant; whether it was over.
    fn end(&self) -> bool {
        // From here on nobody stops this worker for the variant that it has done.
        *self.deadline() = None;
        self.stop.reset()
    }

    fn look(&self) {
        let deadline = self.deadline();
        if deadline.is_some_and(|deadline| deadline <= Instant::now()) {
            self.stop.stop();
        }
    }
}

/// Stops variants whose time is over, and all of them when nobody wants the rows.
fn watch(clocks: &[Clock], evaluation: &Evaluation<'_>, is_over: &AtomicBool) {
    while !is_over.load(Ordering::Relaxed) {
        for clock in clocks {
            if evaluation.stop.is_stopped() {
                clock.stop.stop();
            }
            clock.look();
        }
        thread::sleep(TICK);
    }
}

/// Variants that nobody has taken yet.
struct VariantQueue<I> {
    state: Mutex<VariantQueueState<I>>,
    moved: Condvar,
    most_ahead: u64,
}

struct VariantQueueState<I> {
    variants: I,
    n_taken: u64,
    n_told: u64,
    is_closed: bool,
}

impl<I: Iterator<Item = Result<Variant, String>>> VariantQueue<I> {
    fn new(variants: I, most_ahead: u64) -> Self {
        let state = VariantQueueState { variants, n_taken: 0, n_told: 0, is_closed: false };
        Self { state: Mutex::new(state), moved: Condvar::new(), most_ahead }
    }

    fn state(&self) -> MutexGuard<'_, VariantQueueState<I>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next variant with its place, once it is not too far ahead.
    fn next(&self) -> Option<(u64, Result<Variant, String>)> {
        let mut state = self.state();
        while !state.is_closed && state.n_told + self.most_ahead <= state.n_taken {
            state = self.moved.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        if state.is_closed {
            return None;
        }
        let variant = state.variants.next()?;
        let place = state.n_taken;
        state.n_taken += 1;
        // Behind a plan that cannot be read nothing is evaluated.
        state.is_closed = variant.is_err();
        Some((place, variant))
    }

    fn advance_to(&self, n_told: u64) {
        self.state().n_told = n_told;
        self.moved.notify_all();
    }

    fn close(&self) {
        self.state().is_closed = true;
        self.moved.notify_all();
    }
}
