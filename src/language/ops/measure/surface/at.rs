//! `at` of a surface: its point.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Point of a surface at its parameters; `s(u, v)` is the same.
    at in Measure -> Vector {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "at(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0.5, 1)" => "(0.5, 1, 0.5)";
    refuses "at(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |u, v| args.s.point_at(u, v);
    varying::vector(
        &args.s,
        [&args.u, &args.v],
        ctx.span,
        plain,
        (0, |at: &varying::Varying| at.derivative(0, 0)),
    )
}
