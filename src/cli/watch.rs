//! `virote watch`: carries a script out again whenever it is saved, or a file that it reads.
//!
//! Files are looked at five times a second, which every system and every network drive can do. One
//! session with a memory carries out all runs, so that each evaluates only what the change touched.

use std::{
    path::{Path, PathBuf},
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
    disk::{FileChange, ScriptFiles, WatchedFiles},
    eval::Work,
    session::Report,
};

/// How often files are looked at.
const TICK: Duration = Duration::from_millis(200);

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
    let run = match RunOptions::new(mode, &[], &asked.common) {
        Ok(run) => run.watching(),
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
    let mut n_runs = 0;
    while !INTERRUPTED.is_stopped() && !is_closed() {
        match watched.change() {
            FileChange::Nothing => {}
            FileChange::Gone => {
                let text = format!("{} is gone; it is waited for", asked.file.display());
                run.voice().remark(&text);
            }
            FileChange::Saved(what) => {
                if 0 < n_runs {
                    run.voice().remark(&format!("\n{what} changed"));
                }
                n_runs += 1;
                once(&run, &asked.file, &mut watched);
            }
        }
        thread::sleep(TICK);
    }
    ExitStatus::Well
}

/// Carries the script out and tells what was evaluated.
fn once(run: &RunOptions<'_>, path: &Path, watched: &mut WatchedFiles) {
    let begin = Instant::now();
    let Some(script) = run.read(path) else { return };
    let files = ScriptFiles::new(&script.folder);
    let (report, _) = run.carry_out(script, &files);
    if INTERRUPTED.is_stopped() {
        return;
    }
    watched.follow(&files.stamps());
    run.voice().evaluated(&names(&report), report.n_with(Work::Reused), begin.elapsed());
}

/// The definitions that were evaluated for a change.
fn names(report: &Report) -> Vec<&str> {
    let is_new = |work| matches!(work, Work::Evaluated | Work::Failed);
    let definitions = report.definitions.iter().filter(|defined| is_new(defined.work));
    definitions.map(|defined| defined.name.as_str()).collect()
}
