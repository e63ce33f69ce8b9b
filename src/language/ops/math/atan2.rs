//! `atan2`: the direction of a point of the plane.

use crate::{
    diag::Result,
    value::{Angle, At, Ctx, Dimension, Length, OnNumbers, Real, op},
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
    on_numbers OnNumbers::Two(angle_of_lengths, libm::atan2);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    args.y.0.atan2(&args.x.0).at(ctx.span).map(Angle)
}

fn angle_of_lengths(y: Dimension, x: Dimension) -> Option<Dimension> {
    (y.is_as_length() && x.is_as_length()).then_some(Dimension::ANGLE)
}
