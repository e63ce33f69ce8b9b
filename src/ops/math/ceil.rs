//! `ceil`: the whole number above.

use crate::{
    diag::Result,
    value::{Ctx, Looked, Number, op},
};

op! {
    /// The smallest whole number that is not below `x`.
    ceil in Math -> Number {
        /// A number of any dimension.
        x: Looked,
    }
    example "ceil(1.2)" => "2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Looked(x) = args.x;
    Ok(Number { value: x.value.ceil(), ..x })
}
