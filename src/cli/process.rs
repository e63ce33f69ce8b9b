//! What the process has to give: a stack for whatever recurses, and memory that is counted.

use std::sync::OnceLock;

use super::{exit_status::ExitStatus, standard_streams::say_error};
use crate::{
    diag::{Span, fault},
    limits::{Limits, stack},
    session::Session,
};

/// How many bytes of memory are held; told once, when the process begins.
static HELD: OnceLock<fn() -> usize> = OnceLock::new();

/// Bytes of address space that the stack leaves for what a small script holds.
const ROOM: usize = 16 << 20;

/// Does the work with a large stack. Where the system has no room for it, a smaller one has to do, and the
/// ceilings that keep to the stack come down with it.
pub(super) fn run(held: fn() -> usize, work: impl FnOnce() -> ExitStatus + Send) -> ExitStatus {
    HELD.get_or_init(|| held);
    let mut work = Some(work);
    stack::with_room(Limits::DEFAULT.stack_bytes, ROOM, |_| {
        let Some(work) = work.take() else { return ExitStatus::Usage };
        fault::caught(Span::default(), || Ok(work())).unwrap_or_else(|told| {
            say_error(&format!("virote: {}\n{}", told.message, fault::REMEDY));
            ExitStatus::Usage
        })
    })
}

/// A session with these ceilings, as far as the process carries them.
pub(super) fn session(limits: Limits) -> Session {
    let session = Session::new(limits.on_stack(limits.stack_bytes.min(stack::own_bytes())));
    match HELD.get() {
        Some(held) => session.measured(held),
        None => session,
    }
}
