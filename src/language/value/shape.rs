//! Geometry as arguments: of any kind, or curves and surfaces that must be NURBS.

use std::sync::Arc;

use super::{FromValue, Mismatch, Type, Value, hint_of};
use crate::{
    diag::Span,
    kernel::{Curve, GeomError, NurbsCurve, NurbsSurface, Surface},
};

/// A point, curve, surface, mesh or plane, or a list of such, however deep.
#[derive(Clone, Debug)]
pub struct Geometry(pub Value);

impl FromValue for Geometry {
    const TYPE: Type = Type::Geometry;

    #[expect(clippy::only_used_in_recursion, reason = "the trait hands in the place")]
    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::List(items) => {
                for (idx, item) in items.iter().enumerate() {
                    Self::from_value(item, span).map_err(|mismatch| mismatch.inside(idx))?;
                }
            }
            _ if !Type::Geometry.accepts(value) => return Err(Mismatch::kind(Self::TYPE, value)),
            _ => {}
        }
        Ok(Self(value.clone()))
    }
}

/// Geometry as [`Geometry`], that may carry derivatives.
#[derive(Clone, Debug)]
pub struct RealGeometry(pub Value);

impl FromValue for RealGeometry {
    const TYPE: Type = Type::Geometry;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::List(items) => {
                for (idx, item) in items.iter().enumerate() {
                    Self::from_value(item, span).map_err(|mismatch| mismatch.inside(idx))?;
                }
                Ok(Self(value.clone()))
            }
            _ => Geometry::from_value(&value.looked_at(), span).map(|_| Self(value.clone())),
        }
    }
}

/// A curve whose control points and knots are needed.
impl FromValue for Arc<NurbsCurve> {
    const TYPE: Type = Type::Curve;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        Curve::from_value(value, span)?
            .nurbs()
            .map(Self::clone)
            .map_err(|err| not_nurbs(&err, value))
    }
}

/// A surface whose control points and knots are needed.
impl FromValue for Arc<NurbsSurface> {
    const TYPE: Type = Type::Surface;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let surface = Surface::from_value(value, span)?;
        surface.nurbs().map(Self::clone).map_err(|err| not_nurbs(&err, value))
    }
}

fn not_nurbs(error: &GeomError, value: &Value) -> Mismatch {
    let mismatch = Mismatch::new(format!("a NURBS {}", value.kind()), value.phrase());
    match hint_of(error) {
        Some(hint) => mismatch.hint(hint),
        None => mismatch,
    }
}
