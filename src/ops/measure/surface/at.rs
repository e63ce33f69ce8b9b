//! `at` of a surface: its point.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Point of a surface at its parameters; `s(u, v)` is the same.
    at in Measure -> DVec3 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "at(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0.5, 1)" => "(0.5, 1, 0.5)";
    refuses "at(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    args.s.point_at(u, v).at(ctx.span)
}
