//! `virote watch`: carries a script out again whenever it is saved, or a file that it reads.
//!
//! Files are looked at five times a second, which every system and every network drive can do. One
//! session with a memory carries out all runs, so that each evaluates only what the change touched. A run
//! that is still evaluated when a file changes is ended: nobody waits for what it would tell. What it writes, it writes whole.

use std::{
    path::{Path, PathBuf},
    sync::{
        Arc, Mutex, PoisonError,
        mpsc::{self, Receiver, RecvTimeoutError},
    },
    thread,
    time::{Duration, Instant},
};

use clap::Args;

use super::{
    exit_status::ExitStatus,
    interrupt::{self, INTERRUPTED},
    run::{OutputMode, RunOptions},
    run_args::RunArgs,
    standard_streams::is_closed,
};
use crate::{
    disk::{FileChange, FileStamp, ScriptFiles, WatchedFiles},
    eval::Work,
    limits::work::StopToken,
    session::Report,
};

/// How often files are looked at.
const TICK: Duration = Duration::from_millis(200);

/// Runs that data may end one after the other.
const PATIENCE: usize = 3;

/// How often a run that is under way is asked whether Ctrl-C was pressed.
const INTERRUPT_TICK: Duration = Duration::from_millis(25);

/// What `virote watch` is asked for.
#[derive(Debug, Args)]
pub(super) struct WatchOptions {
    /// The script
    file: PathBuf,
    /// The folder for exported files [default: the script's own]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Writes no file
    #[arg(long, conflicts_with = "out")]
    check: bool,
    #[command(flatten)]
    common: RunArgs,
}

/// `virote watch FILE`: until Ctrl-C, or until nobody reads what it says.
pub(super) fn run(asked: &WatchOptions) -> ExitStatus {
    let mode =
        if asked.check { OutputMode::Check } else { OutputMode::Write(asked.out.as_deref()) };
    let stop = StopToken::default();
    let is_evaluated = Arc::new(Mutex::new(false));
    let run = match RunOptions::new(mode, &[], &asked.common) {
        Ok(run) => run.watching(stop.clone(), Arc::clone(&is_evaluated)),
        Err(ending) => return ending,
    };
    if asked.file.as_os_str() == "-" {
        run.voice().trouble("standard input cannot be watched");
        return ExitStatus::Usage;
    }
    // A name that was mistyped is not waited for.
    if run.read(&asked.file).is_none() {
        return ExitStatus::Usage;
    }
    interrupt::listen_once();
    let mut watched = WatchedFiles::new(&asked.file);
    let (mut n_runs, mut change) = (0, watched.change());
    let script = asked.file.strip_prefix(".").unwrap_or(&asked.file).to_path_buf();
    let mut ending = RunEnding { stop, is_evaluated, script, n_in_a_row: 0 };
    while !INTERRUPTED.is_stopped() && !is_closed() {
        match change {
            FileChange::Nothing => {}
            FileChange::Gone(in_its_place) => {
                let what = match in_its_place {
                    FileStamp::Folder => "is a folder now",
                    FileStamp::Special => "is a pipe or a device now",
                    FileStamp::File(..) | FileStamp::Absent(_) => "is gone",
                };
                let text = format!("{} {what}; the script is waited for", asked.file.display());
                run.voice().remark(&text);
            }
            FileChange::Saved(what) => {
                if 0 < n_runs {
                    run.voice().remark(&format!("\n{what} changed"));
                }
                n_runs += 1;
                if let Some(next) = once(&run, &asked.file, &mut watched, &mut ending) {
                    change = next;
                    continue;
                }
            }
        }
        thread::sleep(TICK);
        change = watched.change();
    }
    ExitStatus::Well
}

/// When a run that is under way ends for another one.
struct RunEnding {
    stop: StopToken,
    /// Whether it is evaluated: then it is carried out whole.
    is_evaluated: Arc<Mutex<bool>>,
    /// The script, as it is told.
    script: PathBuf,
    /// Runs that ended so, one after the other.
    n_in_a_row: usize,
}

impl RunEnding {
    /// Ends a run for a file that changed. Data that grow all the time leave one run in a few its time; for another script
    /// each ends, which may be without end.
    fn end_for(&self, what: &str) {
        let what = Path::new(what);
        let is_script =
            what == self.script || what.extension().is_some_and(|ending| ending == "geo");
        // Held until it is stopped: nobody begins to write meanwhile.
        let is_evaluated = self.is_evaluated.lock().unwrap_or_else(PoisonError::into_inner);
        if !*is_evaluated && (is_script || self.n_in_a_row < PATIENCE) {
            self.stop.stop();
        }
    }
}

/// Carries the script out and tells what was evaluated; what happened to files meanwhile, if anything.
fn once(
    run: &RunOptions<'_>,
    path: &Path,
    watched: &mut WatchedFiles,
    ending: &mut RunEnding,
) -> Option<FileChange> {
    *ending.is_evaluated.lock().unwrap_or_else(PoisonError::into_inner) = false;
    let begin = Instant::now();
    let script = run.read(path)?;
    let files = &ScriptFiles::new(&script.folder);
    let (over, ended) = mpsc::channel();
    let (report, change) = thread::scope(|scope| {
        let followed = &mut *watched;
        let ending = &*ending;
        let look = move || look(followed, files, ending, &ended);
        let looks = thread::Builder::new().spawn_scoped(scope, look);
        let (report, _) = run.carry_out(script, files);
        drop(over);
        (report, looks.ok().and_then(|looks| looks.join().ok()).flatten())
    });
    let was_stopped = ending.stop.reset();
    ending.n_in_a_row = if was_stopped { ending.n_in_a_row + 1 } else { 0 };
    if INTERRUPTED.is_stopped() {
        return None;
    }
    watched.follow(&files.stamps());
    if !was_stopped {
        let n_kept = report.n_with(Work::Reused);
        run.voice().evaluated(&names(&report), n_kept, begin.elapsed());
    }
    change
}

/// Looks at the files until the run has ended, and ends it where one changes or Ctrl-C is pressed.
fn look(
    watched: &mut WatchedFiles,
    files: &ScriptFiles,
    ending: &RunEnding,
    ended: &Receiver<()>,
) -> Option<FileChange> {
    let (mut n_files, mut last, mut found) = (0, Instant::now(), None);
    while ended.recv_timeout(INTERRUPT_TICK) == Err(RecvTimeoutError::Timeout) {
        if INTERRUPTED.is_stopped() {
            ending.stop.stop();
        }
        if last.elapsed() < TICK || ending.stop.is_stopped() {
            continue;
        }
        last = Instant::now();
        let stamps = files.stamps();
        if n_files < stamps.len() {
            n_files = stamps.len();
            watched.follow(&stamps);
        }
        match watched.change() {
            FileChange::Nothing => {}
            // It goes on until another script is there.
            gone @ FileChange::Gone(_) => found = Some(gone),
            FileChange::Saved(what) => {
                ending.end_for(&what);
                found = Some(FileChange::Saved(what));
            }
        }
    }
    found
}

/// The definitions that were evaluated for a change.
fn names(report: &Report) -> Vec<&str> {
    let is_new = |work| matches!(work, Work::Evaluated | Work::Failed);
    let definitions = report.definitions.iter().filter(|defined| is_new(defined.work));
    definitions.map(|defined| defined.name.as_str()).collect()
}
