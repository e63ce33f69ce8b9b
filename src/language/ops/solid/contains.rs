//! `contains` of a solid: where a point is.

use glam::DVec3;

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::RegionSide,
    value::{At, Ctx, op},
};

op! {
    /// Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a solid, which is as wide as the document's
    /// tolerance on either side of its faces. What is in a void is outside.
    contains in Solid -> RegionSide {
        /// The solid.
        s: GivenSolid,
        /// The point.
        p: DVec3,
    }
    example "contains(solid(box((0, 0, 0), (1, 2, 3))), (0.5, 1, 1))" => "\"inside\"";
    example "contains(solid(box((0, 0, 0), (1, 2, 3))), (1, 1, 1))" => "\"border\"";
    example "contains(solid([sphere((0, 0), 2), sphere((0, 0), 1)]), (0.5, 0))" => "\"outside\"";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RegionSide> {
    args.s.side_of(args.p, ctx.tolerance).at(ctx.span)
}
