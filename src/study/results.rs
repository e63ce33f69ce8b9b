//! The rows of a study as a file: CSV, JSON lines or Parquet.

use std::{
    io::{self, Write},
    path::Path,
};

use serde_json::Value as Json;

use super::{
    columns::{CellKind, ResultColumns, text_of},
    row::Row,
    typed_columns,
};
use crate::{export::csv_cell, value::shortest};

/// How results are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFormat {
    /// A line for each row, units in square brackets in the header.
    Csv,
    /// A JSON object on a line for each row, all with the same members; what is not there is null.
    JsonLines,
    /// Parquet, for libraries of tables.
    Parquet,
}

impl ResultFormat {
    /// The format that a file's ending chooses.
    ///
    /// # Errors
    /// The endings that there are.
    pub fn of(path: &Path) -> Result<Self, String> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("jsonl") => Ok(Self::JsonLines),
            Some("parquet") => Ok(Self::Parquet),
            Some(ending) => Err(format!(
                "results end in `.csv`, `.jsonl` or `.parquet`, and `{}` in `.{ending}`",
                path.display()
            )),
            None => Err(format!(
                "results end in `.csv`, `.jsonl` or `.parquet`, and `{}` in none of them",
                path.display()
            )),
        }
    }
}

/// Writes rows, of which these are the columns.
///
/// # Errors
/// Why they cannot be written, or the first row that cannot be read.
pub fn write_results(
    format: ResultFormat,
    columns: &ResultColumns,
    rows: impl Iterator<Item = Result<Row, String>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut rows = rows.map(|row| row.map_err(io::Error::other));
    match format {
        ResultFormat::Csv => csv(columns, &mut rows, out),
        ResultFormat::JsonLines => rows.try_for_each(|row| {
            let mut row = row?;
            let cell = |(title, _): (&str, CellKind)| {
                (title.to_owned(), row.remove(title).unwrap_or(Json::Null))
            };
            writeln!(out, "{}", Json::Object(columns.iter().map(cell).collect()))
        }),
        ResultFormat::Parquet => typed_columns::write(columns, &mut rows, out),
    }
}

fn csv(
    columns: &ResultColumns,
    rows: &mut dyn Iterator<Item = io::Result<Row>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let titles: Vec<&str> = columns.iter().map(|(title, _)| title).collect();
    let header: Vec<String> = titles.iter().map(|title| csv_cell(title)).collect();
    writeln!(out, "{}", header.join(","))?;
    for row in rows {
        let row = row?;
        let cells: Vec<String> = titles.iter().map(|title| csv_text(row.get(*title))).collect();
        writeln!(out, "{}", cells.join(","))?;
    }
    Ok(())
}

fn csv_text(cell: Option<&Json>) -> String {
    match cell {
        Some(Json::Number(number)) => match number.as_i64() {
            Some(whole) => whole.to_string(),
            None => number.as_f64().map(shortest).unwrap_or_default(),
        },
        Some(cell) => text_of(cell).map(|text| csv_cell(&text)).unwrap_or_default(),
        None => String::new(),
    }
}
