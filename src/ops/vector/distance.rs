//! `distance`: the distance of two points.

use crate::{
    diag::Result,
    value::{At, Ctx, Real, Vector, op},
};

op! {
    /// Distance of two points.
    distance in Vector -> Real {
        /// One point.
        a: Vector,
        /// The other point.
        b: Vector,
    }
    example "distance((1, 1), (4, 5))" => "5";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    args.b.minus(&args.a).norm().at(ctx.span)
}
