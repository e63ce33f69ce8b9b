//! `polar`: a point by distance and angle.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{Angle, At, Ctx, Length, OnVectors, Real, Vector, op},
};

op! {
    /// Point of the xy-plane at a distance and an angle from the origin, counter-clockwise from the x-axis.
    polar in Vector -> Vector {
        /// The distance.
        r: Length<Real>,
        /// The angle.
        angle: Angle<Real>,
    }
    example "polar(2, 0deg)" => "(2, 0, 0)";
    refuses "polar(2, 90)" => "E0304: `polar`: `angle` must be an angle, found the number 90";
    on_vectors OnVectors::OfLengthAndAngle(plain_point);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let (angle, radius) = (args.angle.0, args.r.0);
    let along = |part: Real| part.times(&radius);
    let [x, y] = [angle.cos().at(ctx.span)?, angle.sin().at(ctx.span)?].map(along);
    Ok(Vector::new([x, y, Real::Plain(0.0)]))
}

/// The same of plain numbers.
fn plain_point(radius: f64, angle: f64) -> DVec3 {
    DVec3::new(libm::cos(angle) * radius, libm::sin(angle) * radius, 0.0)
}
