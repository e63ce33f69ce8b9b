//! `asin`: the angle with a given sine.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Angle, Ctx, op, shortest},
};

op! {
    /// The angle whose sine is `x`.
    asin in Math -> Angle {
        /// A number from -1 to 1.
        x: Spanned<f64>,
    }
    example "asin(1)" => "90deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle> {
    if !(-1.0..=1.0).contains(&args.x.value) {
        return outside(
            args.x.span,
            format!("no angle has the sine {}; it lies between -1 and 1", shortest(args.x.value)),
        );
    }
    Ok(Angle(libm::asin(args.x.value)))
}
