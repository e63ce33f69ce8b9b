//! `atan2`: the direction of a point of the plane.

use crate::{
    diag::Result,
    value::{Angle, Ctx, Length, op},
};

op! {
    /// The angle from the x-axis to the direction (x, y), from -180 to 180 degrees; zero for no direction.
    atan2 in Math -> Angle {
        /// The y-coordinate.
        y: Length,
        /// The x-coordinate.
        x: Length,
    }
    example "atan2(1, 1)" => "45deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle> {
    Ok(Angle(libm::atan2(args.y.0, args.x.0)))
}
