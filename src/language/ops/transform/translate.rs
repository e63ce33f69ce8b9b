//! `translate`: geometry moved.

use glam::{DAffine3, DVec3};

use super::apply;
use crate::{
    diag::Result,
    value::{Ctx, Geometry, op},
};

op! {
    /// Geometry moved by a vector.
    translate in Transform -> Geometry {
        /// What is moved.
        g: Geometry,
        /// By how much.
        v: DVec3,
    }
    example "translate((1, 2), (0, 0, 5))" => "(1, 2, 5)";
    derivative shape;
    picture "[for i in 0..3: translate(circle((0, 0), 1), (i, i/2, i))]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    apply(&args.g, &DAffine3::from_translation(args.v), ctx.span)
}
