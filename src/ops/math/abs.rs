//! `abs`: the magnitude of a number.

use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// Magnitude of a number, without its sign.
    abs in Math -> Number {
        /// A number of any dimension.
        x: Number,
    }
    example "abs(-3)" => "3";
    example "abs(-30deg)" => "30deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    Ok(Number { value: args.x.value.abs(), ..args.x })
}
