//! `corners` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Parameters where the tangent of a curve jumps to another direction, in order.
    ///
    /// Where it turns back there is a cusp instead. The seam of a closed curve counts.
    /// Of a parametric curve they are where its derivatives jump, known to the last digits.
    corners in Measure -> Vec<f64> {
        /// The curve.
        c: Curve,
    }
    example "corners(polyline((0, 0), (1, 0), (1, 1), (2, 1)))" => "[1, 2]";
    example "corners(bezier((0, 0), (1, 2), (2, 0)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    args.c.corners(ctx.tolerance).at(ctx.span)
}
