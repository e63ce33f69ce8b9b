//! `tangent_v` of a surface: a unit tangent.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Unit tangent of a surface along Sv.
    ///
    /// On an edge that is collapsed to a point, such as the pole of a sphere, it is the limit from inside
    /// of the domain.
    tangent_v in Measure -> Vector {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "tangent_v(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), 0.5, 0.5)" => "(0, 1, 0)";
    refuses "tangent_v(bilinear((0, 0), (0, 0), (0, 0), (0, 0)), 0.5, 0.5)" => "E0607: there is no tangent along v at (0.5, 0.5): the derivative vanishes and has no direction";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |u, v| args.s.tangent_v_at(u, v);
    varying::vector(
        &args.s,
        [&args.u, &args.v],
        ctx.span,
        plain,
        (1, |at: &varying::Varying| at.direction(0, 1)),
    )
}
