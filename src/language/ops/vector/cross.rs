//! `cross`: the vector product.

use crate::{
    diag::Result,
    value::{Ctx, OnVectors, Vector, op},
};

op! {
    /// Vector product of two vectors, normal to both and right-handed.
    cross in Vector -> Vector {
        /// The first vector.
        a: Vector,
        /// The second vector.
        b: Vector,
    }
    example "cross((1, 0), (0, 1))" => "(0, 0, 1)";
    on_vectors OnVectors::VectorOfTwo(Vector::plain_cross);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    Ok(args.a.cross(&args.b))
}
