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
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.value.control_polygon().at(args.c.span)
}
