//! `ceil`: the whole number above.

use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, Number, OnNumbers, op},
};

op! {
    /// The smallest whole number that is not below `x`.
    ceil in Math -> Number {
        /// A number of any dimension.
        x: LocallyConstant,
    }
    example "ceil(1.2)" => "2";
    on_numbers OnNumbers::One(Some, f64::ceil);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let LocallyConstant(x) = args.x;
    Ok(Number { value: x.value.ceil(), ..x })
}
