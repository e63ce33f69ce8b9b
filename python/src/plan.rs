//! Plans of studies, read as their variants are asked for: a long one takes no memory.

use std::{
    path::PathBuf,
    sync::{
        Mutex, PoisonError,
        mpsc::{self, Receiver, RecvTimeoutError, SyncSender},
    },
    thread,
    time::Duration,
};

use pyo3::{
    exceptions::{PyRuntimeError, PyValueError},
    prelude::*,
};
use virote::{
    disk::ScriptFiles,
    limits::work::StopToken,
    session,
    study::{Plan, Variant, VariedParameter},
};

/// A variant as Python has it: number, id as JSON, and values for parameters.
pub(crate) type PlainVariant = (u64, String, Vec<(String, String)>);

/// Variants that are read at a time.
const CHUNK: usize = 1000;

/// Chunks that wait to be asked for.
const AHEAD: usize = 2;

/// How often it is asked whether Ctrl-C was pressed while the plan is checked.
const TICK: Duration = Duration::from_millis(30);

/// How many variants there are and a sum that changes with them, or a mistake.
type Checked = Result<(u64, String), String>;

type Chunk = Result<Vec<PlainVariant>, String>;

/// The variants of a plan that was compared with its script, in their order.
#[pyclass(frozen, module = "virote._virote")]
pub(crate) struct PlanVariants {
    /// How many there are.
    #[pyo3(get)]
    n_variants: u64,
    /// A sum that changes with them.
    #[pyo3(get)]
    sum: String,
    chunks: Mutex<Receiver<Chunk>>,
}

#[pymethods]
impl PlanVariants {
    /// The next of them; none behind the last.
    fn next(&self, py: Python<'_>) -> PyResult<Vec<PlainVariant>> {
        let next = || self.chunks.lock().unwrap_or_else(PoisonError::into_inner).recv();
        match py.detach(next) {
            Ok(chunk) => chunk.map_err(PyValueError::new_err),
            Err(_) => Ok(Vec::new()),
        }
    }
}

/// The variants of a plan in a file, or of a grid `NAME=VALUES`, checked against the script.
#[pyfunction]
pub(crate) fn study_plan(
    py: Python<'_>,
    name: &str,
    text: &[u8],
    folder: PathBuf,
    plan: Option<PathBuf>,
    vary: Vec<String>,
) -> PyResult<PlanVariants> {
    let wrong = PyValueError::new_err::<String>;
    let files = ScriptFiles::new(&folder);
    let found = py.detach(|| session::Session::default().parameters(name, text, &files));
    let schema = found.map_err(|report| {
        let first = report.diagnostics.first().map(|found| found.message.clone());
        wrong(format!("{name}: {}", first.unwrap_or_default()))
    })?;
    let plan = match plan {
        Some(path) => Plan::file(&path).map_err(wrong)?,
        None => {
            let varied = vary.iter().map(|text| VariedParameter::read(text));
            Plan::grid(&varied.collect::<Result<Vec<_>, _>>().map_err(wrong)?).map_err(wrong)?
        }
    };
    let (told, checked) = mpsc::channel();
    let (sender, chunks) = mpsc::sync_channel(AHEAD);
    // It ends when nobody asks any more.
    let stop = StopToken::default();
    let stopped = stop.clone();
    let read = move || {
        let mut plan = plan;
        let outcome: Checked = plan.check(&schema, &mut |_| !stopped.is_stopped());
        let is_right = outcome.is_ok();
        if told.send(outcome).is_ok() && is_right {
            hand_out(&plan, &sender);
        }
    };
    let started = thread::Builder::new().name("virote-plan".to_owned()).spawn(read);
    started.map_err(|err| PyRuntimeError::new_err(format!("no thread: {err}")))?;
    let outcome = outcome_of(py, checked).inspect_err(|_| stop.stop())?;
    let (n_variants, sum) = outcome.map_err(wrong)?;
    Ok(PlanVariants { n_variants, sum, chunks: Mutex::new(chunks) })
}

/// What the check of a plan came to; nobody waits for a long one after Ctrl-C.
fn outcome_of(py: Python<'_>, checked: Receiver<Checked>) -> PyResult<Checked> {
    let lost = || PyRuntimeError::new_err("the plan could not be read");
    let checked = Mutex::new(checked);
    loop {
        let wait = || checked.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(TICK);
        match py.detach(wait) {
            Ok(outcome) => return Ok(outcome),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => return Err(lost()),
        }
    }
}

fn hand_out(plan: &Plan, sender: &SyncSender<Chunk>) {
    let mut variants = plan.variants();
    loop {
        let chunk: Chunk = variants.by_ref().take(CHUNK).map(|one| one.map(plain)).collect();
        let is_end = chunk.as_ref().map_or(true, Vec::is_empty);
        if sender.send(chunk).is_err() || is_end {
            return;
        }
    }
}

fn plain(variant: Variant) -> PlainVariant {
    let values = variant.settings.into_iter().map(|setting| (setting.name, setting.text));
    (variant.number, variant.id.to_string(), values.collect())
}
