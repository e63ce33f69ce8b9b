//! `section` of a solid by a plane.

use std::sync::Arc;

use super::GivenSolid;
use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, Region},
    value::{At, Ctx, op},
};

op! {
    /// The regions that a plane has of a solid, the largest first: holes are holes.
    ///
    /// Faces that lie in the plane are among them. A plane that misses gives an empty list.
    section in Solid -> Vec<Region> {
        /// The solid.
        s: GivenSolid,
        /// The plane.
        plane: Spanned<Arc<Frame>>,
    }
    example "len(section(solid([sphere((0, 0), 2), sphere((0, 0), 1)]), XY)[0].holes)" => "1";
    example "area(section(solid(sphere((0, 0), 5)), plane((0, 0, 3), (0, 0, 1)))[0]) ~= 16*pi within 1e-5" => "true";
    example "section(solid(box((0, 0, 0), (1, 2, 3))), plane((0, 0, 5), (0, 0, 1)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    args.s.section(*args.plane.value, ctx.tolerance).at(args.plane.span)
}
