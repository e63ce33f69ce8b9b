//! `twist` of a surface: the mixed derivative.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Twist of a surface: the vector Suv, the derivative by u and by v.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 1.28.
    twist in Measure -> DVec3 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "twist(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 2)), 0.5, 0.5)" => "(0, 0, 2)";
    refuses "twist(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    Ok(args.s.derivatives_at(u, v, 2).at(ctx.span)?.get(1, 1))
}
