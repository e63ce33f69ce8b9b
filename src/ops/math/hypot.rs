//! `hypot`: the hypotenuse.

use super::{common_dim, finite};
use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// Length of the hypotenuse, the square root of x² + y² without overflow on the way.
    hypot in Math -> Number {
        /// One leg.
        x: Number,
        /// The other leg.
        y: Number,
    }
    example "hypot(3, 4)" => "5";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let dim = common_dim(&[args.x, args.y], ctx.span)?;
    Ok(Number { value: finite(libm::hypot(args.x.value, args.y.value), ctx.span)?, dim })
}
