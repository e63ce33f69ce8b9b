//! `distance`: the distance of two points.

use crate::{
    diag::Result,
    value::{At, Ctx, Dimension, Length, OnVectors, Real, Vector, op},
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
    on_vectors OnVectors::NumberOfTwo(Dimension::LENGTH, |a, b| Vector::plain_norm(b - a));
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Length<Real>> {
    args.b.minus(&args.a).norm().at(ctx.span).map(Length)
}
