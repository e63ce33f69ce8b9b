//! `round`: the nearest whole number.

use crate::{
    diag::Result,
    value::{Ctx, Looked, Number, op},
};

op! {
    /// The nearest whole number; halves go away from zero.
    round in Math -> Number {
        /// A number of any dimension.
        x: Looked,
    }
    example "round(2.5)" => "3";
    example "round(-2.5)" => "-3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Looked(x) = args.x;
    Ok(Number { value: x.value.round(), ..x })
}
