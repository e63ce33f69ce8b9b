//! `sign`: the sign of a number.

use crate::{
    diag::Result,
    value::{Ctx, LocallyConstant, op},
};

op! {
    /// Sign of a number: -1, 0 or 1.
    sign in Math -> f64 {
        /// A number of any dimension.
        x: LocallyConstant,
    }
    example "sign(-2.5)" => "-1";
    example "sign(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    let LocallyConstant(x) = args.x;
    Ok(if x.value == 0.0 { 0.0 } else { x.value.signum() })
}
