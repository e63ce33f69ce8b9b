//! `distance`: the distance of two points.

use glam::DVec3;

use super::length;
use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Distance of two points.
    distance in Vector -> f64 {
        /// One point.
        a: DVec3,
        /// The other point.
        b: DVec3,
    }
    example "distance((1, 1), (4, 5))" => "5";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(length(args.b - args.a))
}
