//! `tan`: the tangent of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{At, Ctx, Real, op},
};

op! {
    /// Tangent of an angle; a bare number counts as radians.
    tan in Math -> Real {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "tan(45deg) ~= 1" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    args.angle.0.tan().at(ctx.span)
}
