//! `norm`: the length of a vector.

use crate::{
    diag::Result,
    value::{At, Ctx, Dimension, OnVectors, Open, Real, Vector, op},
};

op! {
    /// Length of a vector.
    norm in Vector -> Open<Real> {
        /// A vector.
        v: Vector,
    }
    example "norm((3, 4))" => "5";
    on_vectors OnVectors::NumberOfOne(Dimension::OPEN, Vector::plain_norm);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Open<Real>> {
    args.v.norm().at(ctx.span).map(Open)
}
