//! `norm`: the length of a vector.

use glam::DVec3;

use super::length;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Length of a vector.
    norm in Vector -> f64 {
        /// A vector.
        v: DVec3,
    }
    example "norm((3, 4))" => "5";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(length(args.v))
}
