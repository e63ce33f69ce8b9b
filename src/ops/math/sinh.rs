//! `sinh`: the hyperbolic sine.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Real, op},
};

op! {
    /// Hyperbolic sine.
    sinh in Math -> Real {
        /// A number.
        x: Spanned<Real>,
    }
    example "sinh(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.sinh().at(args.x.span)?, args.x.span)
}
