//! `cos`: the cosine of an angle.

use super::Radians;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Cosine of an angle; a bare number counts as radians.
    cos in Math -> f64 {
        /// An angle, or a number of radians.
        angle: Radians,
    }
    example "cos(0deg)" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(libm::cos(args.angle.0))
}
