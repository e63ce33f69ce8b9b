//! Ctrl-C as a switch that whoever waits looks at.

use std::sync::{LazyLock, OnceLock};

use crate::limits::work::StopToken;

/// Set by Ctrl-C.
pub(super) static INTERRUPTED: LazyLock<StopToken> = LazyLock::new(StopToken::default);

/// The exit code of a program that Ctrl-C ends, by the custom of shells.
const BY_INTERRUPT: i32 = 130;

/// Lets Ctrl-C set the switch instead of ending the program.
pub(super) fn listen() {
    handle(|| INTERRUPTED.stop());
}

/// The same, but where the switch is set and not yet heard, Ctrl-C ends the program all the same.
pub(super) fn listen_once() {
    handle(|| {
        if INTERRUPTED.is_stopped() {
            std::process::exit(BY_INTERRUPT);
        }
        INTERRUPTED.stop();
    });
}

/// Has this done at Ctrl-C. Only the first call counts.
fn handle(at_interrupt: fn()) {
    static LISTENS: OnceLock<bool> = OnceLock::new();
    LISTENS.get_or_init(|| ctrlc::set_handler(at_interrupt).is_ok());
}
