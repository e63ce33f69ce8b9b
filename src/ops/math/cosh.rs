//! `cosh`: the hyperbolic cosine.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Real, op},
};

op! {
    /// Hyperbolic cosine.
    cosh in Math -> Real {
        /// A number.
        x: Spanned<Real>,
    }
    example "cosh(0)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    finite(args.x.value.cosh().at(args.x.span)?, args.x.span)
}
