//! `genus` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    value::{At, Ctx, op},
};

op! {
    /// How many handles a solid has, all of its shells together: 0 of a ball, 1 of a ring, and as many as there are holes of a plate with
    /// holes.
    ///
    /// By Euler and Poincaré, from the number of vertices, edges and faces.
    genus in Solid -> i64 {
        /// The solid.
        s: GivenSolid,
    }
    example "genus(solid(torus((0, 0), 3, 1)))" => "1";
    example "genus(extrude(region(circle((0, 0), 3), holes = [circle((1, 0), 0.5), circle((-1, 0), 0.5)]), (0, 0, 1)))" => "2";
    example "genus(solid([sphere((0, 0), 2), sphere((0, 0), 1)]))" => "0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<i64> {
    Ok(args.s.topology(ctx.tolerance).at(ctx.span)?.genus())
}
