//! `extrema` of a curve.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, GeomError, InputError, unit},
    value::{At, Ctx, op},
};

op! {
    /// Parameters where a curve reaches furthest in a direction, or furthest against it, compared
    /// with its neighbourhood; in order.
    ///
    /// Ends of an open curve are none. Found completely, as changes of sign of C'·d.
    /// Of a parametric curve they are followed as for `inflections`.
    extrema in Measure -> Vec<f64> {
        /// The curve.
        c: Curve,
        /// The direction, of any length but zero.
        direction: Spanned<DVec3>,
    }
    example "extrema(bezier((0, 0), (1, 2), (2, 0)), (0, 1))" => "[0.5]";
    example "extrema(circle((0, 0), 1), (1, 0))" => "[0, 0.5]";
    refuses "extrema(bezier((0, 0), (1, 2), (2, 0)), (0, 0))" => "E0607: a vector of length zero has no direction";
    scene r#"
        curve c = bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))
        points places = [for t in extrema(c, (0, 1)): c(t)] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    let direction = unit(args.direction.value)
        .ok_or(GeomError::Input(InputError::ZeroAxis { what: "a vector of length zero" }))
        .at(args.direction.span)?;
    args.c.extrema(direction, ctx.tolerance).at(ctx.span)
}
