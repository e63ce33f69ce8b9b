//! `control_polygon`: the polygon of a curve's control points.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// Polyline through a curve's control points, one unit of parameter a leg.
    ///
    /// Points that a weight of zero takes away are left out.
    control_polygon in Curve -> NurbsCurve {
        /// The curve.
        c: Spanned<Arc<NurbsCurve>>,
    }
    example "control_polygon(bezier((0, 0), (1, 2), (2, 0)))(1)" => "(1, 2, 0)";
    example "control_polygon(bezier((0, 0), (1, 2), (2, 0))).degree" => "1";
    refuses "control_polygon(parametric(t => (t, t^2), 0..2))" => "E0301: `control_polygon`: `c` must be a NURBS curve, found a parametric curve";
    refuses "control_polygon(bezier([(1, 2)]))" => "E0601: 2 points or more are needed, got 1";
    derivative affine;
    scene r#"
        curve c = bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))
        curve polygon = control_polygon(c) with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.value.control_polygon().at(args.c.span)
}
