//! What became of a script.

use std::time::Duration;

use super::{super::exit_status::ExitStatus, golden::GoldenOutcome};
use crate::session::Report;

/// What became of a script; or why it could not be read.
pub(super) type TestAttempt = Result<TestedScript, UnreadScript>;

/// A script that could not be read.
pub(super) struct UnreadScript {
    pub(super) name: String,
    pub(super) message: String,
}

/// A script that was tested.
pub(super) struct TestedScript {
    pub(super) name: String,
    /// Without the files, which are large.
    pub(super) report: Report,
    pub(super) golden: Option<GoldenOutcome>,
    pub(super) ending: ExitStatus,
    pub(super) time: Duration,
}
