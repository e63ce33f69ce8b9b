//! `norm`: the length of a vector.

use crate::{
    diag::Result,
    value::{At, Ctx, Real, Vector, op},
};

op! {
    /// Length of a vector.
    norm in Vector -> Real {
        /// A vector.
        v: Vector,
    }
    example "norm((3, 4))" => "5";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    args.v.norm().at(ctx.span)
}
