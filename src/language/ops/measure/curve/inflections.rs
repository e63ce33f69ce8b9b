//! `inflections` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Parameters where a curve goes over from one way of bending to the other, in order.
    ///
    /// Of a planar curve, where its signed curvature changes sign; of a curve in space, where its
    /// curvature vanishes. Found completely, as changes of sign of C' × C''.
    /// Of a parametric curve the sign is followed between exact derivatives at the ends of small
    /// pieces, and each place is found on the function itself to the last digits.
    /// Farin, *Curves and Surfaces for CAGD*, §23.1.
    inflections in Measure -> Vec<f64> {
        /// The curve.
        c: Curve,
    }
    example "inflections(bezier((0, 0), (1, 2), (2, -2), (3, 0)))" => "[0.5]";
    example "inflections(circle((0, 0), 1))" => "[]";
    scene r#"
        curve c = bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))
        points places = [for t in inflections(c): c(t)] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    args.c.inflections(ctx.tolerance).at(ctx.span)
}
