//! `round`: the nearest whole number.

use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// The nearest whole number; halves go away from zero.
    round in Math -> Number {
        /// A number of any dimension.
        x: Number,
    }
    example "round(2.5)" => "3";
    example "round(-2.5)" => "-3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    Ok(Number { value: args.x.value.round(), ..args.x })
}
