//! `cross`: the vector product.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Vector product of two vectors, normal to both and right-handed.
    cross in Vector -> DVec3 {
        /// The first vector.
        a: DVec3,
        /// The second vector.
        b: DVec3,
    }
    example "cross((1, 0), (0, 1))" => "(0, 0, 1)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(args.a.cross(args.b))
}
