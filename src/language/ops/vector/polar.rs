//! `polar`: a point by distance and angle.

use crate::{
    diag::Result,
    value::{Angle, At, Ctx, Length, Real, Vector, op},
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
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let (angle, radius) = (args.angle.0, args.r.0);
    let along = |part: Real| part.times(&radius);
    let [x, y] = [angle.cos().at(ctx.span)?, angle.sin().at(ctx.span)?].map(along);
    Ok(Vector::new([x, y, Real::Plain(0.0)]))
}
