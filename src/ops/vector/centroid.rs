//! `centroid`: the mean of points.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{AtLeast, Ctx, op},
};

op! {
    /// Mean of some points, all of the same weight.
    centroid in Vector -> DVec3 {
        /// The points, as a list or as the arguments themselves.
        points: AtLeast<1, DVec3>,
    }
    example "centroid((0, 0), (3, 0), (0, 3))" => "(1, 1, 0)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let AtLeast(points) = args.points;
    Ok(points.iter().sum::<DVec3>() / points.len() as f64)
}
