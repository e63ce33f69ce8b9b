//! `atan2`: the direction of a point of the plane.

use crate::{
    diag::Result,
    value::{Angle, At, Ctx, Length, Real, op},
};

op! {
    /// The angle from the x-axis to the direction (x, y), from -180 to 180 degrees; zero for no direction.
    atan2 in Math -> Angle<Real> {
        /// The y-coordinate.
        y: Length<Real>,
        /// The x-coordinate.
        x: Length<Real>,
    }
    example "atan2(1, 1)" => "45deg";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    args.y.0.atan2(&args.x.0).at(ctx.span).map(Angle)
}
