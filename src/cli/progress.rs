//! Signs of life on standard error while a run takes longer than half a second.
//!
//! Silent where standard error is no terminal, under `--quiet`, and for programs.

use std::{
    fmt::{self, Write},
    io::{self, IsTerminal},
    sync::mpsc::{self, RecvTimeoutError, Sender},
    thread,
    time::Duration,
};

use indicatif::{
    HumanBytes, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle,
};

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

/// How often a bar is drawn.
const DRAWINGS_A_SECOND: u8 = 10;
/// Rows, and the time, that a rate is told from: those of the first moments say little of the others.
const TELLING_ROWS: u64 = 4;
const TELLING_TIME: Duration = Duration::from_secs(2);

/// Writes how many rows come in a second and the time that is left, once `n_new` rows tell that.
fn write_pace(out: &mut dyn Write, n_new: u64, n_left: u64, elapsed: Duration) -> fmt::Result {
    if n_new < TELLING_ROWS || elapsed < TELLING_TIME {
        return Ok(());
    }
    let rate = n_new as f64 / elapsed.as_secs_f64();
    // Three digits that count.
    let n_decimals = (2.0 - libm::floor(libm::log10(rate))).clamp(0.0, 9.0) as usize;
    let left =
        HumanDuration(Duration::from_secs_f64((n_left as f64 / rate).min(f64::from(u32::MAX))));
    write!(out, ", {rate:.n_decimals$}/s, {left:#} left")
}

/// How far a study is: a bar with the rate and the time that is left, where standard error is a terminal.
#[derive(Debug)]
pub(super) struct StudyProgress(ProgressBar);

impl StudyProgress {
    /// Begins with `n_done` of `n_all` rows.
    pub(super) fn begin(n_all: u64, n_done: u64, is_told: bool) -> Self {
        let target = match is_told && io::stderr().is_terminal() {
            true => ProgressDrawTarget::stderr_with_hz(DRAWINGS_A_SECOND),
            false => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(Some(n_all), target).with_position(n_done);
        let template = "{wide_bar} {human_pos} of {human_len} variants{pace}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            let pace = move |state: &ProgressState, out: &mut dyn Write| {
                let n_new = state.pos().saturating_sub(n_done);
                let n_left = n_all.saturating_sub(state.pos());
                // What cannot be drawn is not missed.
                let _ = write_pace(out, n_new, n_left, state.elapsed());
            };
            bar.set_style(style.with_key("pace", pace));
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pace_has_three_digits_and_waits_until_it_means_something() {
        let pace = |n_new: u64, n_left: u64, milliseconds: u64| {
            let mut text = String::new();
            write_pace(&mut text, n_new, n_left, Duration::from_millis(milliseconds))
                .expect("text");
            text
        };
        assert_eq!(pace(3, 10_000, 60_000), "");
        assert_eq!(pace(500, 10_000, 40), "");
        assert_eq!(pace(51, 1_000, 4_000), ", 12.8/s, 78s left");
        assert_eq!(pace(40_000, 1_008_000, 2_500), ", 16000/s, 63s left");
        assert_eq!(pace(4, 40, 400_000), ", 0.0100/s, 67m left");
    }
}
