//! `tanh`: the hyperbolic tangent.

use super::{finite, ratio};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Hyperbolic tangent.
    tanh in Math -> Real {
        /// A number.
        x: Spanned<Real>,
    }
    example "tanh(ln(2)) ~= 3/5" => "true";
    encloses crate::kernel::Enclosure::tanh;
    on_numbers OnNumbers::One(ratio, libm::tanh);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.tanh().at(args.x.span)?, args.x.span)
}
