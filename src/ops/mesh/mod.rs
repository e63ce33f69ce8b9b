//! Meshes, tables, and the files that bring data in.

mod area;
mod border;
mod bpt;
mod centroid;
mod check_mesh;
mod csv;
mod dat;
mod grid_mesh;
mod load;
mod obj;
mod planar_mesh;
mod table_columns;
mod table_rows;
mod tessellate;
mod volume;

use crate::value::Op;

pub(crate) use csv::rows as csv_rows;

pub(super) static OPS: &[&Op] = &[
    &grid_mesh::OP,
    &tessellate::OP,
    &planar_mesh::OP,
    &check_mesh::OP,
    &area::OP,
    &volume::OP,
    &centroid::OP,
    &border::OP,
    &table_columns::OP,
    &table_rows::OP,
    &load::OP,
];

/// A file as text; a byte-order mark is allowed.
fn text(bytes: &[u8]) -> Result<&str, String> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(err) => {
            let before = &bytes[..err.valid_up_to()];
            let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
            Err(format!("line {line}: the file is not text in UTF-8"))
        }
    }
}
