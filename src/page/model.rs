//! A script that is evaluated again and again, with what its last good run drew; before there is one, with
//! what is whole of the last.

use std::{collections::BTreeSet, path::Path, sync::Arc};

use serde_json::{Value as Json, json};

use super::{
    Shown, imports,
    scene::{ItemMemory, Scene},
    state::{self, RunOutcome},
};
use crate::{
    diag::Severity,
    eval::{Schema, Setting},
    session::{Report, Session},
    value::Files,
};

/// What a model keeps from run to run.
#[derive(Debug)]
pub(crate) struct Model {
    /// With a memory.
    pub(crate) session: Session,
    memory: ItemMemory,
    /// Of the last run whose script could be read.
    schema: Option<Schema>,
    /// Whether that is all of it, and not what is known of a script with errors.
    is_schema_whole: bool,
    /// The parameters of imported files.
    imports: Json,
    /// Names of parameters that the script had at some time.
    had: BTreeSet<String>,
    /// The last run.
    pub(crate) last: Option<Arc<Report>>,
    /// The run whose items are shown: the last good one.
    drawn: Option<DrawnRun>,
}

/// A run with its items.
#[derive(Debug)]
struct DrawnRun {
    report: Arc<Report>,
    scene: Arc<Scene>,
    /// Whether the script had errors: what evaluated is shown until it has none for the first time.
    is_partial: bool,
}

/// A run that is wanted.
#[derive(Clone, Copy)]
pub(crate) struct PageRun<'a> {
    /// What messages call the script.
    pub(crate) name: &'a str,
    pub(crate) bytes: &'a [u8],
    pub(crate) files: &'a dyn Files,
    /// Whether files may have changed since the last run.
    pub(crate) is_file_new: bool,
    /// Whether nobody wants it any more, since a newer one is wanted.
    pub(crate) is_stale: &'a dyn Fn() -> bool,
    /// Milliseconds since whenever.
    pub(crate) clock: &'a dyn Fn() -> f64,
}

/// What a state tells of where it is.
#[derive(Clone, Copy)]
pub(crate) struct RunPlace<'a> {
    /// The version that the state will have.
    pub(crate) version: u64,
    pub(crate) script: &'a Path,
    /// The folder for exported files.
    pub(crate) out: &'a Path,
    pub(crate) settings: &'a [Setting],
}

impl Model {
    /// A model of nothing yet; `process` tells keys of its items from those of other processes, which a
    /// browser may still know.
    pub(crate) fn new(session: Session, process: u64) -> Self {
        let memory = ItemMemory::new(process);
        Self {
            session: session.incremental(),
            memory,
            schema: None,
            is_schema_whole: false,
            imports: json!([]),
            had: BTreeSet::new(),
            last: None,
            drawn: None,
        }
    }

    /// What is shown before the first run.
    pub(crate) fn empty(script: &Path, out: &Path) -> Shown {
        Shown {
            version: 0,
            is_current: false,
            state: state::empty(script, out).to_string().into_bytes(),
            scene: Arc::default(),
            report: None,
            parameters: Vec::new(),
            lost: Vec::new(),
            inputs: Vec::new(),
        }
    }

    /// What a run comes to; `None` where another one is wanted instead.
    pub(crate) fn run(&mut self, place: RunPlace<'_>, run: PageRun<'_>) -> Option<Shown> {
        let shown = self.try_run(place, run);
        if shown.is_none() {
            self.memory.discard();
        }
        shown
    }

    fn try_run(&mut self, place: RunPlace<'_>, run: PageRun<'_>) -> Option<Shown> {
        let begin = (run.clock)();
        let report = self.session.run(run.name, run.bytes, run.files, place.settings);
        if (run.is_stale)() {
            return None;
        }
        if run.is_file_new || self.schema.is_none() {
            self.look_at_parameters(run);
        }
        let evaluated = (run.clock)();
        let report = Arc::new(report);
        self.last = Some(Arc::clone(&report));
        let has_errors = 0 < report.count(Severity::Error);
        let mut scene = None;
        if !has_errors || self.drawn.as_ref().is_none_or(|drawn| drawn.is_partial) {
            match Scene::of(&report, &self.session, &mut self.memory) {
                Some(made) => scene = Some(Arc::new(made)),
                None if (run.is_stale)() => return None,
                None => {}
            }
        }
        let was_stopped = !has_errors && scene.is_none();
        if let Some(scene) = scene {
            let report = Arc::clone(&report);
            self.drawn = Some(DrawnRun { report, scene, is_partial: has_errors });
            self.memory.settle();
        }
        let lost = if has_errors { Vec::new() } else { self.lost(place.settings) };
        let mut troubles = match lost[..] {
            [] => report.unknown_settings.clone(),
            _ => lost.iter().map(told_lost).collect(),
        };
        if was_stopped {
            troubles.push("the drawing was stopped".to_owned());
        }
        let told = RunOutcome {
            report: Some(&report),
            is_current: !has_errors && !was_stopped,
            troubles: &troubles,
            milliseconds: [evaluated - begin, (run.clock)() - evaluated],
        };
        let lost = lost.into_iter().map(|setting| setting.name.clone()).collect();
        Some(Shown { lost, ..self.shown(place, told) })
    }

    /// Learns the parameters of the script and of what it imports. Those of a script with errors are the
    /// ones that it had; as long as it never was whole, the ones that have values.
    fn look_at_parameters(&mut self, PageRun { name, bytes, files, .. }: PageRun<'_>) {
        match self.session.parameters(name, bytes, files) {
            Ok(schema) => {
                self.schema = Some(schema);
                self.is_schema_whole = true;
            }
            Err(_) if self.is_schema_whole => return,
            Err(_) => self.schema = self.session.known_parameters(name, bytes, files),
        }
        self.imports = imports::json(&self.session, bytes, files);
    }

    /// Settings of parameters that the script had and, without errors, has no more.
    fn lost<'s>(&mut self, settings: &'s [Setting]) -> Vec<&'s Setting> {
        let parameters = self.schema.iter().flat_map(|schema| &schema.parameters);
        let has: BTreeSet<&str> = parameters.map(|parameter| parameter.name.as_str()).collect();
        let is_lost = |setting: &&Setting| {
            !has.contains(setting.name.as_str()) && self.had.contains(&setting.name)
        };
        let lost = settings.iter().filter(is_lost).collect();
        self.had.extend(has.into_iter().map(str::to_owned));
        lost
    }

    /// What is shown of a script that is not there.
    #[cfg(feature = "cli")]
    pub(crate) fn unread(&self, place: RunPlace<'_>, message: &str) -> Shown {
        let told = RunOutcome {
            report: None,
            is_current: false,
            troubles: &[message.to_owned()],
            milliseconds: [0.0; 2],
        };
        self.shown(place, told)
    }

    fn shown(&self, place: RunPlace<'_>, told: RunOutcome<'_>) -> Shown {
        let drawn = self.drawn.as_ref();
        let json = state::json(
            &state::Setup {
                place,
                schema: self.schema.as_ref(),
                imports: &self.imports,
                drawn: drawn.map(|drawn| (&*drawn.report, &*drawn.scene)),
                is_partial: drawn.is_some_and(|drawn| drawn.is_partial),
            },
            &told,
        );
        let names = |schema: &Schema| -> Vec<String> {
            schema.parameters.iter().map(|parameter| parameter.name.clone()).collect()
        };
        Shown {
            version: place.version,
            is_current: told.is_current,
            state: json.to_string().into_bytes(),
            scene: drawn.map(|drawn| Arc::clone(&drawn.scene)).unwrap_or_default(),
            report: drawn.map(|drawn| Arc::clone(&drawn.report)),
            parameters: self.schema.as_ref().map(names).unwrap_or_default(),
            lost: Vec::new(),
            inputs: Vec::new(),
        }
    }
}

/// That a setting is forgotten.
fn told_lost(setting: &&Setting) -> String {
    let Setting { name, text, .. } = setting;
    format!("the script has no parameter `{name}` any more: its value, {text}, is forgotten")
}
