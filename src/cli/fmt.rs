//! `virote fmt`: scripts in canonical form.

use std::path::{Path, PathBuf};

use super::{
    exit_status::ExitStatus, process, reporter::Reporter, run_args::OutputArgs,
    standard_streams::say_exactly,
};
use crate::{
    disk::{Script, overwrite},
    export::io_reason,
    {limits::Limits, session::Session},
};

/// `virote fmt [--check] FILE...`: the worst ending of all.
pub(super) fn run(paths: &[PathBuf], is_check: bool, talk: &OutputArgs) -> ExitStatus {
    let session = process::session(Limits::DEFAULT);
    let voice = Reporter::new(talk, session.limits().diagnostics);
    let endings = paths.iter().map(|path| one(&session, path, is_check, &voice));
    endings.max().unwrap_or(ExitStatus::Well)
}

fn one(session: &Session, path: &Path, is_check: bool, voice: &Reporter) -> ExitStatus {
    let script = match Script::read(path, session.limits().source_bytes) {
        Ok(script) => script,
        Err(message) => {
            voice.trouble(&message);
            return ExitStatus::Usage;
        }
    };
    let text = match session.format(&script.name, &script.bytes) {
        Ok(text) => text,
        Err(report) => {
            voice.findings(&report.diagnostics, &report.sources);
            return ExitStatus::Wrong;
        }
    };
    let is_changed = text.as_bytes() != script.bytes;
    match &script.path {
        _ if is_check && is_changed => {
            voice.formatted(&script.name, false);
            ExitStatus::Failed
        }
        _ if is_check => ExitStatus::Well,
        None => {
            say_exactly(&text);
            ExitStatus::Well
        }
        Some(path) if is_changed => match overwrite(path, &text) {
            Ok(()) => {
                voice.formatted(&script.name, true);
                ExitStatus::Well
            }
            Err(err) => {
                voice.trouble(&format!("cannot write `{}`: {}", script.name, io_reason(&err)));
                ExitStatus::Usage
            }
        },
        Some(_) => ExitStatus::Well,
    }
}
