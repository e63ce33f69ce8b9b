//! `sin`: the sine of an angle.

use super::{Radians, warn_of_degrees};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Sine of an angle; a bare number counts as radians.
    sin in Math -> Real {
        /// An angle, or a number of radians.
        angle: Spanned<Radians>,
    }
    example "sin(30deg) ~= 1/2" => "true";
    example "sin(0)" => "0";
    encloses crate::kernel::Enclosure::sin;
    on_numbers OnNumbers::OfAngle(libm::sin);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    warn_of_degrees(ctx, args.angle.span);
    args.angle.value.0.sin().at(ctx.span)
}
