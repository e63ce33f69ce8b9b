//! `floor`: the whole number below.

use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, Number, OnNumbers, op},
};

op! {
    /// The largest whole number that is not above `x`.
    floor in Math -> Number {
        /// A number of any dimension.
        x: LocallyConstant,
    }
    example "floor(-1.5)" => "-2";
    on_numbers OnNumbers::One(Some, f64::floor);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    Ok(Number { value: x.value.floor(), ..x })
}
