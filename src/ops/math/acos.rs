//! `acos`: the angle with a given cosine.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Angle, Ctx, op, shortest},
};

op! {
    /// The angle whose cosine is `x`.
    acos in Math -> Angle {
        /// A number from -1 to 1.
        x: Spanned<f64>,
    }
    example "acos(0)" => "90deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle> {
    if !(-1.0..=1.0).contains(&args.x.value) {
        return outside(
            args.x.span,
            format!("no angle has the cosine {}; it lies between -1 and 1", shortest(args.x.value)),
        );
    }
    Ok(Angle(libm::acos(args.x.value)))
}
