//! `exp`: the exponential function.

use super::{finite, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// The exponential function, e to the power `x`.
    exp in Math -> Real {
        /// The exponent.
        x: Spanned<Real>,
    }
    example "exp(1) ~= e" => "true";
    refuses "exp(1000)" => "E0502: the result is beyond the largest number, 1.8e308";
    encloses crate::kernel::Enclosure::exp;
    on_numbers OnNumbers::One(ratio, libm::exp);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.exp().at(args.x.span)?, args.x.span)
}
