//! `sinh`: the hyperbolic sine.

use super::{finite, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Hyperbolic sine.
    sinh in Math -> Real {
        /// A number.
        x: Spanned<Real>,
    }
    example "sinh(ln(2)) ~= 3/4" => "true";
    refuses "sinh(1000)" => "E0502: the result is beyond the largest number, 1.8e308";
    encloses crate::kernel::Enclosure::sinh;
    on_numbers OnNumbers::One(ratio, libm::sinh);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.sinh().at(args.x.span)?, args.x.span)
}
