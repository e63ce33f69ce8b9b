//! `round`: the nearest whole number.

use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, Number, op},
};

op! {
    /// The nearest whole number; halves go away from zero.
    round in Math -> Number {
        /// A number of any dimension.
        x: LocallyConstant,
    }
    example "round(2.5)" => "3";
    example "round(-2.5)" => "-3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    Ok(Number { value: x.value.round(), ..x })
}
