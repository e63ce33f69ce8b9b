//! `is_planar` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Whether a curve lies in one plane, to within the tolerance.
    ///
    /// A straight curve does. Told from its control points, which lie in a plane with it.
    /// Of a parametric curve those of the spline that `length` tells of.
    is_planar in Measure -> bool {
        /// The curve.
        c: Curve,
    }
    example "is_planar(bezier((0, 0), (1, 2), (2, 0), (3, 1)))" => "true";
    example "is_planar(bezier((0, 0), (1, 2), (2, 0), (3, 1, 1)))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    args.c.is_planar(ctx.tolerance).at(ctx.span)
}
