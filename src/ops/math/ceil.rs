//! `ceil`: the whole number above.

use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// The smallest whole number that is not below `x`.
    ceil in Math -> Number {
        /// A number of any dimension.
        x: Number,
    }
    example "ceil(1.2)" => "2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    Ok(Number { value: args.x.value.ceil(), ..args.x })
}
