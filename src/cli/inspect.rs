//! What `graph` and `params` have in common: they look at a script and make none of its files.

use std::path::Path;

use super::{exit_status::ExitStatus, process, reporter::Reporter, run_args::OutputArgs};
use crate::{
    disk::{Script, ScriptFiles},
    limits::Limits,
    session::{Report, Session},
};

/// Reads the script, asks the session about it, and has the answer told; mistakes are told here.
pub(super) fn look<T>(
    path: &Path,
    talk: &OutputArgs,
    ask: impl FnOnce(&Session, &Script, &ScriptFiles) -> Result<T, Box<Report>>,
    tell: impl FnOnce(&Script, &Reporter, &T),
) -> ExitStatus {
    let session = process::session(Limits::DEFAULT);
    let voice = Reporter::new(talk, session.limits().diagnostics);
    let script = match Script::read(path, session.limits().source_bytes) {
        Ok(script) => script,
        Err(message) => {
            voice.trouble(&message);
            return ExitStatus::Usage;
        }
    };
    match ask(&session, &script, &ScriptFiles::new(&script.folder)) {
        Ok(answer) => {
            tell(&script, &voice, &answer);
            ExitStatus::Well
        }
        Err(report) => {
            voice.findings(&report.diagnostics, &report.sources);
            ExitStatus::Wrong
        }
    }
}
