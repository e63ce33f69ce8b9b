//! `twist` of a surface: the mixed derivative.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Twist of a surface: the vector Suv, the derivative by u and by v.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 1.28.
    twist in Measure -> Vector {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "twist(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 2)), 0.5, 0.5)" => "(0, 0, 2)";
    refuses "twist(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |u, v| Ok(args.s.derivatives_at(u, v, 2)?.get(1, 1));
    varying::vector(
        &args.s,
        [&args.u, &args.v],
        ctx.span,
        plain,
        (2, |at: &varying::Varying| at.derivative(1, 1)),
    )
}
