//! Standard output and standard error, whose readers may leave.

use std::{
    io::{self, Write},
    sync::{
        OnceLock,
        atomic::{AtomicBool, Ordering},
    },
};

use super::exit_status::ExitStatus;
use crate::{diag::shown, export::io_reason};

/// Whether standard output takes no more.
static CLOSED: AtomicBool = AtomicBool::new(false);

/// Why it takes no more, unless its reader went away.
static MISSED: OnceLock<String> = OnceLock::new();

/// Writes text for people to standard output. A reader that went away is no error.
pub(super) fn say(text: &str) {
    say_exactly(&shown(text));
}

/// Writes what programs read to standard output.
pub(super) fn say_exactly(text: &str) {
    if is_closed() {
        return;
    }
    let mut out = io::stdout().lock();
    if let Err(err) = out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        miss(&err);
    }
}

/// Keeps why standard output takes no more.
pub(super) fn miss(err: &io::Error) {
    CLOSED.store(true, Ordering::Relaxed);
    if err.kind() != io::ErrorKind::BrokenPipe {
        MISSED.get_or_init(|| io_reason(err));
    }
}

/// The ending, once all has been said: what could not be written is told.
pub(super) fn spoken(ending: ExitStatus) -> ExitStatus {
    match MISSED.get() {
        Some(reason) => {
            say_error(&format!("virote: cannot write to standard output: {reason}"));
            ending.max(ExitStatus::Usage)
        }
        None => ending,
    }
}

/// Whether nobody reads standard output any more.
pub(super) fn is_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}

/// Writes a line of text to standard error.
pub(super) fn say_error(text: &str) {
    say_painted(&shown(text));
}

/// Writes a line that may be coloured to standard error.
pub(super) fn say_painted(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
