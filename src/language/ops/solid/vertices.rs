//! `vertices` of a solid.

use glam::DVec3;

use super::GivenSolid;
use crate::{
    diag::Result,
    value::{At, Ctx, op},
};

op! {
    /// The points where edges of a solid end: `s.vertices`.
    ///
    /// A closed edge, as the rim of a cylinder, ends where it starts.
    vertices in Solid -> Vec<DVec3> {
        /// The solid.
        s: GivenSolid,
    }
    example "len(vertices(solid(box((0, 0, 0), (1, 2, 3)))))" => "8";
    example "vertices(solid(sphere((0, 0), 2)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    args.s.vertices(ctx.tolerance).at(ctx.span)
}
