//! Reader of CSV: a table, units in brackets after the names of its columns.
//!
//! Cells in quotation marks may hold anything (RFC 4180). A semicolon or a tabulator separates
//! where it, and no comma, stands in the header.

use std::collections::HashSet;

use super::csv_rows::{CsvCell, CsvRow, csv_rows, line_at};
use crate::{
    kernel::{NamedColumn, Table},
    limits::work,
    value::{Ctx, ENDED, IntoValue, Value, in_document_unit, in_unit_of},
};

/// The table of a file.
pub(super) fn read(text: &str, ctx: &Ctx<'_>) -> Result<Value, String> {
    let header = text.trim_start_matches(['\n', '\r']).split(['\n', '\r']).next();
    let outside = header.map_or(Vec::new(), outside_marks);
    let is_in_header = |separator: &u8| outside.contains(separator);
    let separator = [b',', b';', b'\t'].into_iter().find(is_in_header).unwrap_or(b',');
    let (header, rows) = csv_rows(text, separator, ctx.limits.list_length)?;
    let line = line_at(text, header.start);
    if header.cells.iter().all(|name| !name.is_quoted && number(&name.text).is_some()) {
        return Err(format!("line {line} holds numbers where the names of the columns stand"));
    }
    let mut known = HashSet::new();
    let mut columns = Vec::with_capacity(header.cells.len());
    for (idx, title) in header.cells.iter().enumerate() {
        let (name, unit) = name_and_unit(&title.text, ctx.unit);
        if name.is_empty() {
            return Err(format!("line {line}: column {} has no name", idx + 1));
        }
        if !known.insert(name) {
            return Err(format!("line {line}: two columns are called `{name}`"));
        }
        let column = column(text, name, &rows, idx)?;
        columns.push(match unit {
            Some(unit) => in_document_unit(column.with_unit(unit), ctx.unit)
                .map_err(|message| format!("line {line}: {message}"))?,
            None => column,
        });
    }
    Table::new(columns).map(IntoValue::into_value).map_err(|err| err.to_string())
}

/// Numbers if the first cell that is not empty is one, else texts. Where all are empty, quotation
/// marks tell texts.
fn column(text: &str, name: &str, rows: &[CsvRow<'_>], idx: usize) -> Result<NamedColumn, String> {
    let cells = rows.iter().map(|row| &row.cells[idx]);
    let holds_numbers = match cells.clone().find(|cell| !cell.text.is_empty()) {
        Some(first) => !first.is_quoted && first.text.parse::<f64>().is_ok(),
        None => cells.clone().all(|cell| !cell.is_quoted),
    };
    let with_comma = |(_, cell): &(&CsvRow<'_>, &CsvCell<'_>)| {
        !cell.is_quoted
            && cell.text.contains(',')
            && number(&cell.text.replacen(',', ".", 1)).is_some()
    };
    if let Some((row, cell)) = rows.iter().zip(cells.clone()).find(with_comma) {
        let (line, found) = (line_at(text, row.start), &cell.text);
        let meant = found.replacen(',', ".", 1);
        return Err(format!(
            "line {line}: `{name}` holds `{found}`, a number with a decimal comma; write `{meant}`, or a text in quotation marks"
        ));
    }
    if !holds_numbers {
        let texts = work::collect(cells.map(|cell| cell.text.to_string())).ok_or(ENDED)?;
        return Ok(NamedColumn::texts(name, texts));
    }
    let mut numbers = Vec::new();
    for (row, cell) in rows.iter().zip(cells) {
        let number = match number(&cell.text) {
            Some(number) if !cell.is_quoted => number,
            _ if cell.text.is_empty() => f64::NAN,
            _ => {
                let line = line_at(text, row.start);
                let misfit = misfit(cell, first_cell(rows, idx));
                return Err(format!("line {line}: `{name}` {misfit}"));
            }
        };
        if !work::push(&mut numbers, number) {
            return Err(ENDED.to_owned());
        }
    }
    Ok(NamedColumn::numbers(name, numbers))
}

/// What is wrong with a cell in a column of numbers that begins with another.
fn misfit(cell: &CsvCell<'_>, first: &str) -> String {
    let found = &cell.text;
    match found.parse::<f64>() {
        Ok(number) if !number.is_finite() && found.contains(|c: char| c.is_ascii_digit()) => {
            format!("holds `{found}`, which is beyond the largest number, 1.8e308")
        }
        Ok(number) if !number.is_finite() => {
            format!("holds `{found}`, which is no number; a cell without one stays empty")
        }
        _ => format!(
            "is a column of numbers, since its first cell is `{first}`, but here it holds `{found}`; cells of a column of texts stand in quotation marks"
        ),
    }
}

/// What a column begins with.
fn first_cell<'r>(rows: &'r [CsvRow<'_>], idx: usize) -> &'r str {
    let mut cells = rows.iter().map(|row| &*row.cells[idx].text);
    cells.find(|cell| !cell.is_empty()).unwrap_or_default()
}

/// A number as it is written in data: no infinity, no NaN.
fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// `x [mm]` is `x` in `mm`, and so is `x (mm)`; `x [-]` has no unit. What stands in round brackets and is no unit belongs to
/// the name.
fn name_and_unit<'t>(title: &'t str, length: &str) -> (&'t str, Option<&'t str>) {
    let title = title.trim();
    let in_brackets = |[open, close]: [char; 2]| {
        let (name, unit) = title.strip_suffix(close)?.rsplit_once(open)?;
        Some((name.trim(), unit.trim()))
    };
    let is_unit = |unit: &str| in_unit_of(1.0, unit, length).is_some();
    match (in_brackets(['[', ']']), in_brackets(['(', ')'])) {
        (Some((name, "" | "-" | "1")), _) => (name, None),
        (Some((name, unit)), _) => (name, Some(unit)),
        (_, Some((name, unit))) if is_unit(unit) => (name, Some(unit)),
        _ => (title, None),
    }
}

/// The separators of a header; those in cells that begin with a quotation mark separate nothing.
fn outside_marks(header: &str) -> Vec<u8> {
    let is_separator = |byte: &u8| matches!(byte, b',' | b';' | b'\t');
    let (mut found, mut is_quoted, mut is_start) = (Vec::new(), false, true);
    for byte in header.bytes() {
        match byte {
            b'"' if is_quoted => is_quoted = false,
            b'"' if is_start => is_quoted = true,
            _ if !is_quoted && is_separator(&byte) => found.push(byte),
            _ => {}
        }
        is_start = !is_quoted && is_separator(&byte);
    }
    match is_quoted {
        // A mark that is never closed is none.
        true => header.bytes().filter(is_separator).collect(),
        false => found,
    }
}
