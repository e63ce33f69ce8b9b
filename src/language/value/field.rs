//! Fields of values: what may stand after a dot.

use std::sync::Arc;

use glam::DVec3;

use super::{Dimension, IntoValue, Number, Range, Real, Type, Value, unit::dim_of};
use crate::kernel::{
    Column, Curve, Face, GeomError, Grid, Interval, NurbsCurve, NurbsSurface, Region, Solid,
    Surface, Table, Tolerance,
};

const POINT: &[&str] = &["x", "y", "z"];
const RANGE: &[&str] = &["start", "end"];
const CURVE: &[&str] = &[
    "domain", "degree", "knots", "weights", "points", "start", "end", "closed", "rational",
    "segments",
];
const SURFACE: &[&str] = &[
    "domain_u", "domain_v", "degree_u", "degree_v", "knots_u", "knots_v", "weights", "points",
    "closed_u", "closed_v", "rational", "patches",
];
const MESH: &[&str] = &["vertices", "triangles", "faces", "normals", "uvs", "colors", "groups"];
const REGION: &[&str] = &["outer", "holes", "plane"];
const FACE: &[&str] = &["surface", "loops", "edges"];
const SOLID: &[&str] = &["faces", "shells", "edges", "vertices"];
const FRAME: &[&str] = &["origin", "x", "y", "z"];
const CURVE_FRAME: &[&str] = &["origin", "x", "y", "z", "tangent", "normal", "binormal"];

/// The names of all fields of `value`, in the order of the reference.
#[must_use]
pub fn field_names(value: &Value) -> Vec<&str> {
    match value {
        Value::Point(_) | Value::JetPoint(_) => POINT.to_vec(),
        Value::Range(_) | Value::JetRange(_) => RANGE.to_vec(),
        Value::Record(record) => record.iter().map(|(label, _)| label).collect(),
        Value::Curve(_) | Value::JetCurve(_) => CURVE.to_vec(),
        Value::Surface(_) | Value::JetSurface(_) => SURFACE.to_vec(),
        Value::Region(_) | Value::JetRegion(_) => REGION.to_vec(),
        Value::Face(_) => FACE.to_vec(),
        Value::Solid(_) | Value::JetSolid(_) => SOLID.to_vec(),
        Value::Mesh(_) => MESH.to_vec(),
        Value::Table(table) => table.columns().iter().map(|column| column.name.as_str()).collect(),
        Value::Frame(frame) if frame.is_of_curve() => CURVE_FRAME.to_vec(),
        Value::Frame(_) => FRAME.to_vec(),
        _ => Vec::new(),
    }
}

/// The names of all fields of values of a type, as far as the type tells.
#[must_use]
pub fn field_names_of(ty: Type) -> Vec<&'static str> {
    match ty {
        Type::Point => POINT.to_vec(),
        Type::Range => RANGE.to_vec(),
        Type::Curve => CURVE.to_vec(),
        Type::Surface => SURFACE.to_vec(),
        Type::Region => REGION.to_vec(),
        Type::Face => FACE.to_vec(),
        Type::Solid => SOLID.to_vec(),
        Type::Mesh => MESH.to_vec(),
        Type::Plane => FRAME.to_vec(),
        Type::OneOf(types) => {
            let mut found: Vec<&str> = types.iter().flat_map(|of| field_names_of(*of)).collect();
            let mut seen = std::collections::BTreeSet::new();
            found.retain(|name| seen.insert(*name));
            found
        }
        _ => Vec::new(),
    }
}

/// Field `name` of `value`; `None` where there is none. Whether a curve or surface counts as
/// closed depends on the document's tolerance.
///
/// # Errors
/// Where a parametric curve or surface fails, or has no such field because it is no NURBS.
pub fn field(value: &Value, name: &str, tolerance: Tolerance) -> Result<Option<Value>, GeomError> {
    match value {
        Value::Curve(curve) if CURVE.contains(&name) => curve_field(curve, name, tolerance),
        Value::Surface(surface) if SURFACE.contains(&name) => {
            surface_field(surface, name, tolerance)
        }
        Value::Region(region) => region_field(region, name),
        Value::Face(face) => face_field(face, name, tolerance),
        Value::Solid(solid) => solid_field(solid, name, tolerance),
        _ => Ok(plain_field(value, name)),
    }
}

fn plain_field(value: &Value, name: &str) -> Option<Value> {
    Some(match (value, name) {
        (Value::Point(point), "x") => Value::Number(Number::open(point.x)),
        (Value::Point(point), "y") => Value::Number(Number::open(point.y)),
        (Value::Point(point), "z") => Value::Number(Number::open(point.z)),
        (Value::JetPoint(jets), "x" | "y" | "z") => {
            let axis = POINT.iter().position(|axis| *axis == name)?;
            Number { value: Real::Jet(jets[axis].clone()), dim: Dimension::OPEN }.into_value()
        }
        (Value::Range(range), "start") => Value::Number(range.start),
        (Value::Range(range), "end") => Value::Number(range.end),
        (Value::JetRange(range), "start") => range.start.clone().into_value(),
        (Value::JetRange(range), "end") => range.end.clone().into_value(),
        (Value::Record(record), _) => record.get(name)?.clone(),
        (Value::Mesh(mesh), _) => return mesh_field(mesh, name),
        (Value::Table(table), _) => column(table, name)?,
        (Value::Frame(frame), "origin") => Value::Point(frame.origin()),
        (Value::Frame(frame), "x") => Value::Point(frame.x()),
        (Value::Frame(frame), "y") => Value::Point(frame.y()),
        (Value::Frame(frame), "z") => Value::Point(frame.z()),
        (Value::Frame(frame), "tangent") if frame.is_of_curve() => Value::Point(frame.x()),
        (Value::Frame(frame), "normal") if frame.is_of_curve() => Value::Point(frame.y()),
        (Value::Frame(frame), "binormal") if frame.is_of_curve() => Value::Point(frame.z()),
        _ => return None,
    })
}

fn curve_field(
    curve: &Curve,
    name: &str,
    tolerance: Tolerance,
) -> Result<Option<Value>, GeomError> {
    Ok(Some(match name {
        "domain" => domain(curve.domain()),
        "start" => Value::Point(curve.start()),
        "end" => Value::Point(curve.end()),
        "closed" => Value::Bool(curve.is_closed(tolerance.distance)),
        _ => return curve.nurbs().map(|curve| nurbs_curve_field(curve, name)),
    }))
}

fn nurbs_curve_field(curve: &NurbsCurve, name: &str) -> Option<Value> {
    Some(match name {
        "degree" => count(curve.degree()),
        "knots" => numbers(curve.knots().as_slice()),
        "weights" => numbers(&curve.weights()),
        "points" => points(&curve.points()),
        "rational" => Value::Bool(curve.is_rational()),
        "segments" => count(curve.n_segments()),
        _ => return None,
    })
}

fn surface_field(
    surface: &Surface,
    name: &str,
    tolerance: Tolerance,
) -> Result<Option<Value>, GeomError> {
    Ok(Some(match name {
        "domain_u" => domain(surface.domain_u()),
        "domain_v" => domain(surface.domain_v()),
        "closed_u" => Value::Bool(surface.is_closed_u(tolerance.distance)?),
        "closed_v" => Value::Bool(surface.is_closed_v(tolerance.distance)?),
        _ => return surface.nurbs().map(|surface| nurbs_surface_field(surface, name)),
    }))
}

fn nurbs_surface_field(surface: &NurbsSurface, name: &str) -> Option<Value> {
    Some(match name {
        "degree_u" => count(surface.degree_u()),
        "degree_v" => count(surface.degree_v()),
        "knots_u" => numbers(surface.knots_u().as_slice()),
        "knots_v" => numbers(surface.knots_v().as_slice()),
        "weights" => grid(&surface.weights(), |weight| Value::number(*weight)),
        "points" => grid(&surface.points(), |point| Value::Point(*point)),
        "rational" => Value::Bool(surface.is_rational()),
        "patches" => Value::list(surface.n_patches().map(count).to_vec()),
        _ => return None,
    })
}

fn region_field(region: &Region, name: &str) -> Result<Option<Value>, GeomError> {
    Ok(Some(match name {
        "outer" => Value::Curve(region.outer()?.into()),
        "holes" => {
            let holes = region.holes()?.into_iter();
            Value::list(holes.map(|hole| Value::Curve(hole.into())).collect())
        }
        "plane" => Value::Frame(Arc::new(region.frame())),
        _ => return Ok(None),
    }))
}

fn face_field(face: &Face, name: &str, tolerance: Tolerance) -> Result<Option<Value>, GeomError> {
    let curves = |curves: Vec<NurbsCurve>| {
        Value::list(curves.into_iter().map(|curve| Value::Curve(curve.into())).collect())
    };
    Ok(Some(match name {
        "surface" => Value::Surface(Surface::Nurbs(Arc::clone(face.surface()))),
        "loops" => curves(face.loops(tolerance)?),
        "edges" => curves(face.edges(tolerance)?),
        _ => return Ok(None),
    }))
}

fn solid_field(
    solid: &Solid,
    name: &str,
    tolerance: Tolerance,
) -> Result<Option<Value>, GeomError> {
    let faces = |faces: &[&Face]| {
        let face = |&face: &&Face| Value::Face(Arc::new(face.clone()));
        Value::list(faces.iter().map(face).collect())
    };
    Ok(Some(match name {
        "faces" => faces(&solid.faces().iter().collect::<Vec<_>>()),
        "shells" => Value::list(solid.shells().map(|shell| faces(&shell)).collect()),
        "edges" => {
            let edges = solid.edges(tolerance)?.into_iter();
            edges.map(|edge| solid.reported_edge(edge, tolerance)).collect::<Vec<_>>().into_value()
        }
        "vertices" => points(&solid.vertices(tolerance)?),
        _ => return Ok(None),
    }))
}

fn mesh_field(mesh: &crate::kernel::Mesh, name: &str) -> Option<Value> {
    Some(match name {
        "vertices" => points(mesh.vertices()),
        "normals" => points(mesh.normals()),
        "colors" => points(mesh.colors()),
        "groups" => Value::list(
            mesh.groups()
                .iter()
                .map(|group| {
                    let fields = [
                        (Arc::from("name"), Value::text(&group.name)),
                        (Arc::from("triangles"), count(group.n_triangles)),
                    ];
                    Value::Record(Arc::new(super::Record::new(fields)))
                })
                .collect(),
        ),
        "triangles" => Value::list(
            mesh.triangles()
                .iter()
                .map(|corners| Value::list(corners.iter().map(|&i| count(i as usize)).collect()))
                .collect(),
        ),
        "faces" => Value::list(
            mesh.faces()
                .map(|corners| Value::list(corners.iter().map(|&i| count(i as usize)).collect()))
                .collect(),
        ),
        "uvs" => Value::list(
            mesh.uvs().iter().map(|uv| Value::Point(DVec3::new(uv.x, uv.y, 0.0))).collect(),
        ),
        _ => return None,
    })
}

/// Column `name` of a table as a list.
pub(super) fn column(table: &Table, name: &str) -> Option<Value> {
    let column = table.columns().iter().find(|column| column.name == name)?;
    Some(match &column.column {
        Column::Numbers(values) => {
            let dim = dim_of(column);
            Value::List(values.iter().map(|&cell| number_cell(cell, dim)).collect())
        }
        Column::Texts(values) => Value::list(values.iter().map(|text| Value::text(text)).collect()),
    })
}

/// The number of a cell; an empty one holds none.
fn number_cell(value: f64, dim: Dimension) -> Value {
    if value.is_finite() { Value::Number(Number { value, dim }) } else { Value::None }
}

fn domain(interval: Interval) -> Value {
    Value::Range(Range::from(interval))
}

fn count(n: usize) -> Value {
    Value::number(n as f64)
}

fn numbers(values: &[f64]) -> Value {
    Value::List(values.iter().map(|&value| Value::number(value)).collect())
}

fn points(values: &[DVec3]) -> Value {
    Value::List(values.iter().map(|&point| Value::Point(point)).collect())
}

fn grid<T>(grid: &Grid<T>, value: impl Fn(&T) -> Value) -> Value {
    let row = |i| Value::List(grid.row(i).iter().map(&value).collect());
    Value::list((0..grid.n_rows()).map(row).collect())
}

/// Row `idx` of a table as a record.
#[must_use]
pub fn table_row(table: &Table, idx: usize) -> Value {
    let fields = table.columns().iter().map(|column| {
        let cell = match &column.column {
            Column::Numbers(values) => number_cell(values[idx], dim_of(column)),
            Column::Texts(values) => Value::text(&values[idx]),
        };
        (Arc::from(column.name.as_str()), cell)
    });
    Value::Record(Arc::new(super::Record::new(fields)))
}
