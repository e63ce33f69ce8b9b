//! Files that the page asks for: those of the script, or chosen definitions. All are written, whole, or
//! none.

use std::{io::Write, path::PathBuf, sync::Arc};

use serde_json::{Value as Json, json};

use super::routes::{Answer, Doors, alone};
use crate::{
    diag::{Diagnostic, Span, fault},
    disk::{OutputTarget, StagedFile, TargetRefusal},
    export::{ExportError, Format, Job},
    limits::{stack, work},
    session::{Event, File, Report},
};

/// `/api/export`
pub(super) fn export(body: &Json, doors: &Doors) -> Answer {
    let shown = doors.hub.shown();
    let report = shown.report.clone().ok_or("there is no model yet")?;
    if !shown.is_current {
        return Err("the script has errors; nothing is written".to_owned());
    }
    let _alone = alone(doors);
    let writing = Writing { doors, inputs: inputs(doors, &shown.inputs) };
    let names = match (body["what"].as_str(), body["items"].as_array(), body["file"].as_str()) {
        (Some("script"), None, None) => {
            let files = report.events.iter().filter_map(|event| match event {
                Event::File(file) => Some(&**file),
                _ => None,
            });
            let files: Vec<&File> = files.collect();
            if files.is_empty() {
                return Err("the script exports nothing".to_owned());
            }
            writing.all(
                &files
                    .iter()
                    .map(|file| (file.path.as_str(), file.format, &file.job))
                    .collect::<Vec<_>>(),
            )?
        }
        (None, Some(names), Some(path)) => {
            let file = chosen(names, path, &report, doors)?;
            writing.all(&[(file.path.as_str(), file.format, &file.job)])?
        }
        _ => return Err("say `what`: \"script\", or `items` and `file`".to_owned()),
    };
    Ok(json!({ "files": names }))
}

/// The files that must stay as they are.
fn inputs(doors: &Doors, read: &[PathBuf]) -> Vec<PathBuf> {
    std::iter::once(&doors.script).chain(read).cloned().collect()
}

/// A file of the definitions with these names.
fn chosen(
    names: &[Json],
    path: &str,
    report: &Arc<Report>,
    doors: &Doors,
) -> Result<Box<File>, String> {
    let name = |name: &Json| name.as_str().map(str::to_owned);
    let names: Option<Vec<String>> = names.iter().map(name).collect();
    let names = names.filter(|names| !names.is_empty());
    let names = names.ok_or("`items` must be a list of names of definitions")?;
    let first = |found: Vec<Diagnostic>| {
        found
            .into_iter()
            .next()
            .map_or_else(|| "nothing to export".to_owned(), |found| found.message)
    };
    doors.session.file_of(report, &names, path).map_err(first)
}

struct Writing<'a> {
    doors: &'a Doors,
    inputs: Vec<PathBuf>,
}

impl Writing<'_> {
    /// Writes all of these, or none.
    fn all(&self, files: &[(&str, &'static Format, &Job)]) -> Result<Vec<String>, String> {
        let mut staged = Vec::new();
        for &(path, format, job) in files {
            staged.push(self.stage(path, format, job)?);
        }
        for (file, (path, ..)) in staged.into_iter().zip(files) {
            let why = |err| format!("cannot write `{path}`: {}", ExportError::Io(err).reason());
            file.place().map_err(why)?;
        }
        Ok(files.iter().map(|(path, ..)| (*path).to_owned()).collect())
    }

    /// Writes a file under a temporary name.
    fn stage(&self, path: &str, format: &'static Format, job: &Job) -> Result<StagedFile, String> {
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
