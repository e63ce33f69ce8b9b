//! Batches of studies: plans read, variants evaluated, rows written and read.

use std::{
    cell::Cell,
    collections::BTreeMap,
    path::PathBuf,
    sync::{Mutex, PoisonError},
    time::Duration,
};

use pyo3::{
    exceptions::{PyOSError, PyValueError},
    prelude::*,
    types::PyBytes,
};
use serde_json::{Value as Json, json};
use virote::{
    eval::Setting,
    limits::work::StopToken,
    session,
    study::{
        Evaluation, Plan, ResultColumns, ResultFormat, Row, RowMaker, Variant, VariedParameter,
        in_order, read_results, write_results,
    },
    value::Files,
};

use crate::{held, interrupt::interruptible, session::limits};

/// Files that came with a batch; none where it is known that there is none.
#[derive(Debug)]
struct ShippedFiles {
    files: BTreeMap<String, Option<Vec<u8>>>,
    /// What was asked for and did not come.
    missing: Mutex<Vec<String>>,
}

impl Files for ShippedFiles {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        match self.files.get(path) {
            Some(Some(bytes)) => Ok(bytes[..bytes.len().min(most.saturating_add(1))].to_vec()),
            known => {
                if known.is_none() {
                    let mut missing = self.missing.lock().unwrap_or_else(PoisonError::into_inner);
                    if !missing.iter().any(|other| other == path) {
                        missing.push(path.to_owned());
                    }
                }
                Err(format!("cannot read `{path}`: no such file or directory"))
            }
        }
    }
}

/// Variants as they come from Python: number, id as JSON, and values for parameters.
type Variants = Vec<(u64, String, Vec<(String, String)>)>;

fn settings(given: &[(String, String)]) -> Vec<Setting> {
    let setting = |(name, text): &(String, String)| Setting {
        name: name.clone(),
        text: text.clone(),
        called: format!("{name}={text}"),
    };
    given.iter().map(setting).collect()
}

/// Evaluates variants one after the other: their rows as JSON, and files that were missing.
#[pyfunction]
#[pyo3(signature = (name, text, files, variants, settings, want, time_limit, ceilings))]
#[expect(clippy::too_many_arguments, reason = "Python passes each by itself")]
pub(crate) fn study_batch(
    py: Python<'_>,
    name: String,
    text: Vec<u8>,
    files: BTreeMap<String, Option<Bound<'_, PyBytes>>>,
    variants: Variants,
    settings: Vec<(String, String)>,
    want: Vec<String>,
    time_limit: Option<f64>,
    ceilings: Vec<(String, u64)>,
) -> PyResult<(Vec<String>, Vec<String>)> {
    let limits = limits(&ceilings)?;
    let files = files.into_iter().map(|(path, bytes)| (path, bytes.map(|b| b.as_bytes().to_vec())));
    let shipped = ShippedFiles { files: files.collect(), missing: Mutex::default() };
    let given = self::settings(&settings);
    let stop = StopToken::default();
    let rows = interruptible(py, &stop, || {
        let make = |stop: StopToken| session::Session::new(limits).measured(held).stopped_by(stop);
        let schema = make(StopToken::default()).parameters(&name, &text, &shipped);
        let schema = schema.map_err(|report| {
            let first = report.diagnostics.first().map(|found| found.message.clone());
            first.unwrap_or_else(|| "the script has no parameters".to_owned())
        })?;
        let maker = RowMaker::new(schema, want);
        let evaluation = Evaluation {
            name: &name,
            bytes: &text,
            files: &shipped,
            settings: &given,
            session: &make,
            maker: &maker,
            n_workers: 1,
            time_limit: time_limit.map(Duration::from_secs_f64),
            pictures: None,
            stop: &stop,
        };
        let variants = variants.iter().map(|(number, id, values)| {
            let id: Json = serde_json::from_str(id).map_err(|err| err.to_string())?;
            Ok(Variant { number: *number, id, settings: self::settings(values) })
        });
        let mut rows = Vec::new();
        in_order(&evaluation, variants, |row| {
            rows.push(Json::Object(row).to_string());
            Ok(())
        })?;
        Ok::<_, String>(rows)
    })?;
    let missing = shipped.missing.into_inner().unwrap_or_else(PoisonError::into_inner);
    match rows {
        Ok(rows) => Ok((rows, missing)),
        // The schema itself may have asked for a file.
        Err(_) if !missing.is_empty() => Ok((Vec::new(), missing)),
        Err(message) => Err(PyValueError::new_err(message)),
    }
}

/// The variants of a plan in a file, or of a grid `NAME=VALUES`, checked against the script: each with
/// its number, its id as JSON, and the values of parameters; and a sum that changes with them.
#[pyfunction]
pub(crate) fn study_plan(
    name: &str,
    text: &[u8],
    folder: PathBuf,
    plan: Option<PathBuf>,
    vary: Vec<String>,
) -> PyResult<(Variants, String)> {
    let wrong = PyValueError::new_err::<String>;
    let session = session::Session::default();
    let files = virote::disk::ScriptFiles::new(&folder);
    let schema = session.parameters(name, text, &files).map_err(|report| {
        let first = report.diagnostics.first().map(|found| found.message.clone());
        wrong(format!("{name}: {}", first.unwrap_or_default()))
    })?;
    let mut plan = match plan {
        Some(path) => Plan::file(&path).map_err(wrong)?,
        None => {
            let varied = vary.iter().map(|text| VariedParameter::read(text));
            Plan::grid(&varied.collect::<Result<Vec<_>, _>>().map_err(wrong)?).map_err(wrong)?
        }
    };
    let (_, sum) = plan.check(&schema).map_err(wrong)?;
    let variants = plan.variants().map(|variant| {
        let variant = variant.map_err(wrong)?;
        let values = variant.settings.into_iter().map(|setting| (setting.name, setting.text));
        Ok((variant.number, variant.id.to_string(), values.collect()))
    });
    Ok((variants.collect::<PyResult<_>>()?, sum))
}

/// Writes rows, each a JSON object, into a file whose ending chooses the format.
#[pyfunction]
pub(crate) fn write_rows(path: PathBuf, rows: Vec<String>) -> PyResult<()> {
    let format = ResultFormat::of(&path).map_err(PyValueError::new_err)?;
    let row = |text: &String| -> Result<Row, String> {
        match serde_json::from_str(text) {
            Ok(Json::Object(row)) => Ok(row),
            _ => Err(format!("`{text}` is no row")),
        }
    };
    let mut columns = ResultColumns::default();
    for text in &rows {
        columns.add(&row(text).map_err(PyValueError::new_err)?);
    }
    let all = Cell::new(Some(rows.iter().map(row)));
    let write = |out: &mut dyn std::io::Write| match all.take() {
        Some(rows) => write_results(format, &columns, rows, out),
        None => Ok(()),
    };
    virote::disk::replace(&path, None, write).map_err(|err| {
        let why = virote::export::io_reason(&err);
        PyOSError::new_err(format!("cannot write `{}`: {why}", path.display()))
    })
}

/// The rows of a Parquet file, each a JSON object.
#[pyfunction]
pub(crate) fn read_rows(path: PathBuf) -> PyResult<Vec<String>> {
    let rows = read_results(&path).map_err(PyOSError::new_err)?;
    Ok(rows.into_iter().map(|row| json!(row).to_string()).collect())
}
