//! `midpoint`: the point halfway.

use crate::{
    diag::Result,
    value::{Ctx, OnVectors, Real, Vector, op},
};

op! {
    /// The point halfway between two points.
    midpoint in Vector -> Vector {
        /// One point.
        a: Vector,
        /// The other point.
        b: Vector,
    }
    example "midpoint((0, 0), (2, 4))" => "(1, 2, 0)";
    on_vectors OnVectors::VectorOfTwo(|a, b| (a + b) * 0.5);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    Ok(args.a.plus(&args.b).times(&Real::Plain(0.5)))
}
