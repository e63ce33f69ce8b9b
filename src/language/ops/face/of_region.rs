//! `face` of a region.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{Face, Region},
    value::{At, Ctx, op},
};

op! {
    /// Face of a plane patch that holds what a region holds, with the same borders.
    ///
    /// Its normal points up, as that of the region; u and v are lengths along its plane.
    face in Face -> Face {
        /// The region.
        r: Spanned<Arc<Region>>,
    }
    example "area(face(region(circle((0, 0), 2), holes = [circle((0, 0), 1)]))) ~= 3*pi" => "true";
    example "len(face(region(circle((0, 0), 2), holes = [circle((0, 0), 1)])).edges)" => "2";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Face> {
    Face::of_region(&args.r.value, ctx.tolerance).at(args.r.span)
}
