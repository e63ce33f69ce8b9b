//! `log10`: the decimal logarithm.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op, shortest},
};

op! {
    /// Decimal logarithm, to the base 10.
    log10 in Math -> f64 {
        /// A positive number.
        x: Spanned<f64>,
    }
    example "log10(1000)" => "3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    if args.x.value <= 0.0 {
        return outside(
            args.x.span,
            format!("{} has no logarithm; only positive numbers have one", shortest(args.x.value)),
        );
    }
    Ok(libm::log10(args.x.value))
}
