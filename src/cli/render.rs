//! `virote render`: a picture of the geometry of a script.

use std::path::{Path, PathBuf};

use super::{
    exit_status::ExitStatus,
    looks::{self, PictureArgs},
    progress::Progress,
    reporter::Reporter,
    run::keeps_back,
    run_args::RunArgs,
    settings,
};
use crate::{
    diag::{Diagnostic, Severity},
    disk::{OutputTarget, Script, ScriptFiles, TargetRefusal},
    export::{ExportError, Format, Job, PICTURES, Summary},
    kernel::GeomError,
    limits::{
        Ceiling,
        work::{self, End, Watch},
    },
    session::{PictureContent, Report},
    value::At,
};

/// `virote render FILE -o PICTURE`
pub(super) fn run(path: &Path, out: &Path, drawn: &PictureArgs, common: &RunArgs) -> ExitStatus {
    let session = common.session();
    let voice = Reporter::new(&common.talk, session.limits().diagnostics);
    let (format, content) = match asked(out, drawn, session.limits().picture_pixels) {
        Ok(asked) => asked,
        Err(message) => {
            voice.trouble(&message);
            return ExitStatus::Usage;
        }
    };
    let settings = match settings::given(common, session.limits().input_bytes, &voice) {
        Ok(settings) => settings,
        Err(ending) => return ending,
    };
    let script = match Script::read(path, session.limits().source_bytes) {
        Ok(script) => script,
        Err(message) => {
            voice.trouble(&message);
            return ExitStatus::Usage;
        }
    };
    let files = ScriptFiles::new(&script.folder);
    let progress = Progress::begin(&format!("evaluating {}", script.name), voice.is_lively());
    let report = session.run(&script.name, &script.bytes, &files, &settings);
    let mut inputs = files.inputs();
    inputs.extend(script.path);
    inputs.extend(common.params.clone());

    let has_errors = report.count(Severity::Error) > 0;
    // What an error touches has no value to draw; a name that was asked for is told.
    let is_kept_back = keeps_back(&report, common.strict);
    let done = if !report.unknown_settings.is_empty() {
        Err(PictureFailure::Told(report.unknown_settings.join("\n"), ExitStatus::Usage))
    } else if is_kept_back {
        Ok(None)
    } else {
        let job = session.picture(&report, &content, format);
        let job = job.map_err(|text| match has_errors {
            true => PictureFailure::Told(text, ExitStatus::Wrong),
            false => PictureFailure::Told(text, ExitStatus::Usage),
        });
        let watch = session.watch();
        let target = (format, out, &*inputs);
        job.and_then(|job| draw(&job, &report, watch, target, &progress)).map(Some)
    };
    drop(progress);
    voice.findings(&report.diagnostics, &report.sources);
    report_outcome(done, out, &report, &voice)
}

/// Tells what came of the picture, and how the run ends.
fn report_outcome(
    done: Result<Option<Summary>, PictureFailure>,
    out: &Path,
    report: &Report,
    voice: &Reporter,
) -> ExitStatus {
    let has_errors = report.count(Severity::Error) > 0;
    match done {
        Ok(Some(summary)) => {
            voice.written(&out.display().to_string(), Some(summary));
            if has_errors {
                voice.remark("what an error touches was not drawn; with `--strict` nothing is");
            }
            ExitStatus::of(report)
        }
        Ok(None) => {
            voice.remark("nothing was drawn, because the script has errors");
            ExitStatus::of(report)
        }
        Err(PictureFailure::Found(found)) => {
            voice.findings(&[*found], &report.sources);
            ExitStatus::of(report).max(ExitStatus::Wrong)
        }
        Err(PictureFailure::Told(message, ending)) => {
            message.lines().for_each(|line| voice.trouble(line));
            ExitStatus::of(report).max(ending)
        }
    }
}

/// Why nothing was drawn: a sentence, or a finding at its place in the script.
enum PictureFailure {
    Told(String, ExitStatus),
    Found(Box<Diagnostic>),
}

/// What cannot be drawn, at its definition or where its function says why.
fn undrawable(
    report: &Report,
    job: &Job,
    name: &str,
    reason: &GeomError,
) -> Option<PictureFailure> {
    let item = job.items.iter().find(|item| item.name == name)?;
    let defined = report.definitions.iter().find(|defined| defined.name == item.group)?;
    Err::<(), _>(reason.clone()).at(defined.span).err().map(PictureFailure::Found)
}

/// The format of the picture and what it is to show, or what is wrong with that.
fn asked<'a>(
    out: &Path,
    drawn: &'a PictureArgs,
    most_pixels: usize,
) -> Result<(&'static Format, PictureContent<'a>), String> {
    let format = Format::among(PICTURES, &out.to_string_lossy());
    let format = format.ok_or_else(|| unknown_ending(out))?;
    let [width, height] = drawn.size;
    if most_pixels < width.saturating_mul(height) {
        return Err(format!(
            "a picture of {width}x{height} pixels; the ceiling is {most_pixels} pixels in all"
        ));
    }
    Ok((format, looks::content(drawn)?))
}

/// Draws, and puts the picture into its place.
fn draw(
    job: &Job,
    report: &Report,
    watch: Watch,
    (format, out, inputs): (&Format, &Path, &[PathBuf]),
    progress: &Progress,
) -> Result<Summary, PictureFailure> {
    let shown = out.display().to_string();
    let cannot = |why: String| {
        PictureFailure::Told(format!("cannot write `{shown}`: {why}"), ExitStatus::Usage)
    };
    let folder = match out.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    let target = OutputTarget::new(folder, &name, inputs).map_err(|refusal| match refusal {
        TargetRefusal::Forbidden(message) | TargetRefusal::System(message) => cannot(message),
    })?;
    progress.say(&format!("drawing {shown}"));
    let told = |n_bytes| progress.written(&shown, n_bytes);
    let write = |out: &mut dyn std::io::Write| (format.write)(job, out);
    let stage = || target.stage(job.limits.output_bytes, &told, write);
    let (staged, done) = work::under(watch, stage);
    let staged = done.end.map_or(staged, |end| Err(ExportError::Ended(end)));
    let wrong = |why: String| PictureFailure::Told(why, ExitStatus::Wrong);
    let (staged, summary) = staged.map_err(|err| match &err {
        ExportError::Io(_) => cannot(err.reason()),
        ExportError::Viewpoint(_) => PictureFailure::Told(err.reason(), ExitStatus::Usage),
        ExportError::Ended(end) => wrong(ended(*end, &shown, job)),
        ExportError::Geometry { name, source } => {
            undrawable(report, job, name, source).unwrap_or_else(|| wrong(err.reason()))
        }
        _ => wrong(err.reason()),
    })?;
    staged.place().map_err(|err| cannot(ExportError::Io(err).reason()))?;
    Ok(summary)
}

/// Why the drawing was ended, and what to do.
fn ended(end: End, shown: &str, job: &Job) -> String {
    let (most, unit, ceiling) = match end {
        End::Stopped => return format!("the drawing of `{shown}` was stopped"),
        End::Steps => (job.limits.steps, "steps", Ceiling::STEPS),
        End::Memory => (job.limits.memory_bytes as u64, "bytes of memory", Ceiling::MEMORY),
    };
    format!(
        "drawing `{shown}` takes more than {most} {unit}; `--limit {ceiling}=N` moves this ceiling"
    )
}

fn unknown_ending(out: &Path) -> String {
    let endings: Vec<String> =
        PICTURES.iter().map(|format| format!("`.{}`", format.ending)).collect();
    let endings = endings.join(" or ");
    match out.extension() {
        Some(ending) => {
            let ending = ending.to_string_lossy();
            format!("a picture ends in {endings}, and `{}` in `.{ending}`", out.display())
        }
        None => format!("a picture ends in {endings}, and `{}` in neither", out.display()),
    }
}
