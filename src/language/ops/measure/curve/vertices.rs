//! `vertices` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Parameters where the curvature of a curve has a local extremum, in order.
    ///
    /// Of a planar curve the signed curvature counts. Ends of an open curve and corners are none, and
    /// a circle has none that stands out. An ellipse has four.
    /// Of a parametric curve the slope of the curvature is followed as for `inflections`; cusps,
    /// where the curvature has no bound, are none.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-7.
    vertices in Measure -> Vec<f64> {
        /// The curve.
        c: Curve,
    }
    example "vertices(bezier((0, 0), (1, 2), (2, 0)))" => "[0.5]";
    example "vertices(circle((0, 0), 1))" => "[]";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        points places = [for t in vertices(c): c(t)] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    args.c.vertices(ctx.tolerance).at(ctx.span)
}
