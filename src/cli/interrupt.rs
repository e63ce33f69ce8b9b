//! Ctrl-C as a switch that whoever waits looks at.

use std::sync::{LazyLock, OnceLock};

use super::exit_status::ExitStatus;
use crate::limits::work::StopToken;

/// Set by Ctrl-C.
pub(super) static INTERRUPTED: LazyLock<StopToken> = LazyLock::new(StopToken::default);

/// Lets Ctrl-C set the switch instead of ending the program.
pub(super) fn listen() {
    handle(|| INTERRUPTED.stop());
}

/// The same, but where the switch is set and not yet heard, Ctrl-C ends the program all the same.
pub(super) fn listen_once() {
    handle(|| {
        if INTERRUPTED.is_stopped() {
            std::process::exit(ExitStatus::Interrupted as i32);
        }
        INTERRUPTED.stop();
    });
}

/// Has this done at Ctrl-C. Only the first call counts.
fn handle(at_interrupt: fn()) {
    static LISTENS: OnceLock<bool> = OnceLock::new();
    LISTENS.get_or_init(|| ctrlc::set_handler(at_interrupt).is_ok());
}
