//! `coons_cubic`: one segment of the uniform cubic B-spline.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Coons cubic of four points: one segment of the uniform cubic B-spline, on 0..1.
    ///
    /// It starts a third of the way from the second point to the middle of its neighbours and
    /// ends likewise at the third point, with the derivatives (P2 - P0)/2 and (P3 - P1)/2.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.3.
    coons_cubic in Curve -> NurbsCurve {
        /// The four control points.
        points: Spanned<AtLeast<4, DVec3>>,
    }
    example "coons_cubic((0, 0), (0, 6), (6, 6), (6, 0))(0) ~= (1, 5) within 1e-14" => "true";
    example "derivative(coons_cubic((0, 0), (0, 6), (6, 6), (6, 0)), 1) ~= (3, -3)" => "true";
    refuses "coons_cubic((0, 0), (1, 2), (2, 0))" => "E0601: `coons_cubic`: `points` must be a list of 4 or more points, found a list of 3 points";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let (AtLeast(points), span) = (args.points.value, args.points.span);
    if points.len() != 4 {
        let message = format!("a Coons cubic has four points, found {}", points.len());
        return Diagnostic::error(Code::BadCall, span, message)
            .hint("`coons_bspline` takes four or more")
            .fail();
    }
    NurbsCurve::uniform(3, &points, false).at(span)
}
