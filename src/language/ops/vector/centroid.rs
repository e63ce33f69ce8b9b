//! `centroid`: the mean of points.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{At, AtLeast, Ctx, Real, Vector, op},
};

op! {
    /// Mean of some points, all of the same weight.
    centroid in Vector -> Vector {
        /// The points, as a list or as the arguments themselves.
        points: AtLeast<1, Vector>,
    }
    example "centroid((0, 0), (3, 0), (0, 3))" => "(1, 1, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let AtLeast(points) = args.points;
    let sum = points.iter().fold(Vector::Plain(DVec3::ZERO), |sum, point| sum.plus(point));
    sum.over(&Real::Plain(points.len() as f64)).at(ctx.span)
}
