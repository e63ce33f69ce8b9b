//! `reparametrize`: a curve over another domain.

use crate::{
    diag::Result,
    kernel::{Curve, Interval},
    value::{At, Ctx, op},
};

op! {
    /// The same points over another domain, the parameter mapped evenly.
    ///
    /// Derivatives of order k are divided by the k-th power of the domain's growth.
    /// A parametric curve stays one.
    /// Piegl & Tiller, *The NURBS Book*, §6.4.
    reparametrize in Edit -> Curve {
        /// The curve.
        c: Curve,
        /// The new domain, such as `0..10`.
        domain: Interval,
    }
    example "reparametrize(line((0, 0), (2, 4)), 10..30)(15)" => "(0.5, 1, 0)";
    example "reparametrize(line((0, 0), (2, 4)), 0..length(line((0, 0), (3, 4)))).domain" => "0..5";
    refuses "reparametrize(bezier((0, 0), (1, 2), (2, 0)), 2..2)" => "E0606: `reparametrize`: `domain`: an interval needs its start below its end, got 2..2";
    derivative shape;
    scene r#"
        curve c = bezier((0, 0), (1, 2), (3, 2), (6, 0)) with (color = "gray")
        curve twice = reparametrize(translate(c, (0, -2)), 0..2)
        curves speeds = arrows([c, twice], "derivative", samples = 5, scale = 1/4) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    args.c.reparametrized(args.domain).at(ctx.span)
}
