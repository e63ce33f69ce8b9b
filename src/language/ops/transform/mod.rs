//! Transformations of anything geometric.

mod by_matrix;
mod frame_of;
mod mirror;
mod place;
mod plane;
mod project;
mod rotate;
mod scale;
mod station;

mod translate;

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{At, Geometry, NoDerivative, Op, Value},
};

pub(super) static OPS: &[&Op] = &[
    &translate::OP,
    &rotate::OP,
    &scale::OP,
    &mirror::OP,
    &by_matrix::OP,
    &place::OP,
    &project::OP,
    &station::OP,
    &plane::OP,
    &frame_of::OP,
];

/// The geometry moved by an affine map; lists element by element.
fn transformed(geometry: &Value, map: &DAffine3, span: Span) -> Result<Value> {
    Ok(match geometry {
        Value::Point(point) => Value::Point(map.transform_point3(*point)),
        Value::Curve(curve) => {
            let moved = curve.transformed(map);
            in_range(moved.is_finite(), span)?;
            Value::Curve(moved)
        }
        Value::Surface(surface) => {
            let moved = surface.transformed(map).at(span)?;
            in_range(moved.is_finite(), span)?;
            Value::Surface(moved)
        }
        Value::Region(region) => Value::Region(Arc::new(region.transformed(map).at(span)?)),
        Value::Face(face) => Value::Face(Arc::new(face.transformed(map).at(span)?)),
        Value::Solid(solid) => Value::Solid(Arc::new(solid.transformed(map).at(span)?)),
        Value::Mesh(mesh) => {
            let moved = mesh.transformed(map);
            in_range(moved.vertices().iter().all(|vertex| vertex.is_finite()), span)?;
            Value::Mesh(Arc::new(moved))
        }
        Value::Frame(frame) => Value::Frame(Arc::new(frame.transformed(map).at(span)?)),
        Value::List(items) => {
            let moved = items.iter().map(|item| transformed(item, map, span));
            Value::list(moved.collect::<Result<_>>()?)
        }
        other => other.clone(),
    })
}

/// Fails where a coordinate has left the numbers.
fn in_range(is_finite: bool, span: Span) -> Result<()> {
    if is_finite {
        return Ok(());
    }
    let message = "coordinates would be beyond the largest number, 1.8e308";
    Diagnostic::error(Code::Domain, span, message).fail()
}

/// Fails: no derivative passes through a map, for a reason.
fn no_derivative<T>(reason: NoDerivative, span: Span) -> Result<T> {
    Diagnostic::error(Code::NoDerivative, span, reason.message()).hint(reason.hint()).fail()
}

/// The same about another point than the origin.
fn about(map: DAffine3, center: DVec3) -> DAffine3 {
    DAffine3::from_translation(center) * map * DAffine3::from_translation(-center)
}

/// The geometry moved by an affine map.
fn apply(geometry: &Geometry, map: &DAffine3, span: Span) -> Result<Geometry> {
    transformed(&geometry.0, map, span).map(Geometry)
}
