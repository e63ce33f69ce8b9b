//! `normal` of a surface.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Unit normal of a surface, in the direction of Su × Sv.
    ///
    /// At a pole or a collapsed edge it is the limit, where that exists.
    normal in Measure -> Vector {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "normal(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 0.5, 0.5)" => "(0, 0, 1)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |u, v| args.s.normal_at(u, v);
    varying::vector(&args.s, [&args.u, &args.v], ctx.span, plain, (1, varying::Varying::normal))
}
