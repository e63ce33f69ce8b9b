//! `asin`: the angle with a given sine.

use super::{angle_of, outside};
use crate::{
    diag::{Result, Spanned},
    value::{Angle, At, Ctx, OnNumbers, Real, op, shortest},
};

op! {
    /// The angle whose sine is `x`.
    asin in Math -> Angle<Real> {
        /// A number from -1 to 1.
        x: Spanned<Real>,
    }
    example "asin(1)" => "90deg";
    refuses "asin(2)" => "E0502: no angle has the sine 2; it lies between -1 and 1";
    on_numbers OnNumbers::One(angle_of, libm::asin);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    let x = args.x.value.value();
    if !(-1.0..=1.0).contains(&x) {
        return outside(
            args.x.span,
            format!("no angle has the sine {}; it lies between -1 and 1", shortest(x)),
        );
    }
    args.x.value.asin().at(args.x.span).map(Angle)
}
