//! `unit_vector`: the direction of a vector.

use super::{direction, plain_direction};
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, OnVectors, Vector, op},
};

op! {
    /// Vector of length one in the direction of `v`.
    unit_vector in Vector -> Vector {
        /// A vector that is not zero.
        v: Spanned<Vector>,
    }
    example "unit_vector((0, 5))" => "(0, 1, 0)";
    refuses "unit_vector((0, 0))" => "E0607: a vector of length zero has no direction";
    on_vectors OnVectors::VectorOfOne(plain_direction);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    direction(args.v)
}
