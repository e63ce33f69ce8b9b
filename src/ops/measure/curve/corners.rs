//! `corners` of a curve.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Parameters where the tangent of a curve jumps to another direction, in order.
    ///
    /// Where it turns back there is a cusp instead. The seam of a closed curve counts.
    corners in Measure -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "corners(polyline((0, 0), (1, 0), (1, 1), (2, 1)))" => "[1, 2]";
    example "corners(bezier((0, 0), (1, 2), (2, 0)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    Ok(args.c.corners(ctx.tolerance))
}
