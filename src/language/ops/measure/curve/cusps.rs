//! `cusps` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Parameters where a curve turns back on itself, in order.
    ///
    /// Its derivative vanishes there and its tangent reverses, or two of its pieces meet so.
    /// Of a parametric curve found near it and then on the function itself.
    cusps in Measure -> Vec<f64> {
        /// The curve.
        c: Curve,
    }
    example "cusps(bezier((0, 0), (1, 1), (0, 1), (1, 0)))" => "[0.5]";
    example "cusps(polyline((0, 0), (2, 0), (1, 0)))" => "[1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    args.c.cusps(ctx.tolerance).at(ctx.span)
}
