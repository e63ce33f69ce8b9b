//! Meshes, tables, and the files that bring data in.

mod bpt;
mod grid_mesh;
mod load;
mod obj;
mod table_columns;
mod table_rows;
mod tessellate;

use crate::value::Op;

pub(super) static OPS: &[&Op] =
    &[&grid_mesh::OP, &tessellate::OP, &table_columns::OP, &table_rows::OP, &load::OP];
