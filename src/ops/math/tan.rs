//! `tan`: the tangent of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Tangent of an angle; a bare number counts as radians.
    tan in Math -> f64 {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "tan(0)" => "0";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(libm::tan(args.angle.0))
}
