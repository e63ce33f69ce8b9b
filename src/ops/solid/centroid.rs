//! `centroid` of a solid, or of its skin.

use glam::DVec3;

use super::{GivenSolid, mass};
use crate::{
    diag::Result,
    ops::measure::MassOf,
    value::{Ctx, op},
};

op! {
    /// Centre of gravity of a solid, or of its faces.
    centroid in Solid -> DVec3 {
        /// The solid.
        s: GivenSolid,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "centroid(solid(box((0, 0, 0), (1, 2, 3))))" => "(0.5, 1, 1.5)";
    example "centroid(solid(cone((0, 0), 1, 0, 4), cap = true)) ~= (0, 0, 1)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(mass(&args.s, args.of, "centroid", ctx)?.centroid)
}
