//! `hypot`: the hypotenuse.

use super::{common_dim, finite};
use crate::{
    diag::Result,
    value::{At, Ctx, Dimension, Number, OnNumbers, Real, op},
};

op! {
    /// Length of the hypotenuse, the square root of x² + y² without overflow on the way.
    hypot in Math -> Number<Real> {
        /// One leg.
        x: Number<Real>,
        /// The other leg.
        y: Number<Real>,
    }
    example "hypot(3, 4)" => "5";
    on_numbers OnNumbers::Two(Dimension::sum, libm::hypot);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let legs = [args.x, args.y];
    let dim = common_dim(legs.iter().map(Number::looked_at), ctx.span)?;
    let length = legs[0].value.hypot(&legs[1].value).at(ctx.span)?;
    Ok(Number { value: finite(length, ctx.span)?, dim })
}
