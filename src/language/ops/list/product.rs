//! `product`: the product of a list.

use crate::{
    diag::Result,
    ops::math::{finite, outside},
    value::{Ctx, Dimension, Number, Real, op},
};

op! {
    /// Product of numbers; of an empty list 1. Units multiply too.
    product in List -> Number<Real> {
        /// The numbers.
        list: Vec<Number<Real>>,
    }
    example "product([2, 3, 4])" => "24";
    example "product(1..5)" => "120";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let one = Number { value: Real::Plain(1.0), dim: Dimension::NONE };
    args.list.into_iter().try_fold(one, |product, factor| {
        let value = finite(product.value.times(&factor.value), ctx.span)?;
        match product.dim.times(factor.dim) {
            Some(dim) => Ok(Number { value, dim }),
            None => outside(ctx.span, "the power of the unit is too high".to_owned()),
        }
    })
}
