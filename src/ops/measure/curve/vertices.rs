//! `vertices` of a curve.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Parameters where the curvature of a curve has a local extremum, in order.
    ///
    /// Of a planar curve the signed curvature counts. Ends of an open curve and corners are none, and
    /// a circle has none that stands out. An ellipse has four.
    vertices in Measure -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "vertices(bezier((0, 0), (1, 2), (2, 0)))" => "[0.5]";
    example "vertices(circle((0, 0), 1))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    Ok(args.c.vertices(ctx.tolerance))
}
