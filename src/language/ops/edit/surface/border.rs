//! `border`: the boundary of a surface in one piece.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::{CountError, GeomError, NurbsCurve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Boundary of a surface as one closed curve, counter-clockwise about its normal from the
    /// corner where both parameters start.
    ///
    /// Exact, of the highest degree of the sides: along the first v, the last u, back along the
    /// last v and the first u. A side that is one point, such as that at a pole, is left out; the
    /// seam of a closed surface is run along in both directions.
    border in Edit -> NurbsCurve {
        /// The surface.
        s: Arc<NurbsSurface>,
    }
    example "border(bilinear((0, 0), (0, 1), (2, 0), (2, 1))).points" => "[(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 0, 0)]";
    example "border(bilinear((0, 0), (0, 1), (2, 0), (2, 1))).closed" => "true";
    refuses "border(bilinear((0, 0), (0, 0), (0, 0), (0, 0)))" => "E0607: each side of the surface is one point, which leaves no border";
    scene r#"
        curve around = border(s) with (color = "red")
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    match args.s.border(ctx.tolerance.distance) {
        Err(GeomError::Count(CountError::TooFewCurves { .. })) => {
            let message = "each side of the surface is one point, which leaves no border";
            Diagnostic::error(Code::Degenerate, ctx.span, message).fail()
        }
        border => border.at(ctx.span),
    }
}
