//! `corners` of a surface.

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// The corners of a surface, `[[p00, p01], [p10, p11]]`: the first index counts along u.
    corners in Edit -> Vec<Vec<DVec3>> {
        /// The surface.
        s: Surface,
    }
    example "corners(bilinear((0, 0), (0, 1), (2, 0), (2, 1)))" => "[[(0, 0, 0), (0, 1, 0)], [(2, 0, 0), (2, 1, 0)]]";
    derivative shape;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<DVec3>>> {
    Ok(args.s.corners().at(ctx.span)?.map(Vec::from).into())
}
