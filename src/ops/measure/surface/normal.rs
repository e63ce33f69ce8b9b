//! `normal` of a surface.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Unit normal of a surface, in the direction of Su × Sv.
    ///
    /// At a pole or a collapsed edge it is the limit, where that exists.
    normal in Measure -> DVec3 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "normal(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 0.5, 0.5)" => "(0, 0, 1)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    args.s.normal_at(u, v).at(ctx.span)
}
