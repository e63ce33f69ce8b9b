//! `extrude`: a curve moved along a vector.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{NurbsCurve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Surface that a curve leaves behind when it is moved along a vector.
    ///
    /// Exact: u runs along the curve on its own domain, v on 0..1 along the vector.
    /// Piegl & Tiller, *The NURBS Book*, §8.3.
    extrude in Surface -> NurbsSurface {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// Where each point of it goes.
        vector: Spanned<DVec3>,
    }
    example "extrude(line((0, 0), (2, 0)), (0, 0, 3))(0.5, 1)" => "(1, 0, 3)";
    example "extrude(circle((0, 0), 2), (0, 0, 5)).rational" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let vector = args.vector.value;
    if vector == DVec3::ZERO {
        return Diagnostic::error(
            Code::Degenerate,
            args.vector.span,
            "the vector has length zero, so that the curve stays where it is",
        )
        .fail();
    }
    if args.c.is_along(vector, ctx.tolerance) {
        return Diagnostic::error(
            Code::Degenerate,
            args.vector.span,
            "the curve runs straight along the vector, so that no surface is left behind",
        )
        .fail();
    }
    NurbsSurface::extruded(&args.c, vector).at(args.vector.span)
}
