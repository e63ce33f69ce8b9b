//! `cusps` of a curve.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Parameters where a curve turns back on itself, in order.
    ///
    /// Its derivative vanishes there and its tangent reverses, or two of its pieces meet so.
    cusps in Measure -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "cusps(bezier((0, 0), (1, 1), (0, 1), (1, 0)))" => "[0.5]";
    example "cusps(polyline((0, 0), (2, 0), (1, 0)))" => "[1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    Ok(args.c.cusps(ctx.tolerance))
}
