//! `angle_between`: the angle of two vectors.

use glam::DVec3;

use super::{direction, plain_direction};
use crate::{
    diag::{Result, Spanned},
    value::{Angle, At, Ctx, Dimension, OnVectors, Real, Vector, op},
};

op! {
    /// Angle between two vectors, from 0 to 180 degrees.
    ///
    /// Kahan's formula by half differences of the unit vectors, exact also where they nearly agree or oppose.
    angle_between in Vector -> Angle<Real> {
        /// One vector that is not zero.
        a: Spanned<Vector>,
        /// The other one.
        b: Spanned<Vector>,
    }
    example "angle_between((1, 0), (0, 2))" => "90deg";
    refuses "angle_between((0, 0), (1, 0))" => "E0607: a vector of length zero has no direction";
    on_vectors OnVectors::NumberOfTwo(Dimension::ANGLE, plain_angle);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    let (a, b) = (direction(args.a)?, direction(args.b)?);
    let half = || a.minus(&b).norm()?.atan2(&a.plus(&b).norm()?);
    Ok(Angle(half().at(ctx.span)?.scaled(2.0)))
}

/// The same of plain vectors; no number where one of them has no direction.
fn plain_angle(a: DVec3, b: DVec3) -> f64 {
    let (a, b) = (plain_direction(a), plain_direction(b));
    libm::atan2(Vector::plain_norm(a - b), Vector::plain_norm(a + b)) * 2.0
}
