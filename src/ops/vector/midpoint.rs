//! `midpoint`: the point halfway.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// The point halfway between two points.
    midpoint in Vector -> DVec3 {
        /// One point.
        a: DVec3,
        /// The other point.
        b: DVec3,
    }
    example "midpoint((0, 0), (2, 4))" => "(1, 2, 0)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(0.5 * (args.a + args.b))
}
