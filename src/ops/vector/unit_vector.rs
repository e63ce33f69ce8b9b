//! `unit_vector`: the direction of a vector.

use glam::DVec3;

use super::direction;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// Vector of length one in the direction of `v`.
    unit_vector in Vector -> DVec3 {
        /// A vector that is not zero.
        v: Spanned<DVec3>,
    }
    example "unit_vector((0, 5))" => "(0, 1, 0)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    direction(args.v)
}
