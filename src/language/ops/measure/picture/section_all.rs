//! `section` of several curves and surfaces by a plane.

use std::sync::Arc;

use super::{reported, section_curves};
use crate::{
    diag::{Result, Span},
    kernel::{Curve, Frame, Mesh, Surface},
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Type, Value, op},
};

op! {
    /// Points and curves in which a plane cuts the curves, surfaces and meshes of a list, those of all
    /// in one list.
    section in Measure -> Vec<Value> {
        /// The curves, surfaces and meshes.
        g: Vec<Sectioned>,
        /// The plane.
        plane: Arc<Frame>,
    }
    example "section([line((0, 0, -1), (0, 0, 1)), line((2, 0, -1), (2, 0, 3))], XY)" => "[(0, 0, 0), (2, 0, 0)]";
    example "len(section(box((0, 0, 0), (1, 1, 1)), plane((0, 0, 0.5), (0, 0, 1))))" => "4";
    refuses "section([XY], XY)" => "E0301: `section` takes a curve, a surface, a face, a list of curves, surfaces or meshes, a mesh or a solid, found a list of 1 plane";
}

/// Whatever a plane cuts.
#[derive(Clone)]
enum Sectioned {
    Curve(Curve),
    Surface(Surface),
    Mesh(Arc<Mesh>),
}

impl FromValue for Sectioned {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::Surface, Type::Mesh]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self::Curve(curve.clone())),
            Value::Surface(surface) => Ok(Self::Surface(surface.clone())),
            Value::Mesh(mesh) => Ok(Self::Mesh(Arc::clone(mesh))),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let mut found = Vec::new();
    for part in &args.g {
        match part {
            Sectioned::Curve(curve) => {
                let points = curve.plane_points(*args.plane, ctx.tolerance).at(ctx.span)?;
                found.extend(points.into_iter().map(IntoValue::into_value));
            }
            Sectioned::Surface(surface) => {
                let curves = section_curves(ctx, surface, *args.plane)?;
                let told = |curve| reported(curve, surface, *args.plane, ctx);
                found.extend(curves.into_iter().map(|curve| told(curve).into_value()));
            }
            Sectioned::Mesh(mesh) => {
                let curves = mesh.section(*args.plane).at(ctx.span)?;
                found.extend(curves.into_iter().map(IntoValue::into_value));
            }
        }
    }
    Ok(found)
}
