//! `virote run` and `virote check`.

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
};

use super::{
    doubts::doubts, exit_status::ExitStatus, progress::Progress, reporter::Reporter,
    run_args::RunArgs, settings,
};
use crate::{
    diag::{Code, Diagnostic, Severity, fault, nearest},
    disk::{OutputTarget, Script, ScriptFiles, StagedFile, TargetRefusal},
    eval::Setting,
    export::{ExportError, Summary, capped},
    limits::work::StopToken,
    session::{Event, File, Report, Session},
};

/// Whether and where a run writes its files.
#[derive(Clone, Copy)]
pub(super) enum OutputMode<'a> {
    /// Below this folder; by default the script's own.
    Write(Option<&'a Path>),
    /// Nowhere, but tells what it would write.
    DryRun(Option<&'a Path>),
    /// Nowhere.
    Check,
}

/// `virote run FILE`; with names in `only`, only the exports that name one of them.
pub(super) fn run(
    path: &Path,
    out: Option<&Path>,
    dry_run: bool,
    only: &[String],
    common: &RunArgs,
) -> ExitStatus {
    let mode = if dry_run { OutputMode::DryRun(out) } else { OutputMode::Write(out) };
    let run = match RunOptions::new(mode, only, common) {
        Ok(run) => run,
        Err(ending) => return ending,
    };
    run.interpret(path)
}

/// `virote check FILE...`: the worst ending of all.
pub(super) fn check(paths: &[PathBuf], common: &RunArgs) -> ExitStatus {
    let run = match RunOptions::new(OutputMode::Check, &[], common) {
        Ok(run) => run,
        Err(ending) => return ending,
    };
    paths.iter().map(|path| run.interpret(path)).max().unwrap_or(ExitStatus::Well)
}

/// What is done with each script.
pub(super) struct RunOptions<'a> {
    session: Session,
    voice: Reporter,
    settings: Vec<Setting>,
    /// The file that settings come from.
    params: Option<&'a Path>,
    only: &'a [String],
    mode: OutputMode<'a>,
    is_strict: bool,
    /// Ends a run for another one.
    stop: StopToken,
    /// Whether a run has been evaluated, and is carried out.
    is_evaluated: Arc<Mutex<bool>>,
}

impl<'a> RunOptions<'a> {
    /// Reads the settings; what is wrong with them has been told.
    pub(super) fn new(
        mode: OutputMode<'a>,
        only: &'a [String],
        common: &'a RunArgs,
    ) -> Result<Self, ExitStatus> {
        let session = common.session();
        let voice = Reporter::new(&common.talk, session.limits().diagnostics);
        let settings = settings::given(common, session.limits().input_bytes, &voice)?;
        Ok(Self {
            session,
            voice,
            settings,
            params: common.params.as_deref(),
            only,
            mode,
            is_strict: common.strict,
            stop: StopToken::default(),
            is_evaluated: Arc::default(),
        })
    }

    /// The same with a memory, so that each run evaluates only what changed, and to be stopped by this until it is
    /// evaluated, which the switch tells: what it did not come to is not told then.
    pub(super) fn watching(self, stop: StopToken, is_evaluated: Arc<Mutex<bool>>) -> Self {
        let session = self.session.incremental().stopped_by(stop.clone());
        Self { session, stop, is_evaluated, ..self }
    }

    /// Who tells.
    pub(super) fn voice(&self) -> &Reporter {
        &self.voice
    }

    /// The script of a file; what is wrong with it is told.
    pub(super) fn read(&self, path: &Path) -> Option<Script> {
        let script = Script::read(path, self.session.limits().source_bytes);
        script.map_err(|message| self.voice.trouble(&message)).ok()
    }

    fn interpret(&self, path: &Path) -> ExitStatus {
        let Some(script) = self.read(path) else { return ExitStatus::Usage };
        let files = ScriptFiles::new(&script.folder);
        self.carry_out(script, &files).1
    }

    /// Does all that the script wants, with data from `files`.
    pub(super) fn carry_out(&self, script: Script, files: &ScriptFiles) -> (Report, ExitStatus) {
        let voice = &self.voice;
        let progress = Progress::begin(&format!("evaluating {}", script.name), voice.is_lively());
        let mut report = self.session.run(&script.name, &script.bytes, files, &self.settings);
        *self.is_evaluated.lock().unwrap_or_else(PoisonError::into_inner) = true;
        if self.stop.is_stopped() {
            return (report, ExitStatus::Wrong);
        }
        let mut misuse = std::mem::take(&mut report.unknown_settings);
        misuse.extend(choose(&mut report, self.only));
        if !misuse.is_empty() {
            misuse.iter().for_each(|message| voice.trouble(message));
            voice.findings(&report.diagnostics, &report.sources);
            return (report, ExitStatus::Usage);
        }
        let out = match self.mode {
            OutputMode::Write(Some(out)) | OutputMode::DryRun(Some(out)) => out.to_path_buf(),
            _ => script.folder.clone(),
        };
        let mut inputs = files.inputs();
        inputs.extend(script.path);
        inputs.extend(self.params.map(Path::to_path_buf));
        let targets = targets(&mut report, &out, &inputs);
        let ending = act(&report, &targets, (self.mode, self.is_strict), progress, voice);
        (report, ending)
    }
}

/// Keeps the files that name a definition of `only`, unless that is empty; names that choose
/// nothing are told.
fn choose(report: &mut Report, only: &[String]) -> Vec<String> {
    if only.is_empty() {
        return Vec::new();
    }
    let exported: Vec<&String> = report
        .events
        .iter()
        .filter_map(|event| match event {
            Event::File(file) => Some(&file.names),
            _ => None,
        })
        .flatten()
        .collect();
    // Of a script with errors not every export is known.
    let is_whole = report.count(Severity::Error) == 0;
    let strangers = only.iter().filter(|name| is_whole && !exported.contains(name));
    let misuse = strangers.map(|name| not_exported(name, report, &exported)).collect();
    report.events.retain(|event| match event {
        Event::File(file) => file.names.iter().any(|name| only.contains(name)),
        _ => true,
    });
    misuse
}

/// What is wrong with a name that chooses no export.
fn not_exported(name: &str, report: &Report, exported: &[&String]) -> String {
    let is_export = |event: &Event| matches!(event, Event::File(_));
    let defined = || report.definitions.iter().map(|defined| defined.name.as_str());
    let near_exported = nearest(name, exported.iter().map(|name| name.as_str()));
    let is_defined = defined().any(|defined| defined == name);
    let (text, near) = if is_defined {
        (format!("no export of the script names `{name}`"), near_exported)
    } else {
        let near = near_exported.or_else(|| nearest(name, defined()));
        (format!("the script defines no `{name}`"), near)
    };
    let mut names: Vec<&str> = exported.iter().map(|name| name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    match near {
        Some(near) => format!("{text}; did you mean `{near}`?"),
        None if names.is_empty() && report.events.iter().any(is_export) => {
            format!("{text}, and its exports name none: give what they write a name")
        }
        None if names.is_empty() => format!("{text}, and it exports nothing"),
        None => format!("{text}; its exports name {}", names.join(", ")),
    }
}

/// The places of all files, before any is written; what is forbidden becomes a finding.
pub(super) fn targets(
    report: &mut Report,
    out: &Path,
    inputs: &[PathBuf],
) -> Vec<Result<OutputTarget, TargetRefusal>> {
    let mut targets = Vec::new();
    for event in &report.events {
        let Event::File(file) = event else { continue };
        targets.push(match OutputTarget::new(out, &file.path, inputs) {
            Err(TargetRefusal::Forbidden(message)) => {
                report.diagnostics.push(
                    Diagnostic::error(Code::PathEscapes, file.span, message.clone())
                        .hint("choose another name, or another folder by `--out`"),
                );
                Err(TargetRefusal::Forbidden(message))
            }
            other => other,
        });
    }
    report.diagnostics.sort_by_key(|found| found.primary.span);
    targets
}

/// Whether a run that was stopped, or that has errors and is to be strict, keeps back what it made.
pub(super) fn keeps_back(report: &Report, is_strict: bool) -> bool {
    let was_stopped = report.diagnostics.iter().any(|found| found.code == Code::Stopped);
    was_stopped || is_strict && report.count(Severity::Error) > 0
}

/// Prints, and writes the files that no error of the script touches; none of a script with errors where
/// that is to be strict.
pub(super) fn act(
    report: &Report,
    targets: &[Result<OutputTarget, TargetRefusal>],
    (mode, is_strict): (OutputMode<'_>, bool),
    progress: Progress,
    voice: &Reporter,
) -> ExitStatus {
    let has_errors = report.count(Severity::Error) > 0;
    let is_kept_back = keeps_back(report, is_strict);
    let mut ending = ExitStatus::of(report);
    let (mut n_checks, mut n_failed) = (0, 0);
    let mut outcomes = match is_kept_back {
        true => Vec::new(),
        false => staged(report, targets, mode, &progress),
    }
    .into_iter();
    drop(progress);
    let mut findings = report.diagnostics.clone();
    let is_refused =
        outcomes.as_slice().iter().any(|outcome| matches!(outcome, FileOutcome::Refused(..)));
    for event in &report.events {
        match event {
            Event::Printed(printed) => voice.printed(printed, None),
            Event::Checked(checked) => {
                voice.checked(checked, &report.sources, None);
                n_checks += 1;
                n_failed += usize::from(!checked.verdict.holds);
            }
            Event::File(file) => match outcomes.next() {
                Some(FileOutcome::Refused(found, worst)) => {
                    refuse(found, report, voice);
                    ending = ending.max(worst);
                }
                Some(FileOutcome::Told(summary)) if !is_refused => {
                    findings.extend(doubts(file, &summary));
                    voice.written(&file.path, None);
                }
                Some(FileOutcome::Staged(staged, summary)) if !is_refused => match staged.place() {
                    Ok(()) => {
                        findings.extend(doubts(file, &summary));
                        voice.written(&file.path, Some(summary));
                    }
                    Err(err) => {
                        let (found, worst) = refusal(file, &ExportError::Io(err));
                        refuse(found, report, voice);
                        ending = ending.max(worst);
                    }
                },
                _ => {}
            },
            // Only a test expects errors.
            Event::Expected(_) => {}
        }
    }
    // Last, so that what is wrong is what stands above the prompt.
    findings.sort_by_key(|found| found.primary.span);
    voice.findings(&findings, &report.sources);
    if is_kept_back && !targets.is_empty() {
        voice.remark("nothing was written, because the script has errors");
    } else if has_errors && !targets.is_empty() && matches!(mode, OutputMode::Write(_)) {
        voice.remark("what an error touches was not written; with `--strict` nothing is");
    }
    if is_refused && 1 < targets.len() {
        voice.remark("nothing was written, because not all files could be");
    }
    voice.verdict(n_checks, n_failed);
    ending
}

/// What came of a file before any is put into its place.
enum FileOutcome {
    /// Written under a temporary name.
    Staged(StagedFile, Summary),
    /// Not written, but it would be.
    Told(Summary),
    /// Not asked for.
    Unasked,
    /// Cannot be: why, and how the run ends.
    Refused(Diagnostic, ExitStatus),
}

fn staged(
    report: &Report,
    targets: &[Result<OutputTarget, TargetRefusal>],
    mode: OutputMode<'_>,
    progress: &Progress,
) -> Vec<FileOutcome> {
    let files = report.events.iter().filter_map(|event| match event {
        Event::File(file) => Some(file),
        _ => None,
    });
    files.zip(targets).map(|(file, target)| stage(file, target, mode, progress)).collect()
}

fn stage(
    file: &File,
    target: &Result<OutputTarget, TargetRefusal>,
    mode: OutputMode<'_>,
    progress: &Progress,
) -> FileOutcome {
    let target = match (mode, target) {
        // What is forbidden is a mistake of the script, and has been told.
        (OutputMode::Check, _) | (_, Err(TargetRefusal::Forbidden(_))) => {
            return FileOutcome::Unasked;
        }
        (_, Err(TargetRefusal::System(message))) => {
            let message = format!("cannot write `{}`: {message}", file.path);
            let found = Diagnostic::error(Code::CannotWrite, file.span, message);
            return FileOutcome::Refused(found, ExitStatus::Usage);
        }
        (_, Ok(target)) => target,
    };
    let most = file.job.limits.output_bytes;
    progress.say(&format!("preparing {}", file.path));
    let told = |n_bytes| progress.written(&file.path, n_bytes);
    let write = |out: &mut dyn Write| (file.format.write)(&file.job, out);
    // Without writing it can be told whether it could be: whether there is a place, and a format for it.
    let stage = || match mode {
        OutputMode::Write(_) => target
            .stage(most, &told, write)
            .map(|(staged, summary)| FileOutcome::Staged(staged, summary)),
        _ => target
            .probe()
            .map_err(ExportError::from)
            .and_then(|()| capped(&mut io::sink(), most, &told, write))
            .map(FileOutcome::Told),
    };
    let staged = || Ok(file.watched(stage));
    match fault::caught(file.span, staged) {
        Ok(Ok(outcome)) => outcome,
        Ok(Err(err)) => {
            let (found, ending) = refusal(file, &err);
            FileOutcome::Refused(found, ending)
        }
        Err(found) => FileOutcome::Refused(*found, ExitStatus::Usage),
    }
}

/// Why a file cannot be written, and how the run ends.
pub(super) fn refusal(file: &File, err: &ExportError) -> (Diagnostic, ExitStatus) {
    let ending = match err {
        ExportError::Io(_) => ExitStatus::Usage,
        _ => ExitStatus::Wrong,
    };
    (file.refusal(err), ending)
}

fn refuse(found: Diagnostic, report: &Report, voice: &Reporter) {
    voice.findings(&[found], &report.sources);
}
