//! `distance`: the distance of two points.

use crate::{
    diag::Result,
    value::{At, Ctx, Length, Real, Vector, op},
};

op! {
    /// Distance of two points.
    distance in Vector -> Length<Real> {
        /// One point.
        a: Vector,
        /// The other point.
        b: Vector,
    }
    example "distance((1, 1), (4, 5))" => "5";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Length<Real>> {
    args.b.minus(&args.a).norm().at(ctx.span).map(Length)
}
