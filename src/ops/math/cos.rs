//! `cos`: the cosine of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{At, Ctx, Real, op},
};

op! {
    /// Cosine of an angle; a bare number counts as radians.
    cos in Math -> Real {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "cos(60deg) ~= 1/2" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Real> {
    args.angle.0.cos().at(ctx.span)
}
