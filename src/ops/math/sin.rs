//! `sin`: the sine of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{At, Ctx, Real, op},
};

op! {
    /// Sine of an angle; a bare number counts as radians.
    sin in Math -> Real {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "sin(30deg) ~= 1/2" => "true";
    example "sin(0)" => "0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    args.angle.0.sin().at(ctx.span)
}
