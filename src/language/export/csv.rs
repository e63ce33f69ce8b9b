//! CSV: one table, its columns with their units in the header (RFC 4180).

use std::io::Write;

use super::{ExportError, Format, Job, Subject, Summary, text::TextBuffer};
use crate::kernel::Column;

pub(super) static FORMAT: Format = Format {
    ending: "csv",
    aliases: &[],
    title: "CSV: one table, units in square brackets after the names",
    options: &[],
    takes: |subject| matches!(subject, Subject::Table(_)),
    takes_data: false,
    is_of_meshes: false,
    wants: "one table",
    write,
};

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let (mut text, mut summary) = (TextBuffer::default(), Summary::default());
    for item in &job.items {
        let Subject::Table(table) = &item.subject else { continue };
        for (i, column) in table.columns().iter().enumerate() {
            let title = match &column.unit {
                Some(unit) => format!("{} [{unit}]", column.name),
                None => column.name.clone(),
            };
            text.push(if i == 0 { "" } else { "," }).push(&text_cell(&title));
        }
        text.push("\n");
        for row in 0..table.n_rows() {
            for (i, column) in table.columns().iter().enumerate() {
                text.push(if i == 0 { "" } else { "," });
                match &column.column {
                    // A line with nothing on it would be no row.
                    Column::Numbers(values) if !values[row].is_finite() => {
                        text.push(if table.columns().len() == 1 { "\"\"" } else { "" })
                    }
                    Column::Numbers(values) => text.number(values[row]),
                    Column::Texts(values) => text.push(&text_cell(&values[row])),
                };
            }
            text.push("\n");
            text.flush_if_large(out)?;
        }
        summary.rows += table.n_rows();
    }
    text.flush(out)?;
    Ok(summary)
}

/// The cell of a text, in quotation marks also where it would be taken for nothing or for a number.
pub fn text_cell(text: &str) -> String {
    if text.is_empty() || text.parse::<f64>().is_ok() { format!("\"{text}\"") } else { cell(text) }
}

/// A cell, in quotation marks where it must be.
fn cell(text: &str) -> String {
    if text.contains(['"', ',', ';', '\t', '\n', '\r']) || text.trim() != text {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
