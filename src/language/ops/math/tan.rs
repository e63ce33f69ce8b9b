//! `tan`: the tangent of an angle.

use super::{Radians, warn_of_degrees};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, OnNumbers, Real, op},
};

op! {
    /// Tangent of an angle; a bare number counts as radians.
    tan in Math -> Real {
        /// An angle, or a number of radians.
        angle: Spanned<Radians>,
    }
    example "tan(45deg) ~= 1" => "true";
    encloses crate::kernel::Enclosure::tan;
    on_numbers OnNumbers::OfAngle(libm::tan);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    warn_of_degrees(ctx, args.angle.span);
    args.angle.value.0.tan().at(ctx.span)
}
