//! Reader of CSV: a table, units in square brackets after the names of its columns.
//!
//! Cells in quotation marks may hold anything (RFC 4180). A semicolon or a tabulator separates
//! where it, and no comma, stands in the header.

use std::collections::HashSet;

use crate::{
    kernel::{NamedColumn, Table},
    limits::work,
    value::{Ctx, ENDED, IntoValue, Value, in_document_unit},
};

/// A cell: its text, and whether it stood in quotation marks.
pub(crate) type Cell = (String, bool);

/// The table of a file.
pub(super) fn read(text: &str, ctx: &Ctx<'_>) -> Result<Value, String> {
    let header_end = text.find(['\n', '\r']).unwrap_or(text.len());
    let separators = [',', ';', '\t'];
    let is_in_header = |separator: &char| text[..header_end].contains(*separator);
    let separator = separators.into_iter().find(is_in_header).unwrap_or(',');
    let rows = rows(text, separator, ctx.limits.list_length)?;
    let mut rows = rows.into_iter();
    let Some((line, names)) = rows.next() else { return Err("the file is empty".to_owned()) };
    if names.iter().all(|(name, is_quoted)| !is_quoted && number(name).is_some()) {
        return Err(format!("line {line} holds numbers where the names of the columns stand"));
    }
    let rows: Vec<(usize, Vec<Cell>)> = rows.collect();
    if let Some((line, row)) = rows.iter().find(|(_, row)| row.len() != names.len()) {
        let (got, wanted) = (row.len(), names.len());
        return Err(format!("line {line} has {got} cells, the header has {wanted}"));
    }
    let mut known = HashSet::new();
    let mut columns = Vec::with_capacity(names.len());
    for (idx, (title, _)) in names.iter().enumerate() {
        let (name, unit) = name_and_unit(title);
        if name.is_empty() {
            return Err(format!("line {line}: column {} has no name", idx + 1));
        }
        if !known.insert(name) {
            return Err(format!("line {line}: two columns are called `{name}`"));
        }
        let cells = rows.iter().map(|(line, row)| (*line, &row[idx]));
        let column = column(name, cells)?;
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
fn column<'c>(
    name: &str,
    cells: impl Iterator<Item = (usize, &'c Cell)> + Clone,
) -> Result<NamedColumn, String> {
    let first = cells.clone().find(|(_, (text, _))| !text.is_empty());
    let holds_numbers = match first {
        Some((_, (text, is_quoted))) => !is_quoted && text.parse::<f64>().is_ok(),
        None => cells.clone().all(|(_, (_, is_quoted))| !is_quoted),
    };
    if !holds_numbers {
        let texts = work::collect(cells.map(|(_, (text, _))| text.clone())).ok_or(ENDED)?;
        return Ok(NamedColumn::texts(name, texts));
    }
    let mut numbers = Vec::new();
    for (line, cell) in cells {
        let number = match number(&cell.0) {
            Some(number) if !cell.1 => number,
            _ if cell.0.is_empty() => f64::NAN,
            _ => return Err(format!("line {line}: `{name}` must be a number, found `{}`", cell.0)),
        };
        if !work::push(&mut numbers, number) {
            return Err(ENDED.to_owned());
        }
    }
    Ok(NamedColumn::numbers(name, numbers))
}

/// A number as it is written in data: no infinity, no NaN.
fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// `x [mm]` is `x` in `mm`.
fn name_and_unit(title: &str) -> (&str, Option<&str>) {
    let title = title.trim();
    match title.strip_suffix(']').and_then(|title| title.rsplit_once('[')) {
        Some((name, unit)) if !unit.trim().is_empty() => (name.trim(), Some(unit.trim())),
        _ => (title, None),
    }
}

/// The rows that are not empty, no more than `most` besides the header, with their first lines.
///
/// # Errors
/// What is wrong with a line.
pub(crate) fn rows(
    text: &str,
    separator: char,
    most: usize,
) -> Result<Vec<(usize, Vec<Cell>)>, String> {
    let mut rows = Vec::new();
    let (mut row, mut cell, mut is_quoted) = (Vec::new(), String::new(), false);
    let (mut line, mut first_line) = (1, 1);
    let mut characters = text.chars().peekable();
    let finish = |cell: &mut String, is_quoted: &mut bool, row: &mut Vec<Cell>| {
        let text = std::mem::take(cell);
        let text = if *is_quoted { text } else { text.trim().to_owned() };
        let is_counted = work::push(row, (text, std::mem::take(is_quoted)));
        is_counted.then_some(()).ok_or_else(|| ENDED.to_owned())
    };
    loop {
        match characters.next() {
            Some('"') if cell.trim().is_empty() && !is_quoted => {
                cell.clear();
                is_quoted = true;
                let opened = line;
                loop {
                    match characters.next() {
                        Some('"') if characters.next_if_eq(&'"').is_none() => break,
                        Some(character) => {
                            line += usize::from(character == '\n');
                            cell.push(character);
                        }
                        None => {
                            return Err(format!("line {opened}: the quotation mark is not closed"));
                        }
                    }
                }
            }
            Some(character) if character == separator => {
                finish(&mut cell, &mut is_quoted, &mut row)?;
            }
            Some('\r') if characters.peek() == Some(&'\n') => {}
            end @ (Some('\n' | '\r') | None) => {
                finish(&mut cell, &mut is_quoted, &mut row)?;
                let is_blank = row.len() == 1 && row[0].0.is_empty() && !row[0].1;
                if !is_blank && !work::push(&mut rows, (first_line, std::mem::take(&mut row))) {
                    return Err(ENDED.to_owned());
                }
                row.clear();
                line += 1;
                first_line = line;
                if rows.len() > most.saturating_add(1) {
                    return Err(format!(
                        "the table has more than the {most} rows that are allowed"
                    ));
                }
                if end.is_none() {
                    return Ok(rows);
                }
            }
            Some(character) if is_quoted && character.is_whitespace() => {}
            Some(character) if is_quoted => {
                return Err(format!("line {line}: `{character}` follows a quotation mark"));
            }
            Some(character) => cell.push(character),
        }
    }
}
