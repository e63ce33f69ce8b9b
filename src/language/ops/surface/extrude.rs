//! `extrude`: a curve moved along a vector.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Surface that a curve leaves behind when it is moved along a vector.
    ///
    /// Exact: u runs along the curve on its own domain, v on 0..1 along the vector.
    /// A parametric curve is followed within the document's tolerance. Piegl & Tiller, *The NURBS Book*, §8.3.
    extrude in Surface -> NurbsSurface {
        /// The curve.
        c: Curve,
        /// Where each point of it goes.
        vector: Spanned<DVec3>,
    }
    example "extrude(line((0, 0), (2, 0)), (0, 0, 3))(0.5, 1)" => "(1, 0, 3)";
    example "extrude(circle((0, 0), 2), (0, 0, 5)).rational" => "true";
    refuses "extrude(line((0, 0), (2, 0)), (0, 0, 0))" => "E0607: the vector has length zero, so that the curve stays where it is";
    derivative shape;
    picture "extrude(bezier((0, 0), (1, 3), (3, -2), (4, 1)), (0, 0, 3))";
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
    let c = args.c.nurbs_within(ctx.tolerance.distance).at(ctx.span)?;
    if c.is_along(vector, ctx.tolerance) {
        return Diagnostic::error(
            Code::Degenerate,
            args.vector.span,
            "the curve runs straight along the vector, so that no surface is left behind",
        )
        .fail();
    }
    NurbsSurface::extruded(&c, vector).at(args.vector.span)
}
