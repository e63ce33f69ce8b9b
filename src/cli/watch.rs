//! `virote watch`: carries a script out again whenever it is saved, or a file that it reads.
//!
//! Files are looked at five times a second, which every system and every network drive can do. One
//! session with a memory carries out all runs, so that each evaluates only what the change touched.

use std::{
    fs,
    path::{Path, PathBuf},
    thread,
    time::{Duration, Instant, SystemTime},
};

use clap::Args;

use super::{
    ExitStatus,
    args::RunArgs,
    files::ScriptFiles,
    interrupt::{self, INTERRUPTED},
    is_closed,
    run::{OutputMode, RunOptions},
};
use crate::{eval::Work, session::Report};

/// How often files are looked at.
const TICK: Duration = Duration::from_millis(200);

/// Looks that a file may be gone before that is told: editors put a new file in the place of the old.
const MOST_GONE: usize = 2;

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
    let mut inputs = files.inputs();
    inputs.sort();
    inputs.dedup();
    watched.follow(&inputs);
    run.voice().evaluated(&names(&report), report.n_with(Work::Reused), begin.elapsed());
}

/// The definitions that were evaluated for a change.
fn names(report: &Report) -> Vec<&str> {
    let is_new = |work| matches!(work, Work::Evaluated | Work::Failed);
    let definitions = report.definitions.iter().filter(|defined| is_new(defined.work));
    definitions.map(|defined| defined.name.as_str()).collect()
}

/// What tells a file from the one that stood in its place before: when it was written, and its
/// length; nothing where there is none.
type FileStamp = Option<(SystemTime, u64)>;

fn mark(path: &Path) -> FileStamp {
    let data = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some((data.modified().ok()?, data.len()))
}

/// The script and the files that it reads.
struct WatchedFiles {
    /// As they were when the script was carried out last.
    seen: Vec<(PathBuf, FileStamp)>,
    /// As they were at the last look: who still writes is waited for.
    last: Vec<FileStamp>,
    n_gone: usize,
    is_first: bool,
}

/// What became of the files.
enum FileChange {
    Nothing,
    /// The script is gone.
    Gone,
    /// This file is another one.
    Saved(String),
}

impl WatchedFiles {
    fn new(script: &Path) -> Self {
        let seen = vec![(script.to_path_buf(), None)];
        Self { seen, last: vec![None], n_gone: 0, is_first: true }
    }

    /// Looks at the script and these files from now on.
    fn follow(&mut self, inputs: &[PathBuf]) {
        // Of a file that was followed the mark is older than the run, which may have been slow.
        let known = std::mem::take(&mut self.seen);
        let followed = inputs.iter().map(|path| {
            let known = known.iter().find(|(known, _)| known == path);
            known.cloned().unwrap_or_else(|| (path.clone(), mark(path)))
        });
        self.seen = known.first().cloned().into_iter().chain(followed).collect();
        self.last = self.seen.iter().map(|(_, mark)| *mark).collect();
    }

    /// What happened since the script was carried out last.
    fn change(&mut self) -> FileChange {
        let now: Vec<FileStamp> = self.seen.iter().map(|(path, _)| mark(path)).collect();
        let is_still = now == self.last || self.is_first;
        self.last.clone_from(&now);
        if now[0].is_none() {
            self.n_gone += 1;
            if self.n_gone != MOST_GONE {
                return FileChange::Nothing;
            }
            // When it comes back it is carried out, even if it is the same.
            self.seen[0].1 = None;
            return FileChange::Gone;
        }
        self.n_gone = 0;
        let mut apart = self.seen.iter().zip(&now).filter(|((_, seen), now)| seen != *now);
        let Some(((path, _), _)) = apart.next().filter(|_| is_still) else {
            return FileChange::Nothing;
        };
        let what = path.strip_prefix(".").unwrap_or(path).display().to_string();
        self.is_first = false;
        self.seen.iter_mut().zip(now).for_each(|((_, seen), now)| *seen = now);
        FileChange::Saved(what)
    }
}
