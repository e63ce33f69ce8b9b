//! `ln`: the natural logarithm.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op, shortest},
};

op! {
    /// Natural logarithm, to the base e.
    ln in Math -> f64 {
        /// A positive number.
        x: Spanned<f64>,
    }
    example "ln(e)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    if args.x.value <= 0.0 {
        return outside(
            args.x.span,
            format!("{} has no logarithm; only positive numbers have one", shortest(args.x.value)),
        );
    }
    Ok(libm::log(args.x.value))
}
