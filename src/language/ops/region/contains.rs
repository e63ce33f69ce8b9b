//! `contains` of a region: on which side a point is.

use glam::DVec3;

use super::Given;
use crate::{
    diag::Result,
    kernel::RegionSide,
    value::{Choice, Ctx, op},
};

op! {
    /// Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a region, which is as wide as the
    /// document's tolerance on either side. A point beside the plane is outside.
    contains in Region -> RegionSide {
        /// The region.
        r: Given,
        /// The point.
        p: DVec3,
    }
    example "contains(region(circle((0, 0), 2)), (1, 0))" => "\"inside\"";
    example "contains(region(circle((0, 0), 2)), (0, 2))" => "\"border\"";
    example "contains(region(circle((0, 0), 2)), (0, 0, 1))" => "\"outside\"";
}

impl Choice for RegionSide {
    const WORDS: &'static [&'static str] = &["inside", "outside", "border"];
    const MEANINGS: &'static [Self] = &[Self::Inside, Self::Outside, Self::Border];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RegionSide> {
    Ok(args.r.side_of(args.p, ctx.tolerance.distance))
}
