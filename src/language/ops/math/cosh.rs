//! `cosh`: the hyperbolic cosine.

use super::{finite, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Hyperbolic cosine.
    cosh in Math -> Real {
        /// A number.
        x: Spanned<Real>,
    }
    example "cosh(ln(2)) ~= 5/4" => "true";
    refuses "cosh(1000)" => "E0502: the result is beyond the largest number, 1.8e308";
    encloses crate::kernel::Enclosure::cosh;
    on_numbers OnNumbers::One(ratio, libm::cosh);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.cosh().at(args.x.span)?, args.x.span)
}
