//! `centroid` of a solid, or of its skin.

use glam::DVec3;

use super::{check_inside_varies, mass};
use crate::{
    diag::Result,
    ops::measure::MassOf,
    value::{At, Ctx, RealSolid, Vector, op, with_slopes},
};

op! {
    /// Centre of gravity of a solid, or of its faces.
    centroid in Solid -> Vector {
        /// The solid.
        s: RealSolid,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "centroid(solid(box((0, 0, 0), (1, 2, 3))))" => "(0.5, 1, 1.5)";
    example "centroid(solid(cone((0, 0), 1, 0, 4), cap = true)) ~= (0, 0, 1)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let center = mass(args.s.plain(), args.of, "centroid", ctx)?.centroid;
    let Some(varied) = args.s.varied() else { return Ok(Vector::Plain(center)) };
    check_inside_varies("centroid", args.of, ctx)?;
    let along = |axis: DVec3| {
        with_slopes(center.dot(axis), Some(varied.centroid_slopes(axis))).at(ctx.span)
    };
    Ok(Vector::new([along(DVec3::X)?, along(DVec3::Y)?, along(DVec3::Z)?]))
}
