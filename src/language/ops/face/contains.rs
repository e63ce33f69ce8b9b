//! `contains` of a face: where a point is.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::{Face, RegionSide},
    value::{At, Ctx, op},
};

op! {
    /// Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a face, which is as wide as the
    /// document's tolerance on either side. A point further than the tolerance from the surface is outside.
    contains in Face -> RegionSide {
        /// The face.
        f: Arc<Face>,
        /// The point.
        p: DVec3,
    }
    example "contains(trim(sphere((0, 0), 1), by = XY, keep = \"above\"), (0, 0, 1))" => "\"inside\"";
    example "contains(trim(sphere((0, 0), 1), by = XY, keep = \"above\"), (1, 0))" => "\"border\"";
    example "contains(trim(sphere((0, 0), 1), by = XY, keep = \"above\"), (0, 0, -1))" => "\"outside\"";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RegionSide> {
    args.f.side_of(args.p, ctx.tolerance).at(ctx.span)
}
