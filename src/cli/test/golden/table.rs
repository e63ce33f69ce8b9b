//! Tables column by column.

use super::{
    difference::{Difference, MOST_TOLD},
    lines::RelativeTolerance,
};
use crate::ops;

/// The column of a table: its title, and its cells.
type GoldenColumn = (String, Vec<String>);

/// Where two tables differ; `most` rows are allowed.
pub(super) fn differences(
    expected: &[u8],
    found: &[u8],
    most: usize,
    tolerance: RelativeTolerance,
) -> Vec<Difference> {
    let expected = match columns(expected, most) {
        Ok(columns) => columns,
        Err(message) => return vec![Difference::of_whole(format!("is no table: {message}"))],
    };
    let found = match columns(found, most) {
        Ok(columns) => columns,
        Err(message) => {
            return vec![Difference::of_whole(format!("what is written is no table: {message}"))];
        }
    };
    let titles = |columns: &[GoldenColumn]| {
        columns.iter().map(|(title, _)| title.as_str()).collect::<Vec<_>>().join(", ")
    };
    if titles(&expected) != titles(&found) {
        return vec![Difference::of_texts("the columns", &titles(&expected), &titles(&found))];
    }
    let rows = |columns: &[GoldenColumn]| columns.first().map_or(0, |(_, cells)| cells.len());
    let mut told = Vec::new();
    if rows(&expected) != rows(&found) {
        let count = |columns| rows(columns).to_string();
        told.push(Difference::of_texts("the number of rows", &count(&expected), &count(&found)));
    }
    let apart = expected.iter().zip(&found).filter_map(|(a, b)| of_columns(a, b, tolerance));
    told.extend(apart);
    let n_more = told.len().saturating_sub(MOST_TOLD);
    if 0 < n_more {
        told.truncate(MOST_TOLD);
        told.push(Difference::of_whole(format!("and {n_more} more columns")));
    }
    told
}

/// What is different in a column: how many cells, and the first of them.
fn of_columns(
    (title, expected): &GoldenColumn,
    (_, found): &GoldenColumn,
    tolerance: RelativeTolerance,
) -> Option<Difference> {
    let mut apart =
        expected.iter().zip(found).enumerate().filter(|(_, (a, b))| !tolerance.joins_texts(a, b));
    let (row, (a, b)) = apart.next()?;
    let (n_apart, row) = (1 + apart.count(), row + 1);
    let place = match n_apart {
        1 => format!("column `{title}`, row {row}"),
        _ => format!("column `{title}`, {n_apart} rows, the first of them {row}"),
    };
    Some(Difference::of_texts(place, a, b))
}

/// The columns of a table as text.
fn columns(bytes: &[u8], most: usize) -> Result<Vec<GoldenColumn>, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "it is not text in UTF-8".to_owned())?;
    let (header, rows) = ops::csv_rows(text, b',', most)?;
    let mut columns: Vec<GoldenColumn> =
        header.cells.into_iter().map(|title| (title.text.into_owned(), Vec::new())).collect();
    for row in rows {
        for ((_, cells), cell) in columns.iter_mut().zip(row.cells) {
            cells.push(cell.text.into_owned());
        }
    }
    Ok(columns)
}
