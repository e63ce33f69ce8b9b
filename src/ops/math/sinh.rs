//! `sinh`: the hyperbolic sine.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// Hyperbolic sine.
    sinh in Math -> f64 {
        /// A number.
        x: Spanned<f64>,
    }
    example "sinh(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    finite(libm::sinh(args.x.value), args.x.span)
}
