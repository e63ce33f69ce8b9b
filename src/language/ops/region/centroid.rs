//! `centroid` of a region.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{At, Ctx, RealRegion, Vector, op, with_slopes},
};

op! {
    /// Centre of gravity of a region.
    centroid in Region -> Vector {
        /// The region.
        r: RealRegion,
    }
    example "centroid(region(polyline([(0, 0), (3, 0), (0, 6)], closed = true))) ~= (1, 2)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let center = args.r.plain().mass().centroid;
    let along = |axis: DVec3| {
        let slopes = args.r.varied().map(|varied| varied.centroid_slopes(axis));
        with_slopes(center.dot(axis), slopes).at(ctx.span)
    };
    Ok(Vector::new([along(DVec3::X)?, along(DVec3::Y)?, along(DVec3::Z)?]))
}
