//! `dot`: the scalar product.

use crate::{
    diag::Result,
    value::{Ctx, Dimension, OnVectors, Open, Real, Vector, op},
};

op! {
    /// Scalar product of two vectors.
    dot in Vector -> Open<Real> {
        /// One vector.
        a: Vector,
        /// The other vector.
        b: Vector,
    }
    example "dot((1, 2, 3), (4, 5, 6))" => "32";
    on_vectors OnVectors::NumberOfTwo(Dimension::OPEN, Vector::plain_dot);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Open<Real>> {
    Ok(Open(args.a.dot(&args.b)))
}
