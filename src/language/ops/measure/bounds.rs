//! `bounds`: the box around geometry.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Bounds, GeomError, Tolerance},
    value::{At, Ctx, Geometry, Record, Value, op},
};

op! {
    /// Smallest box along the axes around geometry, as `{min, max}`; of a list around all of it.
    ///
    /// It touches curves and surfaces themselves, not only their control points.
    /// Of a parametric curve it goes through its extrema, as `extrema` finds them; of a parametric
    /// surface it is that of a spline within 1e-8 of its size, or 1e-5 where that
    /// takes too many patches.
    bounds in Measure -> Record {
        /// A point, curve, surface or mesh, or a list of them.
        g: Spanned<Geometry>,
    }
    example "bounds(bezier((0, 0), (1, 2), (2, 0)))" => "{min: (0, 0, 0), max: (2, 1, 0)}";
    refuses "bounds([])" => "E0607: there is nothing that has a size";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let Some(Bounds { min, max }) = bounds(&args.g.value.0, ctx.tolerance).at(args.g.span)? else {
        return Diagnostic::error(Code::Degenerate, ctx.span, "there is nothing that has a size")
            .hint("planes, empty lists and meshes without triangles have no bounds")
            .fail();
    };
    Ok(Record::new([(Arc::from("min"), Value::Point(min)), (Arc::from("max"), Value::Point(max))]))
}

/// The box around a value; `None` around nothing.
fn bounds(value: &Value, tolerance: Tolerance) -> std::result::Result<Option<Bounds>, GeomError> {
    Ok(match value {
        Value::Point(point) => Some(Bounds { min: *point, max: *point }),
        Value::Curve(curve) => Some(curve.bounds()?),
        Value::Surface(surface) => Some(surface.bounds()?),
        Value::Region(region) => Some(region.bounds()),
        Value::Face(face) => Some(face.bounds(tolerance)?),
        Value::Solid(solid) => Some(solid.bounds(tolerance)?),
        Value::Mesh(mesh) => mesh.bounds(),
        Value::List(items) => {
            let mut whole = None;
            for item in items.iter() {
                whole =
                    [whole, bounds(item, tolerance)?].into_iter().flatten().reduce(Bounds::union);
            }
            whole
        }
        _ => None,
    })
}
