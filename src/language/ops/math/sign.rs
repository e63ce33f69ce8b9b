//! `sign`: the sign of a number.

use crate::{
    diag::Result,
    value::{Ctx, Dimension, LocallyConstant, OnNumbers, op},
};

op! {
    /// Sign of a number: -1, 0 or 1.
    sign in Math -> f64 {
        /// A number of any dimension.
        x: LocallyConstant,
    }
    example "sign(-2.5)" => "-1";
    example "sign(0)" => "0";
    on_numbers OnNumbers::One(|_| Some(Dimension::NONE), sign);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    let LocallyConstant(x) = args.x;
    Ok(sign(x.value))
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}
