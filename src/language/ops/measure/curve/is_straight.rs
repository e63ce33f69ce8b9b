//! `is_straight` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Whether a curve lies on one line, to within the tolerance.
    ///
    /// Told from its control points, which lie on a line with it.
    /// Of a parametric curve those of the spline that `length` tells of.
    is_straight in Measure -> bool {
        /// The curve.
        c: Curve,
    }
    example "is_straight(bezier((0, 0), (3, 3), (1, 1)))" => "true";
    example "is_straight(circle((0, 0), 1))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    args.c.is_straight(ctx.tolerance).at(ctx.span)
}
