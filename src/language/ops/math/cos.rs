//! `cos`: the cosine of an angle.

use super::{Radians, warn_of_degrees};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Cosine of an angle; a bare number counts as radians.
    cos in Math -> Real {
        /// An angle, or a number of radians.
        angle: Spanned<Radians>,
    }
    example "cos(60deg) ~= 1/2" => "true";
    encloses crate::kernel::Enclosure::cos;
    on_numbers OnNumbers::OfAngle(libm::cos);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    warn_of_degrees(ctx, args.angle.span);
    args.angle.value.0.cos().at(ctx.span)
}
