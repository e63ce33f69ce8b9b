//! `ln`: the natural logarithm.

use super::{outside, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op, shortest},
};

op! {
    /// Natural logarithm, to the base e.
    ln in Math -> Real {
        /// A positive number.
        x: Spanned<Real>,
    }
    example "ln(e)" => "1";
    refuses "ln(0)" => "E0502: 0 has no logarithm; only positive numbers have one";
    encloses crate::kernel::Enclosure::ln;
    on_numbers OnNumbers::One(ratio, libm::log);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    let x = args.x.value.value();
    if x <= 0.0 {
        return outside(
            args.x.span,
            format!("{} has no logarithm; only positive numbers have one", shortest(x)),
        );
    }
    args.x.value.ln().at(args.x.span)
}
