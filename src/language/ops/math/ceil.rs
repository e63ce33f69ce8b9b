//! `ceil`: the whole number above.

use super::{check_whole, rounded_dim};
use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, Number, OnNumbers, op},
};

op! {
    /// The smallest whole number that is not below `x`.
    ceil in Math -> Number {
        /// A number that is no angle.
        x: LocallyConstant,
    }
    example "ceil(1.2)" => "2";
    on_numbers OnNumbers::One(rounded_dim, f64::ceil);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    check_whole(x, OP.name, ctx.span)?;
    Ok(Number { value: x.value.ceil(), ..x })
}
