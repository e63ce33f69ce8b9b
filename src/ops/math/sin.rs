//! `sin`: the sine of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Sine of an angle; a bare number counts as radians.
    sin in Math -> f64 {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "sin(30deg)" => "0.49999999999999994";
    example "sin(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(libm::sin(args.angle.0))
}
