//! `product`: the product of a list.

use crate::{
    diag::Result,
    ops::math::{finite, outside},
    value::{Ctx, Number, op},
};

op! {
    /// Product of numbers; of an empty list 1. Units multiply too.
    product in List -> Number {
        /// The numbers.
        list: Vec<Number>,
    }
    example "product([2, 3, 4])" => "24";
    example "product(1..5)" => "120";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    args.list.into_iter().try_fold(Number::bare(1.0), |product, factor| {
        let value = finite(product.value * factor.value, ctx.span)?;
        match product.dim.times(factor.dim) {
            Some(dim) => Ok(Number { value, dim }),
            None => outside(ctx.span, "the power of the unit is too high".to_owned()),
        }
    })
}
