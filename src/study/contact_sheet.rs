//! Contact sheets of a study: all its pictures, small, each with the name of its variant.

use std::{fs, io::Write, path::Path};

use serde_json::Value as Json;

use super::row::{ID, Row};
use crate::{
    disk::replace,
    export::{Thumbnail, io_reason, write_sheet},
};

/// Pictures in a row of a sheet, and rows.
const SIDE: usize = 10;

/// Makes the sheets of the pictures in a folder, a hundred pictures on each; the names of the sheets.
///
/// # Errors
/// What cannot be read or written.
pub fn contact_sheets(
    folder: &Path,
    rows: impl Iterator<Item = Result<Row, String>>,
) -> Result<Vec<String>, String> {
    let (mut page, mut sheets) = (Vec::new(), Vec::new());
    for row in rows {
        let row = row?;
        page.push(thumbnail(folder, &row)?);
        if page.len() == SIDE * SIDE {
            sheets.push(write(folder, sheets.len() + 1, &page)?);
            page.clear();
        }
    }
    if !page.is_empty() {
        sheets.push(write(folder, sheets.len() + 1, &page)?);
    }
    Ok(sheets)
}

fn thumbnail(folder: &Path, row: &Row) -> Result<Thumbnail, String> {
    let label = match row.get(ID) {
        Some(Json::String(text)) => text.clone(),
        Some(other) => other.to_string(),
        None => String::new(),
    };
    let Some(Json::String(name)) = row.get(super::row::PICTURE) else {
        return Ok(Thumbnail::missing(format!("{label}: none")));
    };
    let path = folder.join(name);
    let small = fs::read(&path).and_then(|bytes| Thumbnail::of(label, &bytes));
    small.map_err(|err| format!("cannot read `{}`: {}", path.display(), io_reason(&err)))
}

fn write(folder: &Path, number: usize, page: &[Thumbnail]) -> Result<String, String> {
    let name = format!("contact-{number}.png");
    let path = folder.join(&name);
    // Few pictures stand in a square.
    let n_columns = (1..SIDE).find(|n| page.len() <= n * n).unwrap_or(SIDE);
    let sheet = |out: &mut dyn Write| write_sheet(page, n_columns, out);
    replace(&path, None, sheet)
        .map_err(|err| format!("cannot write `{}`: {}", path.display(), io_reason(&err)))?;
    Ok(name)
}
