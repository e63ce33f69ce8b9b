//! Meshes, tables, and the files that bring data in.

mod area;
mod border;
mod bpt;
mod centroid;
mod check_mesh;
mod csv;
mod csv_rows;
mod dat;
mod difference;
mod grid_mesh;
mod intersection;
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
mod union;
mod volume;
mod written_unit;

use std::sync::Arc;

use super::combined::ListedMembers;
use crate::{
    diag::Span,
    kernel::Mesh,
    value::{FromValue, IntoValue, List, Mismatch, Op, Type, Value},
};

pub use csv_rows::{CsvCell, CsvRow, csv_rows};
pub use load::loaded_endings;

pub(super) static OPS: &[&Op] = &[
    &of_faces::OP,
    &grid_mesh::OP,
    &tessellate::OP,
    &planar_mesh::OP,
    &union::OP,
    &intersection::OP,
    &difference::OP,
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

/// A closed mesh, or what is left where there is nothing.
struct ClosedMesh(Option<Arc<Mesh>>);

const CLOSED_MESH: Type = Type::OneOf(&[Type::Mesh, Type::None]);

impl FromValue for ClosedMesh {
    const TYPE: Type = CLOSED_MESH;

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Mesh(mesh) => Ok(Self(Some(mesh.clone()))),
            Value::None => Ok(Self(None)),
            _ => Err(Mismatch::kind(Type::Mesh, value)),
        }
    }
}

impl IntoValue for ClosedMesh {
    const RETURNS: Type = CLOSED_MESH;

    fn into_value(self) -> Value {
        self.0.map_or(Value::None, Value::Mesh)
    }
}

impl From<Option<Mesh>> for ClosedMesh {
    fn from(mesh: Option<Mesh>) -> Self {
        Self(mesh.map(Arc::new))
    }
}

/// Closed meshes, given as a list or as the arguments themselves; lists among them count as their
/// members.
struct ClosedMeshes {
    all: Vec<ClosedMesh>,
    listed: ListedMembers,
}

impl FromValue for ClosedMeshes {
    const TYPE: Type =
        Type::List(&Type::OneOf(&[Type::Mesh, Type::None, Type::List(&CLOSED_MESH, 0)]), 1);
    const SPREADS: bool = true;

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        let mut found = Vec::new();
        let Value::List(items) = value else { return Err(Mismatch::kind(Self::TYPE, value)) };
        match gather(items, &mut found) {
            _ if items.is_empty() => Err(Mismatch::kind(Self::TYPE, value)),
            None => Ok(Self { all: found, listed: ListedMembers::of(items) }),
            Some(other) => Err(Mismatch::kind(Self::TYPE, value).hint(match other {
                "surface" => "`tessellate(s, tolerance = d)` makes a mesh of a surface, or of a list of surfaces that close",
                _ => "meshes are combined with meshes",
            })),
        }
    }
}

/// Adds the meshes of a list; the kind of what else is in it.
fn gather(items: &List, found: &mut Vec<ClosedMesh>) -> Option<&'static str> {
    items.iter().find_map(|item| match item {
        Value::List(items) => gather(items, found),
        item => match ClosedMesh::from_value(item, Span::default()) {
            Ok(mesh) => {
                found.push(mesh);
                None
            }
            Err(_) => Some(item.kind()),
        },
    })
}

impl ClosedMeshes {
    /// Those that there are.
    fn there(&self) -> Vec<&Mesh> {
        self.all.iter().filter_map(|mesh| mesh.0.as_deref()).collect()
    }
}
