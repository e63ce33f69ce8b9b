//! A file that a script exports, and how it is written.

use std::io::Write;

use crate::{
    diag::{Diagnostic, Span},
    eval::out_of_memory,
    export::{ExportError, Format, Job, Summary, capped},
    limits::{
        Ceiling, stack,
        work::{self, End, Watch},
    },
};

/// A file that a script exports, ready to be written.
#[derive(Debug)]
pub struct File {
    /// The path below the output folder, with `/` between its parts.
    pub path: String,
    /// Where the script gives the path.
    pub span: Span,
    /// The definitions that its subjects name.
    pub names: Vec<String>,
    /// How it is written.
    pub format: &'static Format,
    /// What is written.
    pub job: Job,
    /// What writing it may take.
    pub(super) watch: Watch,
}

impl File {
    /// Writes the file into `out`, no more bytes than its ceiling.
    ///
    /// ```
    /// use virote_language::{session::{Event, Session}, value::NoFiles};
    ///
    /// let script = b"curve c = line((0, 0), (3, 4))\nexport c to \"line.svg\"";
    /// let report = Session::default().run("demo", script, &NoFiles, &[]);
    /// let Event::File(file) = &report.events[0] else { panic!("it exports") };
    /// let mut bytes = Vec::new();
    /// file.write(&mut bytes).expect("a vector takes everything");
    /// assert!(bytes.starts_with(b"<?xml"));
    /// ```
    ///
    /// # Errors
    /// E0705 where the format has no place for an item, or the geometry no answer to what the format
    /// needs; E0901 beyond a ceiling; E0706 where `out` refuses.
    pub fn write(&self, out: &mut (dyn Write + Send)) -> Result<Summary, Box<Diagnostic>> {
        self.write_with(out, &|_| {}).map_err(|err| Box::new(self.refusal(&err)))
    }

    /// The same, telling `progress` how many bytes there are.
    ///
    /// # Errors
    /// Why it cannot be written; [`Self::refusal`] has the words.
    pub fn write_with(
        &self,
        out: &mut (dyn Write + Send),
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Summary, ExportError> {
        let most = self.job.limits.output_bytes;
        self.watched(|| {
            stack::with(self.job.limits.stack_bytes, |_| {
                capped(&mut *out, most, progress, |out| (self.format.write)(&self.job, out))
            })
        })
    }

    /// Does the work of writing within the ceilings of the run, as long as somebody wants the file.
    pub fn watched<R>(
        &self,
        write: impl FnOnce() -> Result<R, ExportError>,
    ) -> Result<R, ExportError> {
        let (written, done) = work::under(self.watch.clone(), write);
        done.end.map_or(written, |end| Err(ExportError::Ended(end)))
    }

    /// Why the file cannot be written, at its place in the script.
    #[must_use]
    pub fn refusal(&self, err: &ExportError) -> Diagnostic {
        let found = |message| Diagnostic::error(err.code(), self.span, message);
        match err {
            ExportError::Geometry { .. }
            | ExportError::Unfit { .. }
            | ExportError::Viewpoint(_) => found(err.reason()),
            ExportError::TooLarge { .. } => {
                found(format!("`{}` would be {err}", self.path)).crossing(Ceiling::OUTPUT_BYTES)
            }
            ExportError::Ended(End::Memory) => out_of_memory(&self.job.limits, self.span),
            ExportError::Ended(End::Steps) => {
                let most = self.watch.steps;
                let message = format!("writing `{}` takes more than {most} steps", self.path);
                found(message).crossing(Ceiling::STEPS)
            }
            ExportError::Ended(End::Stopped) => {
                found(format!("the writing of `{}` was stopped", self.path))
            }
            ExportError::Io(_) => {
                let message = format!("cannot write `{}`: {}", self.path, err.reason());
                found(message)
            }
        }
    }
}
