//! `angle_between`: the angle of two vectors.

use super::direction;
use crate::{
    diag::{Result, Spanned},
    value::{Angle, At, Ctx, Real, Vector, op},
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
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    let (a, b) = (direction(args.a)?, direction(args.b)?);
    let half = || a.minus(&b).norm()?.atan2(&a.plus(&b).norm()?);
    Ok(Angle(half().at(ctx.span)?.scaled(2.0)))
}
