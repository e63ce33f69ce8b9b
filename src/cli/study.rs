//! `virote study`: a script with many values of its parameters, a row of results for each.

mod tally;

use std::{
    cell::Cell,
    fs,
    io::Write,
    path::{Path, PathBuf},
    time::Duration,
};

use clap::Args;
use serde_json::{Map, Value as Json, json};
use tally::Tally;

use super::{
    exit_status::ExitStatus,
    interrupt::{self, INTERRUPTED},
    looks::{self, PictureArgs},
    process,
    progress::{Progress, StudyProgress},
    reporter::Reporter,
    run_args::RunArgs,
    settings,
};
use crate::{
    disk::{OutputTarget, Script, ScriptFiles, TargetRefusal, replace},
    eval::{Schema, Setting, unknown_parameter},
    export::io_reason,
    limits::work::StopToken,
    session::Session,
    study::{
        Evaluation, Journal, KeptFiles, Plan, ResultColumns, ResultFormat, RowMaker, STOPPED,
        StudyPictures, VariedParameter, checksum, contact_sheets, in_order, write_results,
    },
};

/// What `virote study` is asked for.
#[derive(Debug, Args)]
pub(super) struct StudyOptions {
    /// The script
    file: PathBuf,
    /// The values, a row for each variant: CSV or Parquet, whose columns are called like parameters,
    /// with units in square brackets: `neck [mm]`; a column `id` names the variants
    #[arg(value_name = "PLAN", required_unless_present = "vary", conflicts_with = "vary")]
    plan: Option<PathBuf>,
    /// The results; the ending chooses the format: `.csv`, `.jsonl` or `.parquet`
    #[arg(long, short, value_name = "RESULTS")]
    out: PathBuf,
    /// Varies a parameter: `neck=10mm..20mm:11` are eleven values, `neck=10mm,15mm` two; of several
    /// parameters all combinations
    #[arg(long, value_name = "NAME=VALUES", value_parser = VariedParameter::read)]
    vary: Vec<VariedParameter>,
    /// Keeps only this definition as a result; may be given several times [default: every number,
    /// text and truth value that has a name]
    #[arg(long, value_name = "NAME")]
    want: Vec<String>,
    /// Stops a variant that takes longer, such as 10s or 500ms, and goes on with the next
    #[arg(long, value_name = "TIME", value_parser = duration)]
    time_limit: Option<Duration>,
    /// Begins anew where results, or rows of a study that was ended, are there already
    #[arg(long)]
    fresh: bool,
    /// Draws each variant into this folder, and sheets with all of them, `contact-1.png`
    #[arg(long, value_name = "FOLDER")]
    render: Option<PathBuf>,
    #[command(flatten)]
    drawn: Box<PictureArgs>,
    #[command(flatten)]
    common: RunArgs,
}

/// What the file of a study that is not done is called behind the name of its results.
const UNFINISHED: &str = "unfinished";

/// Rows of a plan from one sign of life to the next.
const ROWS_A_SIGN: u64 = 10_000;

/// `virote study SCRIPT PLAN -o RESULTS`
pub(super) fn run(asked: &StudyOptions) -> ExitStatus {
    let voice = Reporter::new(&asked.common.talk, asked.common.ceilings().diagnostics);
    match study(asked, &voice) {
        Ok(ending) | Err(StudyFailure::Told(ending)) => ending,
        Err(StudyFailure::Misuse(message)) => {
            message.lines().for_each(|line| voice.trouble(line));
            if INTERRUPTED.is_stopped() { ExitStatus::Interrupted } else { ExitStatus::Usage }
        }
    }
}

/// Why there is no study.
enum StudyFailure {
    /// What has been told.
    Told(ExitStatus),
    /// A sentence.
    Misuse(String),
}

impl From<String> for StudyFailure {
    fn from(message: String) -> Self {
        Self::Misuse(message)
    }
}

fn study(asked: &StudyOptions, voice: &Reporter) -> Result<ExitStatus, StudyFailure> {
    // Look at all that is asked before anything is evaluated.
    let format = ResultFormat::of(&asked.out)?;
    let session = asked.common.session();
    let settings = settings::given(&asked.common, session.limits().input_bytes, voice)
        .map_err(StudyFailure::Told)?;
    let script = Script::read(&asked.file, session.limits().source_bytes)?;
    check_target(asked, &script)?;
    let content = looks::content(&asked.drawn)?;
    let disk = ScriptFiles::new(&script.folder);
    let schema = schema(&session, &script, &disk, voice)?;
    check_settings(&settings, &schema)?;
    let mut plan = match &asked.plan {
        Some(path) => Plan::file(path)?,
        None => Plan::grid(&asked.vary)?,
    };
    let progress = Progress::begin("reading the plan", voice.is_lively());
    let (n_variants, plan_sum) = checked(&mut plan, &schema, &progress)?;
    let maker = RowMaker::new(schema, asked.want.clone());
    check_wants(&asked.want, &session, (&script, &disk), voice)?;

    // Go on where an earlier run ended.
    let header = header(asked, &script, &settings, &plan_sum);
    progress.say("reading the rows that are there");
    let mut journal = Journal::open(&unfinished(&asked.out), &header, asked.fresh)?;
    drop(progress);
    if 0 < journal.n_rows {
        voice.remark(&format!("{} of {n_variants} rows are there already", journal.n_rows));
    }
    let files = KeptFiles::new(&disk, std::mem::take(&mut journal.files));
    if let Some(folder) = &asked.render {
        make_folder(folder)?;
    }
    let new_session = |stop: StopToken| process::session(asked.common.ceilings()).stopped_by(stop);
    let evaluation = Evaluation {
        name: &script.name,
        bytes: &script.bytes,
        files: &files,
        settings: &settings,
        session: &new_session,
        maker: &maker,
        n_workers: asked.common.n_threads(),
        time_limit: asked.time_limit,
        pictures: asked.render.as_deref().map(|folder| StudyPictures {
            folder,
            content: content.clone(),
            n_digits: n_variants.to_string().len(),
        }),
        stop: &INTERRUPTED,
    };
    let evaluated = evaluate(&evaluation, (&plan, n_variants), &files, &mut journal, voice);
    let ended = match evaluated {
        Err(message) => Some(message),
        Ok(()) => (journal.n_rows < n_variants).then(|| STOPPED.to_owned()),
    };
    if let Some(message) = ended {
        let is_lasting = !plan.was_changed();
        if !is_lasting {
            journal.spoil()?;
        }
        let told = cut_short(&asked.out, journal, (n_variants, is_lasting), &message);
        return Err(StudyFailure::Misuse(told));
    }
    finish(asked, format, journal, (&script, n_variants), voice)
}

/// How many variants a plan has, and its sum, as [`Plan::check`] tells them, with signs of life; Ctrl-C ends the reading.
fn checked(
    plan: &mut Plan,
    schema: &Schema,
    progress: &Progress,
) -> Result<(u64, String), StudyFailure> {
    interrupt::listen_once();
    let found = plan.check(schema, &mut |n_rows| {
        if n_rows % ROWS_A_SIGN == 0 {
            progress.say(&format!("reading the plan: {n_rows} rows"));
        }
        !INTERRUPTED.is_stopped()
    })?;
    Ok(found)
}

fn make_folder(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder)
        .map_err(|err| format!("cannot make `{}`: {}", folder.display(), io_reason(&err)))
}

/// What to tell of a study that did not come to its end; of its rows if there are any, else nothing is kept. Those of
/// a plan that was changed do not last.
fn cut_short(
    out: &Path,
    journal: Journal,
    (n_variants, is_lasting): (u64, bool),
    message: &str,
) -> String {
    let (n_rows, name) = (journal.n_rows, unfinished(out));
    let name = name.display();
    match (n_rows, is_lasting) {
        (0, _) => {
            journal.remove();
            message.to_owned()
        }
        (_, true) => format!(
            "{message}\n{n_rows} of {n_variants} rows are kept in `{name}`; the same command goes on behind them"
        ),
        (_, false) => format!(
            "{message}\n{n_rows} rows of before or after that are left in `{name}`; `--fresh` begins anew"
        ),
    }
}

/// The parameters of the script; what is wrong with it whatever they are has been told.
fn schema(
    session: &Session,
    script: &Script,
    files: &ScriptFiles,
    voice: &Reporter,
) -> Result<Schema, StudyFailure> {
    session.parameters(&script.name, &script.bytes, files).map_err(|report| {
        voice.findings(&report.diagnostics, &report.sources);
        StudyFailure::Told(ExitStatus::Wrong)
    })
}

/// Refuses wanted results that the script does not define.
fn check_wants(
    wants: &[String],
    session: &Session,
    (script, files): (&Script, &ScriptFiles),
    voice: &Reporter,
) -> Result<(), StudyFailure> {
    let graph = session.graph(&script.name, &script.bytes, files).map_err(|report| {
        voice.findings(&report.diagnostics, &report.sources);
        StudyFailure::Told(ExitStatus::Wrong)
    })?;
    let defined: Vec<&str> = graph.nodes.iter().map(|node| node.name.as_str()).collect();
    Ok(crate::study::check_wants(wants, &defined)?)
}

/// Refuses settings that no parameter takes, as the first variant would.
fn check_settings(settings: &[Setting], schema: &Schema) -> Result<(), String> {
    let names = schema.names();
    match settings.iter().find(|setting| !names.contains(&setting.name.as_str())) {
        Some(setting) => Err(unknown_parameter(&setting.name, &names)),
        None => Ok(()),
    }
}

/// Refuses results in the place of the script or the plan, and of results that are there.
fn check_target(asked: &StudyOptions, script: &Script) -> Result<(), String> {
    let out = &asked.out;
    let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty());
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    let inputs: Vec<PathBuf> = script.path.iter().chain(&asked.plan).cloned().collect();
    let target = OutputTarget::new(folder.unwrap_or(Path::new(".")), &name, &inputs);
    target.map_err(|refusal| match refusal {
        TargetRefusal::Forbidden(why) if inputs.iter().any(|input| input == out) => {
            why.replace("the script or one of its inputs", "the script or the plan")
        }
        TargetRefusal::Forbidden(why) | TargetRefusal::System(why) => why,
    })?;
    if out.exists() && !asked.fresh {
        return Err(format!(
            "`{}` is there already; `--fresh` replaces it, and another name keeps it",
            out.display()
        ));
    }
    Ok(())
}

/// The journal of a study with these results.
fn unfinished(out: &Path) -> PathBuf {
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!("{name}.{UNFINISHED}"))
}

/// What must be the same for rows of two runs to belong together.
fn header(
    asked: &StudyOptions,
    script: &Script,
    settings: &[Setting],
    plan_sum: &str,
) -> Map<String, Json> {
    let settings: Vec<String> =
        settings.iter().map(|setting| format!("{}={}", setting.name, setting.text)).collect();
    let limits = format!("{:?}", asked.common.ceilings());
    let members = [
        ("virote study", json!(env!("CARGO_PKG_VERSION"))),
        ("script", json!(checksum(&script.bytes))),
        ("plan", json!(plan_sum)),
        ("`--set`", json!(settings)),
        ("`--want`", json!(asked.want)),
        ("`--limit`", json!(checksum(limits.as_bytes()))),
        ("`--time-limit`", json!(asked.time_limit.map(|limit| limit.as_secs_f64()))),
        ("`--render`", json!(asked.render)),
    ];
    members.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// Evaluates what the journal has no rows of, and adds them.
fn evaluate(
    evaluation: &Evaluation<'_>,
    (plan, n_variants): (&Plan, u64),
    files: &KeptFiles<'_>,
    journal: &mut Journal,
    voice: &Reporter,
) -> Result<(), String> {
    let n_kept = journal.n_rows;
    let variants = plan.variants().skip(n_kept.try_into().unwrap_or(usize::MAX));
    let progress = StudyProgress::begin(n_variants, n_kept, voice.is_lively());
    in_order(evaluation, variants, |row| {
        if let Some(path) = files.changed() {
            return Err(format!(
                "`{path}` is not what it was for the rows that are there; `--fresh` begins anew"
            ));
        }
        for (path, sum) in files.take_news() {
            journal.note(&path, &sum)?;
        }
        journal.add(&row)?;
        progress.done();
        Ok(())
    })
}

/// Writes the results, and tells what came of the study.
fn finish(
    asked: &StudyOptions,
    format: ResultFormat,
    journal: Journal,
    (script, n_variants): (&Script, u64),
    voice: &Reporter,
) -> Result<ExitStatus, StudyFailure> {
    let progress = Progress::begin("writing the results", voice.is_lively());
    let mut columns = ResultColumns::default();
    let mut tally = Tally::default();
    let until_stopped = |row| if INTERRUPTED.is_stopped() { Err(STOPPED.to_owned()) } else { row };
    for row in journal.rows()? {
        let row = until_stopped(row).map_err(|message| unwritten(asked, &message))?;
        columns.add(&row);
        tally.add(&row);
    }
    let rows = Cell::new(Some(journal.rows()?.map(until_stopped)));
    let write = |out: &mut dyn Write| {
        let Some(rows) = rows.take() else { return Ok(()) };
        write_results(format, &columns, rows, out)
    };
    replace(&asked.out, None, write).map_err(|err| unwritten(asked, &io_reason(&err)))?;
    let sheets = match &asked.render {
        Some(folder) => contact_sheets(folder, journal.rows()?)?,
        None => Vec::new(),
    };
    journal.remove();
    drop(progress);
    let is_other = |path: &PathBuf| fs::read(path).is_ok_and(|bytes| bytes != script.bytes);
    if script.path.as_ref().is_some_and(is_other) {
        voice.remark(&format!(
            "{} was changed while the study ran; all rows are of the text as it was at its start",
            script.name
        ));
    }
    voice.study(&asked.out.display().to_string(), n_variants, (tally.n_failed, &tally.errors));
    for sheet in sheets {
        let folder = asked.render.clone().unwrap_or_default();
        voice.remark(&format!("drew {}", folder.join(sheet).display()));
    }
    Ok(ExitStatus::Well)
}

/// What to tell of results that were not written.
fn unwritten(asked: &StudyOptions, why: &str) -> String {
    format!(
        "cannot write `{}`: {why}\nall rows are kept in `{}`; the same command writes them",
        asked.out.display(),
        unfinished(&asked.out).display()
    )
}

/// Reads `10s`, `500ms` or `2min`.
fn duration(text: &str) -> Result<Duration, String> {
    let wrong = || "write a time such as 10s, 500ms or 2min".to_owned();
    let digits = text.trim_end_matches(char::is_alphabetic);
    let number: f64 = digits.trim().parse().map_err(|_| wrong())?;
    let seconds = match &text[digits.len()..] {
        "ms" => number / 1000.0,
        "s" => number,
        "min" => 60.0 * number,
        _ => return Err(wrong()),
    };
    let time = Duration::try_from_secs_f64(seconds).map_err(|_| wrong())?;
    if time.is_zero() { Err("a variant needs some time".to_owned()) } else { Ok(time) }
}
