//! `sqrt`: the square root.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Number, OnNumbers, Real, op},
};

op! {
    /// Square root; of an area it is a length.
    sqrt in Math -> Number<Real> {
        /// A number that is not negative.
        x: Spanned<Number<Real>>,
    }
    example "sqrt(2)" => "1.4142135623730951";
    example "sqrt(9mm * 4mm)" => "6";
    refuses "sqrt(-1)" => "E0502: a negative number (-1) has no square root";
    encloses crate::kernel::Enclosure::sqrt;
    on_numbers OnNumbers::One(|dim| dim.power(0.5), f64::sqrt);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let Spanned { value: x, span } = args.x;
    if x.value.value() < 0.0 {
        return outside(span, format!("a negative number ({}) has no square root", x.looked_at()));
    }
    let Some(dim) = x.dim.power(0.5) else {
        return outside(span, format!("{} has no square root", x.dim));
    };
    Ok(Number { value: x.value.sqrt().at(span)?, dim })
}
