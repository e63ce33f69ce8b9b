//! `inflections` of a curve.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Parameters where a curve goes over from one way of bending to the other, in order.
    ///
    /// Of a planar curve, where its signed curvature changes sign; of a curve in space, where its
    /// curvature vanishes. Found completely, as changes of sign of C' × C''.
    /// Farin, *Curves and Surfaces for CAGD*, §23.1.
    inflections in Measure -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "inflections(bezier((0, 0), (1, 2), (2, -2), (3, 0)))" => "[0.5]";
    example "inflections(circle((0, 0), 1))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    Ok(args.c.inflections(ctx.tolerance))
}
