//! `reversed`: a curve run through backwards.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Curve run through backwards, on the same domain: its start is the end of `c`.
    ///
    /// A parametric curve stays one.
    /// Piegl & Tiller, *The NURBS Book*, §6.5.
    reversed in Edit -> Curve {
        /// The curve.
        c: Curve,
    }
    example "reversed(line((0, 0), (2, 4)))(0.25)" => "(1.5, 3, 0)";
    example "reversed(polyline((0, 0), (3, 0), (3, 4))).domain" => "0..2";
    derivative shape;
    scene r#"
        curve c = bezier((0, 0), (1, 0), (3, 2), (6, 0)) with (color = "gray")
        curve back = reversed(translate(c, (0, -2)))
        curves ways = arrows([c, back], "derivative", samples = 5, scale = 1/4) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    args.c.reversed().at(ctx.span)
}
