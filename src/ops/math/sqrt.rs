//! `sqrt`: the square root.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, Number, op},
};

op! {
    /// Square root; of an area it is a length.
    sqrt in Math -> Number {
        /// A number that is not negative.
        x: Spanned<Number>,
    }
    example "sqrt(2)" => "1.4142135623730951";
    example "sqrt(9mm * 4mm)" => "6";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    if args.x.value.value < 0.0 {
        return outside(
            args.x.span,
            format!("a negative number ({}) has no square root", args.x.value),
        );
    }
    let Some(dim) = args.x.value.dim.power(0.5) else {
        return outside(args.x.span, format!("{} has no square root", args.x.value.dim));
    };
    Ok(Number { value: args.x.value.value.sqrt(), dim })
}
