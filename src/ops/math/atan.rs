//! `atan`: the angle with a given tangent.

use crate::{
    diag::Result,
    value::{Angle, Ctx, op},
};

op! {
    /// The angle between -90 and 90 degrees whose tangent is `x`.
    atan in Math -> Angle {
        /// A number.
        x: f64,
    }
    example "atan(1)" => "45deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle> {
    Ok(Angle(libm::atan(args.x)))
}
