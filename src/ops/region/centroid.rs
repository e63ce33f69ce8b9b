//! `centroid` of a region.

use glam::DVec3;

use super::Given;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Centre of gravity of a region.
    centroid in Region -> DVec3 {
        /// The region.
        r: Given,
    }
    example "centroid(region(polyline([(0, 0), (3, 0), (0, 6)], closed = true))) ~= (1, 2)" => "true";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(args.r.mass().centroid)
}
