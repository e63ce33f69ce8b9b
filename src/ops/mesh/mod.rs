//! Meshes, tables, and the files that bring data in.

mod area;
mod border;
mod bpt;
mod centroid;
mod check_mesh;
mod csv;
mod dat;
mod grid_mesh;
mod lines;
mod load;
mod obj;
mod obj_lines;
mod of_faces;
mod planar_mesh;
mod script;
mod table_columns;
mod table_rows;
mod tessellate;
mod volume;

use crate::value::Op;

#[cfg(feature = "cli")]
pub(crate) use csv::rows as csv_rows;

pub(super) static OPS: &[&Op] = &[
    &of_faces::OP,
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
    &script::OP,
];
