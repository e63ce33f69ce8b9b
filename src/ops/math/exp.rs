//! `exp`: the exponential function.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// The exponential function, e to the power `x`.
    exp in Math -> f64 {
        /// The exponent.
        x: Spanned<f64>,
    }
    example "exp(0)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    finite(libm::exp(args.x.value), args.x.span)
}
