//! `angle_between`: the angle of two vectors.

use glam::DVec3;

use super::direction;
use crate::{
    diag::{Result, Spanned},
    value::{Angle, Ctx, op},
};

op! {
    /// Angle between two vectors, from 0 to 180 degrees.
    ///
    /// Kahan's formula by half differences of the unit vectors, exact also where they nearly agree or oppose.
    angle_between in Vector -> Angle {
        /// One vector that is not zero.
        a: Spanned<DVec3>,
        /// The other one.
        b: Spanned<DVec3>,
    }
    example "angle_between((1, 0), (0, 2))" => "90deg";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Angle> {
    let (a, b) = (direction(args.a)?, direction(args.b)?);
    Ok(Angle(2.0 * libm::atan2((a - b).length(), (a + b).length())))
}
