//! `polar`: a point by distance and angle.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{Angle, Ctx, Length, op},
};

op! {
    /// Point of the xy-plane at a distance and an angle from the origin, counter-clockwise from the x-axis.
    polar in Vector -> DVec3 {
        /// The distance.
        r: Length,
        /// The angle.
        angle: Angle,
    }
    example "polar(2, 0deg)" => "(2, 0, 0)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let (sine, cosine) = libm::sincos(args.angle.0);
    Ok(args.r.0 * DVec3::new(cosine, sine, 0.0))
}
