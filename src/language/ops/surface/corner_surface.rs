//! `corner_surface`: the surface of three or four corners.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, NurbsCurve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Surface of three or four corners in order around it, ruled by straight lines.
    ///
    /// The first corner is at u = 0, v = 0, the second at u = 1, v = 0, the third at u = 1, v = 1;
    /// of three the last one is the whole edge v = 1. Flat if the corners are in one plane, else a
    /// hyperbolic paraboloid. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.3.3.
    corner_surface in Surface -> NurbsSurface {
        /// The corners, three or four.
        points: Spanned<Vec<DVec3>>,
    }
    example "corner_surface((0, 0), (2, 0), (2, 2, 1), (0, 2))(0.5, 0.5)" => "(1, 1, 0.25)";
    example "corner_surface((0, 0), (2, 0), (0, 2))(0.7, 1)" => "(0, 2, 0)";
    refuses "corner_surface((0, 0), (2, 0))" => "E0601: a surface has three or four corners, found 2";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let points = &args.points.value;
    let span = args.points.span_or(ctx.span);
    let [a, b, c, d] = match points[..] {
        [a, b, c] => [a, b, c, c],
        [a, b, c, d] => [a, b, c, d],
        _ => {
            let message = format!("a surface has three or four corners, found {}", points.len());
            return Diagnostic::error(Code::TooFewPoints, span, message).fail();
        }
    };
    let outline = Curve::from(NurbsCurve::polyline(points).at(span)?);
    if outline.is_straight(ctx.tolerance).at(span)? {
        let message = "the corners lie on one line, so that no surface is between them";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    NurbsSurface::bilinear(a, d, b, c).at(span)
}
