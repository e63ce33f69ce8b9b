//! Signs of life on standard error while a run takes longer than half a second.
//!
//! Silent where standard error is no terminal, under `--quiet`, and for programs.

use std::{
    io::{self, IsTerminal},
    sync::mpsc::{self, RecvTimeoutError, Sender},
    thread,
    time::Duration,
};

use indicatif::{HumanBytes, ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work below this is over before anybody wonders.
const PATIENCE: Duration = Duration::from_millis(500);
/// Between two pictures of the sign.
const TICK: Duration = Duration::from_millis(100);

/// What a run is at. The sign goes with this value.
#[derive(Debug)]
pub(super) struct Progress {
    bar: ProgressBar,
    /// Tells the waiting thread, by being dropped, that the work is over.
    over: Option<Sender<()>>,
    waiting: Option<thread::JoinHandle<()>>,
}

impl Progress {
    /// Begins; `is_told` is whether anybody wants to know.
    pub(super) fn begin(what: &str, is_told: bool) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        if !is_told || !io::stderr().is_terminal() {
            return Self { bar, over: None, waiting: None };
        }
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} ({elapsed})") {
            bar.set_style(style);
        }
        bar.set_message(what.to_owned());
        let (over, wait) = mpsc::channel::<()>();
        let waited = bar.clone();
        let waiting = thread::spawn(move || {
            if wait.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                waited.set_draw_target(ProgressDrawTarget::stderr());
                waited.enable_steady_tick(TICK);
            }
        });
        Self { bar, over: Some(over), waiting: Some(waiting) }
    }

    /// Names what is done now.
    pub(super) fn say(&self, what: &str) {
        self.bar.set_message(what.to_owned());
    }

    /// Tells how much of a file is written.
    pub(super) fn written(&self, path: &str, n_bytes: u64) {
        if self.over.is_some() {
            self.bar.set_message(format!("writing {path}: {}", HumanBytes(n_bytes)));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        drop(self.over.take());
        if let Some(waiting) = self.waiting.take() {
            // It only waits; that it has ended is all that counts.
            let _ = waiting.join();
        }
        self.bar.finish_and_clear();
    }
}

/// How far a study is: a bar with the rate and the time that is left, where standard error is a terminal.
#[derive(Debug)]
pub(super) struct StudyProgress(ProgressBar);

impl StudyProgress {
    /// Begins with `n_done` of `n_all` rows.
    pub(super) fn begin(n_all: u64, n_done: u64, is_told: bool) -> Self {
        let target = match is_told && io::stderr().is_terminal() {
            true => ProgressDrawTarget::stderr(),
            false => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(Some(n_all), target).with_position(n_done);
        let template = "{wide_bar} {human_pos} of {human_len} variants, {per_sec}, {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.reset_eta();
        Self(bar)
    }

    /// Tells that a row is done.
    pub(super) fn done(&self) {
        self.0.inc(1);
    }
}

impl Drop for StudyProgress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
