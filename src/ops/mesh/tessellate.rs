//! `tessellate`: triangles within a tolerance.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{self, Bounds, Mesh, tolerance::DEFAULT_CHORD_RELATIVE},
    value::{At, Ctx, Geometry, Length, Value, op},
};

op! {
    /// Mesh of surfaces no further from them than a tolerance.
    ///
    /// Each knot-span rectangle is divided evenly until the measured deviation is within the
    /// tolerance. Meshes in a list are taken along as they are.
    tessellate in Mesh -> Mesh {
        /// A surface, or a list of surfaces and meshes.
        g: Spanned<Geometry>,
        /// The tolerance; when left out a thousandth of the size of `g`.
        tolerance: Option<Spanned<Length>>,
    }
    example "tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))" => "mesh of 4 vertices and 2 triangles";
    picture "tessellate(torus((0, 0, 0), 3, 1), tolerance = 0.05)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    let geometry = &args.g.value.0;
    let tolerance = match args.tolerance {
        Some(tolerance) if tolerance.value.0 <= 0.0 => {
            return Diagnostic::error(
                Code::Degenerate,
                tolerance.span,
                "the tolerance must be positive",
            )
            .fail();
        }
        Some(tolerance) => tolerance.value.0,
        None => DEFAULT_CHORD_RELATIVE * size(geometry).filter(|size| 0.0 < *size).unwrap_or(1.0),
    };
    let mut meshes = Vec::new();
    gather(geometry, tolerance, ctx, &args.g, &mut meshes)?;
    Mesh::merged(&meshes, ctx.limits.mesh_vertices).at(ctx.span)
}

/// The meshes of all surfaces in a value.
fn gather(
    value: &Value,
    tolerance: f64,
    ctx: &Ctx<'_>,
    whole: &Spanned<Geometry>,
    meshes: &mut Vec<Mesh>,
) -> Result<()> {
    match value {
        Value::Surface(surface) => {
            meshes.push(
                kernel::tessellate_any(surface, tolerance, ctx.limits.mesh_vertices).at(ctx.span)?,
            );
        }
        Value::Mesh(mesh) => meshes.push((**mesh).clone()),
        Value::List(items) => {
            for item in items.iter() {
                gather(item, tolerance, ctx, whole, meshes)?;
            }
        }
        other => {
            let message = format!("surfaces and meshes become triangles, found {}", other.phrase());
            return Diagnostic::error(Code::WrongKind, whole.span, message).fail();
        }
    }
    Ok(())
}

/// The diagonal of the box around a value.
fn size(value: &Value) -> Option<f64> {
    fn bounds(value: &Value) -> Option<Bounds> {
        match value {
            Value::Surface(surface) => surface.bounds().ok(),
            Value::Mesh(mesh) => mesh.bounds(),
            Value::List(items) => items.iter().filter_map(bounds).reduce(Bounds::union),
            _ => None,
        }
    }
    bounds(value).map(Bounds::diagonal)
}
