//! A table as lines of text: what `print` shows of it.

use super::{Dimension, Number, NumberFormat, Value, shortest, unit::dim_of};
use crate::{
    diag::shown,
    kernel::{Column, NamedColumn, Table},
};

/// Rows that are shown; of more the first, and how many there are.
pub const MOST_ROWS: usize = 1000;

/// The cells of a table under the names of its columns, a line each: numbers to the right, texts to the
/// left, units in the names as CSV has them.
#[must_use]
pub fn table_text(table: &Table) -> String {
    let n_rows = table.n_rows().min(MOST_ROWS);
    let columns: Vec<Vec<String>> =
        table.columns().iter().map(|column| table_cells(column, n_rows, None)).collect();
    let widths: Vec<usize> = columns
        .iter()
        .map(|cells| cells.iter().map(|cell| cell.chars().count()).max().unwrap_or(0))
        .collect();
    let is_number: Vec<bool> =
        table.columns().iter().map(|column| matches!(column.column, Column::Numbers(_))).collect();
    let mut text = String::new();
    for row in 0..=n_rows {
        let mut line = String::new();
        for (k, column) in columns.iter().enumerate() {
            let cell = &column[row];
            let spaces = " ".repeat(widths[k] - cell.chars().count());
            let [before, behind] = if is_number[k] { [&*spaces, ""] } else { ["", &*spaces] };
            line.push_str(&format!("  {before}{cell}{behind}"));
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    if n_rows < table.n_rows() {
        text.push_str(&format!("  … and {} rows more\n", table.n_rows() - n_rows));
    }
    text
}

/// The name of a column and its first cells; numbers with so many digits behind the point, or else with
/// as many as they have, as those of a column without a unit that are all whole, which count something.
#[must_use]
pub fn table_cells(column: &NamedColumn, n_rows: usize, decimals: Option<usize>) -> Vec<String> {
    let format = decimals.and_then(|_| NumberFormat::new(decimals, None, "").ok());
    let rounded = |number: Number| format.as_ref()?.text(&Value::Number(number)).ok();
    let is_angle = dim_of(column) == Dimension::ANGLE;
    let name = match &column.unit {
        Some(unit) if !is_angle => format!("{} [{unit}]", shown(&column.name)),
        _ => shown(&column.name).into_owned(),
    };
    let mut cells = vec![name];
    match &column.column {
        Column::Numbers(values) => {
            let is_count = column.unit.is_none() && values.iter().all(|value| value.fract() == 0.0);
            let rounded = |number| if is_count { None } else { rounded(number) };
            let cell = |&value: &f64| match value.is_finite() {
                false => String::new(),
                true if is_angle => {
                    let angle = Number::angle(value);
                    rounded(angle).unwrap_or_else(|| angle.to_string())
                }
                true => rounded(Number::bare(value)).unwrap_or_else(|| shortest(value)),
            };
            cells.extend(values[..n_rows].iter().map(cell));
        }
        Column::Texts(texts) => {
            // A line break would make two rows of one.
            let cell = |text: &String| shown(text).replace('\n', "\\n");
            cells.extend(texts[..n_rows].iter().map(cell));
        }
    }
    cells
}
