//! `tanh`: the hyperbolic tangent.

use super::finite;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// Hyperbolic tangent.
    tanh in Math -> f64 {
        /// A number.
        x: Spanned<f64>,
    }
    example "tanh(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    finite(libm::tanh(args.x.value), args.x.span)
}
