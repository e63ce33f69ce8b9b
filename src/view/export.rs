//! Files that the page asks for: those of the script, or chosen definitions. All are written, whole, or
//! none.

use std::{io::Write, path::PathBuf};

use serde_json::{Value as Json, json};

use super::doors::Doors;
use crate::{
    diag::{Span, fault},
    disk::{OutputTarget, StagedFile, TargetRefusal},
    export::ExportError,
    limits::{stack, work},
    page::{
        Answer,
        export::{WantedFile, wanted},
    },
    session::File,
};

/// `/api/export`
pub(super) fn export(body: &Json, doors: &Doors) -> Answer {
    let shown = doors.hub.shown();
    let report = shown.to_export()?;
    let _alone = doors.alone();
    let writing = Writing { doors, inputs: inputs(doors, &shown.inputs) };
    let names = writing.all(&wanted(body, report, &doors.session)?)?;
    Ok(json!({ "files": names }))
}

/// The files that must stay as they are.
fn inputs(doors: &Doors, read: &[PathBuf]) -> Vec<PathBuf> {
    std::iter::once(&doors.script).chain(read).cloned().collect()
}

struct Writing<'a> {
    doors: &'a Doors,
    inputs: Vec<PathBuf>,
}

impl Writing<'_> {
    /// Writes all of these, or none.
    fn all(&self, files: &[WantedFile<'_>]) -> Result<Vec<String>, String> {
        let mut staged = Vec::new();
        for file in files {
            staged.push(self.stage(file)?);
        }
        for (staged, file) in staged.into_iter().zip(files) {
            let reason = |err| ExportError::Io(err).reason();
            let why = |err| format!("cannot write `{}`: {}", file.path, reason(err));
            staged.place().map_err(why)?;
        }
        Ok(files.iter().map(|file| file.path.clone()).collect())
    }

    /// Writes a file under a temporary name.
    fn stage(&self, file: &File) -> Result<StagedFile, String> {
        let File { path, format, job, .. } = file;
        let cannot = |why: String| format!("cannot write `{path}`: {why}");
        let target = OutputTarget::new(&self.doors.out, path, &self.inputs);
        let target = target.map_err(|refusal| match refusal {
            TargetRefusal::Forbidden(why) | TargetRefusal::System(why) => cannot(why),
        })?;
        let session = &self.doors.session;
        let write = |out: &mut dyn Write| (format.write)(job, out);
        let stage = || target.stage(job.limits.output_bytes, &|_| {}, write);
        let (staged, done) = stack::with(session.limits().stack_bytes, |_| {
            work::under(session.watch(), || fault::caught(Span::default(), || Ok(stage())))
        });
        let staged = staged.map_err(|fault| cannot(fault.message))?;
        let staged = done.end.map_or(staged, |end| Err(ExportError::Ended(end)));
        staged.map(|(file, _)| file).map_err(|err| cannot(err.reason()))
    }
}
