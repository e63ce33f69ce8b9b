//! `ceil`: the whole number above.

use super::{check_whole, rounded_dim};
use crate::{
    diag::Result,
    value::{At, Ctx, LocallyConstant, Number, OnNumbers, op},
};

op! {
    /// The smallest whole number that is not below `x`.
    ceil in Math -> Number {
        /// A number that is no angle.
        x: LocallyConstant,
    }
    example "ceil(1.2)" => "2";
    refuses "gradient(x => ceil(x), 2)" => "E0503: `ceil` has no derivative at 2";
    on_numbers OnNumbers::One(rounded_dim, f64::ceil);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let x = args.x.looked_at();
    check_whole(x, OP.name, ctx.span)?;
    let value = args.x.step("`ceil`", f64::ceil).at(ctx.span)?;
    Ok(Number { value, ..x })
}
