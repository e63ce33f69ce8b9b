//! `floor`: the whole number below.

use crate::{
    diag::Result,
    value::{Ctx, Looked, Number, op},
};

op! {
    /// The largest whole number that is not above `x`.
    floor in Math -> Number {
        /// A number of any dimension.
        x: Looked,
    }
    example "floor(-1.5)" => "-2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Looked(x) = args.x;
    Ok(Number { value: x.value.floor(), ..x })
}
