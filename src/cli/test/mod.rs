//! `virote test`: the tests and checks of scripts, files or whole folders of them, and their golden
//! folders.
//!
//! Several scripts are run at a time (`jobs`); what became of them is told in order (`report`), and
//! kept for other programs (`junit`).

mod golden;
mod jobs;
mod junit;
mod report;
mod tested;

use std::{
    fs,
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Instant,
};

use clap::Args;

use self::{
    golden::GoldenMode,
    report::TestReporter,
    tested::{TestAttempt, TestedScript, UnreadScript},
};
use super::{exit_status::ExitStatus, reporter::Reporter, run_args::RunArgs, settings};
use crate::{
    disk::{Script, ScriptFiles},
    eval::{Setting, TestFilter},
    export::io_reason,
    session::{Event, JobGate, Session},
};

/// What `virote test` is asked for.
#[derive(Debug, Args)]
pub(super) struct TestOptions {
    /// Scripts, or folders with scripts at any depth; `-` is standard input [default: .]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Runs only the tests whose names contain this, and not the checks outside of them
    #[arg(long, value_name = "SUBSTRING")]
    filter: Option<String>,
    /// Runs only the tests that are called exactly as `--filter` says
    #[arg(long, requires = "filter")]
    exact: bool,
    /// Rewrites golden folders with what the scripts say and write now; makes those of scripts that
    /// are named themselves
    #[arg(long, conflicts_with = "filter")]
    bless: bool,
    /// How many scripts are run at a time [default: one for each processor]
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// Writes the results into an XML file, as JUnit has them
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    #[command(flatten)]
    common: RunArgs,
}

impl TestOptions {
    /// Which tests are run, unless it is all of them.
    fn wanted(&self) -> Option<TestFilter<'_>> {
        let kind = if self.exact { TestFilter::Named } else { TestFilter::Containing };
        self.filter.as_deref().map(kind)
    }
}

/// `virote test [PATH...]`: the worst ending of all.
pub(super) fn run(asked: &TestOptions) -> ExitStatus {
    let common = &asked.common;
    let voice = Reporter::new(&common.talk, common.ceilings().diagnostics);
    let settings = match settings::given(common, common.ceilings().input_bytes, &voice) {
        Ok(settings) => settings,
        Err(ending) => return ending,
    };
    let here = [PathBuf::from(".")];
    let paths = if asked.paths.is_empty() { &here } else { &*asked.paths };
    let (mut found, mut ending) = (Vec::new(), ExitStatus::Well);
    for path in paths {
        match scripts(path) {
            Ok(scripts) => found.extend(scripts),
            Err(message) => {
                voice.trouble(&message);
                ending = ExitStatus::Usage;
            }
        }
    }
    let n_jobs = asked.jobs.map_or(common.n_threads(), NonZeroUsize::get).min(found.len().max(1));
    let session = common.session_for(n_jobs);
    let tests = TestRun {
        session,
        settings,
        filter: asked.wanted(),
        bless: asked.bless,
        door: JobGate::default(),
    };
    let mut teller = TestReporter::new(&voice, asked.junit.is_some());
    jobs::in_order(&found, n_jobs, |chosen| tests.script(chosen), |tried| teller.add(&tried));
    ending = ending.max(teller.ending());
    let is_missed = teller.n_tests() == 0 && ending == ExitStatus::Well;
    if let Some(filter) = asked.wanted().filter(|_| is_missed) {
        voice.trouble(&match filter {
            TestFilter::Containing(part) => format!("no test has a name that contains `{part}`"),
            TestFilter::Named(name) => format!("no test is called `{name}`"),
        });
        ending = ExitStatus::Usage;
    }
    teller.total();
    if let Some(path) = &asked.junit
        && let Err(err) = junit::write(path, teller.suites())
    {
        voice.trouble(&format!("cannot write `{}`: {}", path.display(), io_reason(&err)));
        ending = ExitStatus::Usage;
    }
    ending
}

/// A script to be tested.
struct ChosenScript {
    path: PathBuf,
    /// Whether the command names it, not only a folder around it.
    is_named: bool,
}

/// The scripts that a path stands for: itself, or what lies in a folder at any depth, in order.
fn scripts(path: &Path) -> Result<Vec<ChosenScript>, String> {
    if !path.is_dir() {
        return Ok(vec![ChosenScript { path: path.to_path_buf(), is_named: true }]);
    }
    let mut folders = vec![path.to_path_buf()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        let told = |err| {
            format!("cannot look into the folder `{}`: {}", folder.display(), io_reason(&err))
        };
        for entry in fs::read_dir(&folder).map_err(told)? {
            let entry = entry.map_err(told)?;
            let is_visible = !entry.file_name().to_string_lossy().starts_with('.');
            let path = entry.path();
            // Links to folders are not followed, since they could lead round in a circle.
            if entry.file_type().map_err(told)?.is_dir() {
                folders.extend(Some(path).filter(|_| is_visible));
            } else if is_visible && path.extension().is_some_and(|ending| ending == "geo") {
                found.push(path.strip_prefix(".").map(Path::to_path_buf).unwrap_or(path));
            }
        }
    }
    if found.is_empty() {
        return Err(format!("there is no script in the folder `{}`", path.display()));
    }
    found.sort();
    Ok(found.into_iter().map(|path| ChosenScript { path, is_named: false }).collect())
}

/// What is done with each script.
struct TestRun<'a> {
    session: Session,
    settings: Vec<Setting>,
    filter: Option<TestFilter<'a>>,
    bless: bool,
    door: JobGate,
}

impl TestRun<'_> {
    fn script(&self, chosen: &ChosenScript) -> TestAttempt {
        let begin = Instant::now();
        let script = Script::read(&chosen.path, self.session.limits().source_bytes)
            .map_err(|message| UnreadScript { name: chosen.path.display().to_string(), message })?;
        let files = ScriptFiles::new(&script.folder);
        let mut report = self.door.run(|| {
            self.session.test(&script.name, &script.bytes, &files, &self.settings, self.filter)
        });
        let golden = match &script.path {
            Some(path) if self.filter.is_none() && report.unknown_settings.is_empty() => {
                let wish = match (self.bless, chosen.is_named) {
                    (false, _) => GoldenMode::Compare,
                    (true, false) => GoldenMode::Bless,
                    (true, true) => GoldenMode::Make,
                };
                golden::judge(&mut report, &golden::folder(path), wish, self.session.limits())
            }
            _ => None,
        };
        let mut ending = ExitStatus::of(&report);
        if !report.unknown_settings.is_empty() {
            ending = ExitStatus::Usage;
        }
        let (golden, worst) = golden.map_or((None, ExitStatus::Well), |(it, its)| (Some(it), its));
        report.events.retain(|event| !matches!(event, Event::File(_)));
        report.definitions.clear();
        let ending = ending.max(worst);
        Ok(TestedScript { name: script.name, report, golden, ending, time: begin.elapsed() })
    }
}
