//! `floor`: the whole number below.

use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// The largest whole number that is not above `x`.
    floor in Math -> Number {
        /// A number of any dimension.
        x: Number,
    }
    example "floor(-1.5)" => "-2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    Ok(Number { value: args.x.value.floor(), ..args.x })
}
