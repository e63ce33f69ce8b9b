//! `log10`: the decimal logarithm.

use super::{outside, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op, shortest},
};

op! {
    /// Decimal logarithm, to the base 10.
    log10 in Math -> Real {
        /// A positive number.
        x: Spanned<Real>,
    }
    example "log10(1000)" => "3";
    refuses "log10(-1)" => "E0502: -1 has no logarithm; only positive numbers have one";
    on_numbers OnNumbers::One(ratio, libm::log10);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    let x = args.x.value.value();
    if x <= 0.0 {
        return outside(
            args.x.span,
            format!("{} has no logarithm; only positive numbers have one", shortest(x)),
        );
    }
    args.x.value.log10().at(args.x.span)
}
