//! `to_coons`: a curve as a Coons cubic B-spline.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The same curve as a Coons cubic B-spline: uniform, not clamped, on the same domain.
    ///
    /// Knots that its smoothness does not need are left out. Refused where nothing but an
    /// approximation exists: for weights that differ, degrees above 3, segments that are not
    /// equally long in parameter, and joints that are not C2.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (2.51) and (2.53).
    to_coons in Curve -> NurbsCurve {
        /// The curve.
        c: Spanned<Arc<NurbsCurve>>,
    }
    example "to_coons(bezier((4, 1), (6, 2), (6, 4), (5, 5))).points ~= [(-6, 0), (6, 0), (6, 6), (0, 6)] within 1e-12" => "true";
    example "to_coons(clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4))).points ~= [(-7, 7), (2, -2), (5, 7), (8, -2), (17, 25)] within 1e-12" => "true";
    refuses "to_coons(polyline((0, 0), (1, 2), (3, 1)))" => "E0611: a Coons B-spline is C2 at its joints, but the curve is only C0 at parameter 1";
    refuses "to_coons(circle((0, 0), 1))" => "E0611: a Coons B-spline has no weights, but those of the curve differ";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.value.to_coons().at(args.c.span)
}
