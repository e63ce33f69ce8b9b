//! The one thread that evaluates: takes the newest run that is wanted, and shows what it came to.

use std::{
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
    time::Instant,
};

use super::hub::{Hub, RunRequest};
use crate::{
    disk::{FileStamp, Script, ScriptFiles},
    page::{Model, PageRun, RunPlace, Shown},
};

/// What the thread owns.
pub(super) struct PageWorker {
    pub(super) hub: Arc<Hub>,
    /// Its session is stopped by the hub.
    pub(super) model: Model,
    pub(super) script: PathBuf,
    /// The folder for exported files.
    pub(super) out: PathBuf,
    /// Files that the watch is to look at.
    pub(super) followed: Arc<Mutex<Vec<(PathBuf, FileStamp)>>>,
}

impl PageWorker {
    /// Evaluates until all is over.
    pub(super) fn work(mut self) {
        while let Some(job) = self.hub.next_job() {
            let shown = self.run(&job);
            self.hub.finish(&job, shown);
        }
    }

    /// What a run comes to; `None` where another one is wanted instead.
    pub(super) fn run(&mut self, job: &RunRequest) -> Option<Shown> {
        let place = RunPlace {
            version: job.version,
            script: &self.script,
            out: &self.out,
            settings: &job.settings,
        };
        let script = match Script::read(&self.script, self.model.session.limits().source_bytes) {
            Ok(script) => script,
            Err(message) => {
                let inputs = self.hub.shown().inputs.clone();
                return Some(Shown { inputs, ..self.model.unread(place, &message) });
            }
        };
        let files = ScriptFiles::new(&script.folder);
        let begin = Instant::now();
        let run = PageRun {
            name: &script.name,
            bytes: &script.bytes,
            files: &files,
            is_file_new: job.is_file_new,
            is_stale: &|| self.hub.is_stale(job),
            clock: &|| 1e3 * begin.elapsed().as_secs_f64(),
        };
        let shown = self.model.run(place, run)?;
        // These are watched from now on.
        *self.followed.lock().unwrap_or_else(PoisonError::into_inner) = files.stamps();
        Some(Shown { inputs: files.inputs(), ..shown })
    }
}
