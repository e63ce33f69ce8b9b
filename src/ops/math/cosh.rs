//! `cosh`: the hyperbolic cosine.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// Hyperbolic cosine.
    cosh in Math -> f64 {
        /// A number.
        x: Spanned<f64>,
    }
    example "cosh(0)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    finite(libm::cosh(args.x.value), args.x.span)
}
