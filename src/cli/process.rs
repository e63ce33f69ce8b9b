//! What the process has to give: a stack for whatever recurses, and memory that is counted.

use std::{
    process::ExitCode,
    sync::{Mutex, OnceLock},
    thread,
};

use super::{ExitStatus, say_error};
use crate::{
    diag::{Span, fault},
    limits::Limits,
    session::Session,
};

/// Told once, when the process begins.
struct ProcessTraits {
    stack_bytes: usize,
    held: fn() -> usize,
}

static GIVEN: OnceLock<ProcessTraits> = OnceLock::new();

/// The smallest stack that is tried, as a part of the usual one.
const SMALLEST_PART: usize = 32;

/// Does the work on a thread with a large stack. Where the system has no room for it, a smaller one
/// has to do, and the ceilings that keep to the stack come down with it.
pub(super) fn run(held: fn() -> usize, work: impl FnOnce() -> ExitStatus + Send) -> ExitCode {
    let usual = Limits::DEFAULT.stack_bytes;
    let work = Mutex::new(Some(work));
    let mut stack_bytes = usual;
    loop {
        let take_up = || {
            GIVEN.get_or_init(|| ProcessTraits { stack_bytes, held });
            let work = work.lock().ok().and_then(|mut work| work.take());
            let Some(work) = work else { return ExitStatus::Usage };
            fault::caught(Span::default(), || Ok(work())).unwrap_or_else(|told| {
                say_error(&format!("virote: {}\n{}", told.message, fault::REMEDY));
                ExitStatus::Usage
            })
        };
        let done = thread::scope(|scope| {
            let worker =
                thread::Builder::new().stack_size(stack_bytes).spawn_scoped(scope, take_up)?;
            Ok::<_, std::io::Error>(worker.join())
        });
        match done {
            Ok(Ok(ending)) => return ending.into(),
            Ok(Err(_)) => return ExitStatus::Usage.into(),
            Err(_) if usual / SMALLEST_PART < stack_bytes => stack_bytes /= 2,
            Err(err) => {
                say_error(&format!("virote: no thread could be started: {err}"));
                return ExitStatus::Usage.into();
            }
        }
    }
}

/// A session with these ceilings, as far as the process carries them.
pub(super) fn session(limits: Limits) -> Session {
    match GIVEN.get() {
        Some(given) => Session::new(limits.on_stack(given.stack_bytes)).measured(given.held),
        None => Session::new(limits),
    }
}
