//! The one thread that evaluates: takes the newest run that is wanted, and shows what it came to.

use std::{
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
    time::Instant,
};

use super::{
    hub::{Hub, Job, Shown},
    scene::{ItemMemory, Scene},
    state::{self, Told},
};
use crate::{
    diag::Severity,
    disk::{FileStamp, Script, ScriptFiles},
    eval::Schema,
    session::{Report, Session},
};

/// What the thread owns.
pub(super) struct Worker {
    pub(super) hub: Arc<Hub>,
    /// With a memory, and stopped by the hub.
    pub(super) session: Session,
    pub(super) script: PathBuf,
    /// The folder for exported files.
    pub(super) out: PathBuf,
    pub(super) memory: ItemMemory,
    /// Of the last run whose script could be read.
    pub(super) schema: Option<Schema>,
    /// The last run.
    pub(super) last: Option<Arc<Report>>,
    /// The last good run.
    pub(super) good: Option<(Arc<Report>, Arc<Scene>)>,
    /// Files that the watch is to look at.
    pub(super) followed: Arc<Mutex<Vec<(PathBuf, FileStamp)>>>,
}

impl Worker {
    /// Evaluates until all is over.
    pub(super) fn work(mut self) {
        while let Some(job) = self.hub.next_job() {
            let shown = self.run(&job);
            if shown.is_none() {
                self.memory.discard();
            }
            self.hub.finish(&job, shown);
        }
    }

    /// What a run comes to; `None` where another one is wanted instead.
    pub(super) fn run(&mut self, job: &Job) -> Option<Shown> {
        let begin = Instant::now();
        let name = self.script.clone();
        let script = match Script::read(&name, self.session.limits().source_bytes) {
            Ok(script) => script,
            Err(message) => return Some(self.unread(job, &message)),
        };
        let files = ScriptFiles::new(&script.folder);
        let report = self.session.run(&script.name, &script.bytes, &files, &job.settings);
        if self.hub.is_stale(job) {
            return None;
        }
        if job.is_file_new || self.schema.is_none() {
            let schema = self.session.parameters(&script.name, &script.bytes, &files);
            self.schema = schema.ok().or(self.schema.take());
        }
        let evaluate = begin.elapsed();
        let begin = Instant::now();
        let report = Arc::new(report);
        self.last = Some(Arc::clone(&report));
        let has_errors = 0 < report.count(Severity::Error);
        let mut scene = None;
        if !has_errors {
            match Scene::of(&report, &self.session, &mut self.memory) {
                Some(made) => scene = Some(Arc::new(made)),
                None if self.hub.is_stale(job) => return None,
                None => {}
            }
        }
        let was_stopped = !has_errors && scene.is_none();
        if let Some(scene) = scene {
            self.good = Some((Arc::clone(&report), scene));
            self.memory.settle();
        }
        let inputs = self.inputs(&files);
        let mut troubles = report.unknown_settings.clone();
        if was_stopped {
            troubles.push("the drawing was stopped".to_owned());
        }
        let told = Told {
            report: Some(&report),
            is_current: !has_errors && !was_stopped,
            troubles: &troubles,
            milliseconds: [evaluate, begin.elapsed()].map(|time| 1e3 * time.as_secs_f64()),
        };
        Some(self.shown(job, told, inputs))
    }

    /// What is shown of a script that is not there.
    fn unread(&self, job: &Job, message: &str) -> Shown {
        let told = Told {
            report: None,
            is_current: false,
            troubles: &[message.to_owned()],
            milliseconds: [0.0; 2],
        };
        self.shown(job, told, self.hub.shown().inputs.clone())
    }

    fn shown(&self, job: &Job, told: Told<'_>, inputs: Vec<PathBuf>) -> Shown {
        let good = self.good.as_ref();
        let json = state::json(
            &state::Setup {
                version: job.version,
                script: &self.script,
                out: &self.out,
                settings: &job.settings,
                schema: self.schema.as_ref(),
                good: good.map(|(report, scene)| (&**report, &**scene)),
            },
            &told,
        );
        let names = |schema: &Schema| -> Vec<String> {
            schema.parameters.iter().map(|parameter| parameter.name.clone()).collect()
        };
        Shown {
            version: job.version,
            is_current: told.is_current,
            state: json.to_string().into_bytes(),
            scene: good.map(|(_, scene)| Arc::clone(scene)).unwrap_or_default(),
            report: good.map(|(report, _)| Arc::clone(report)),
            parameters: self.schema.as_ref().map(names).unwrap_or_default(),
            inputs,
        }
    }

    /// The files that a run read, which are watched from now on.
    fn inputs(&self, files: &ScriptFiles) -> Vec<PathBuf> {
        *self.followed.lock().unwrap_or_else(PoisonError::into_inner) = files.stamps();
        files.inputs()
    }
}
