//! Batches of studies: variants evaluated, rows written and read.

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
    disk::ScriptFiles,
    eval::Setting,
    limits::work::StopToken,
    session,
    study::{
        Evaluation, ResultColumns, ResultFormat, Row, RowMaker, Variant, in_order, read_results,
        write_results,
    },
    value::Files,
};

use crate::{
    errors::os_error, held, interrupt::interruptible, plan::PlainVariant, session::limits,
};

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

/// Variants as they come from Python.
type Variants = Vec<PlainVariant>;

fn settings(given: &[(String, String)]) -> Vec<Setting> {
    let setting = |(name, text): &(String, String)| Setting {
        name: name.clone(),
        text: text.clone(),
        called: format!("{name}={text}"),
    };
    given.iter().map(setting).collect()
}

/// Refuses wanted results that the script in a folder does not define.
#[pyfunction]
pub(crate) fn check_wants(
    py: Python<'_>,
    name: &str,
    text: &[u8],
    folder: PathBuf,
    want: Vec<String>,
) -> PyResult<()> {
    if want.is_empty() {
        return Ok(());
    }
    let files = ScriptFiles::new(&folder);
    let checked = py.detach(|| {
        let session = session::Session::default();
        let graph = session.graph(name, text, &files).map_err(|report| {
            let first = report.diagnostics.first().map(|found| found.message.clone());
            format!("{name}: {}", first.unwrap_or_default())
        })?;
        let defined: Vec<&str> = graph.nodes.iter().map(|node| node.name.as_str()).collect();
        virote::study::check_wants(&want, &defined)
    });
    checked.map_err(PyValueError::new_err)
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
    let time_limit = time_limit.map(Duration::try_from_secs_f64).transpose();
    let time_limit = time_limit.map_err(|err| PyValueError::new_err(err.to_string()))?;
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
            time_limit,
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

/// Writes rows, each a JSON object, into a file whose ending chooses the format. They are asked for twice,
/// and not held.
#[pyfunction]
pub(crate) fn write_rows(path: PathBuf, rows: &Bound<'_, PyAny>) -> PyResult<()> {
    let format = ResultFormat::of(&path).map_err(PyValueError::new_err)?;
    let mut columns = ResultColumns::default();
    for text in rows.try_iter()? {
        columns.add(&row(&text?)?);
    }
    // What Python raises goes past the writer.
    let raised = Cell::new(None);
    let again = rows.try_iter()?.map(|text| {
        text.and_then(|text| row(&text)).map_err(|err| {
            let told = err.to_string();
            raised.set(Some(err));
            told
        })
    });
    let again = Cell::new(Some(again));
    let write = |out: &mut dyn std::io::Write| match again.take() {
        Some(rows) => write_results(format, &columns, rows, out),
        None => Ok(()),
    };
    virote::disk::replace(&path, None, write).map_err(|err| {
        raised
            .take()
            .unwrap_or_else(|| os_error(&err, &format!("cannot write `{}`", path.display())))
    })
}

fn row(text: &Bound<'_, PyAny>) -> PyResult<Row> {
    let text: &str = text.extract()?;
    match serde_json::from_str(text) {
        Ok(Json::Object(row)) => Ok(row),
        _ => Err(PyValueError::new_err(format!("`{text}` is no row"))),
    }
}

/// The rows of a Parquet file, each a JSON object.
#[pyfunction]
pub(crate) fn read_rows(path: PathBuf) -> PyResult<Vec<String>> {
    let rows = read_results(&path).map_err(PyOSError::new_err)?;
    Ok(rows.into_iter().map(|row| json!(row).to_string()).collect())
}
