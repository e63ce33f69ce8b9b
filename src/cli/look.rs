//! What `graph` and `params` have in common: they look at a script and make none of its files.

use std::path::Path;

use super::{
    Ending,
    args::Talk,
    files::{Beside, Script},
    message::Voice,
    process,
};
use crate::{
    limits::Limits,
    session::{Report, Session},
};

/// Reads the script, asks the session about it, and has the answer told; mistakes are told here.
pub(super) fn look<T>(
    path: &Path,
    talk: &Talk,
    ask: impl FnOnce(&Session, &Script, &Beside) -> Result<T, Box<Report>>,
    tell: impl FnOnce(&Script, &Voice, &T),
) -> Ending {
    let session = process::session(Limits::DEFAULT);
    let voice = Voice::new(talk, session.limits().diagnostics);
    let script = match Script::read(path, session.limits().source_bytes) {
        Ok(script) => script,
        Err(message) => {
            voice.trouble(&message);
            return Ending::Usage;
        }
    };
    match ask(&session, &script, &Beside::new(&script.folder)) {
        Ok(answer) => {
            tell(&script, &voice, &answer);
            Ending::Well
        }
        Err(report) => {
            voice.findings(&report.diagnostics, &report.sources);
            Ending::Wrong
        }
    }
}
