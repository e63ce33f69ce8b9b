//! `dot`: the scalar product.

use glam::DVec3;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Scalar product of two vectors.
    dot in Vector -> f64 {
        /// One vector.
        a: DVec3,
        /// The other vector.
        b: DVec3,
    }
    example "dot((1, 2, 3), (4, 5, 6))" => "32";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(args.a.dot(args.b))
}
