//! `clamp`: a number kept within limits.

use super::{common_dim, outside};
use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// The number nearest to `x` between two limits.
    clamp in Math -> Number {
        /// The number.
        x: Number,
        /// The lower limit.
        low: Number,
        /// The upper limit.
        high: Number,
    }
    example "clamp(12, 0, 10)" => "10";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Args { x, low, high } = args;
    let dim = common_dim(&[x, low, high], ctx.span)?;
    if high.value < low.value {
        return outside(ctx.span, format!("the lower limit {low} is above the upper limit {high}"));
    }
    Ok(Number { value: x.value.max(low.value).min(high.value), dim })
}
