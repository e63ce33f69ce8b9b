//! `floor`: the whole number below.

use super::{check_whole, rounded_dim};
use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, Number, OnNumbers, op},
};

op! {
    /// The largest whole number that is not above `x`.
    floor in Math -> Number {
        /// A number that is no angle.
        x: LocallyConstant,
    }
    example "floor(-1.5)" => "-2";
    refuses "floor(400deg)" => "E0303: an angle has no digits of its own: degrees are no radians";
    on_numbers OnNumbers::One(rounded_dim, f64::floor);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    check_whole(x, OP.name, ctx.span)?;
    Ok(Number { value: x.value.floor(), ..x })
}
