//! `gaussian` of a surface: the Gaussian curvature.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, LengthPower, Real, op},
};

op! {
    /// Gaussian curvature of a surface: the product of the principal curvatures.
    ///
    /// (LN − M²)/(EG − F²): positive where the surface is like a dome or bowl, negative at a saddle, zero
    /// where it can be unrolled. At the pole of a closed shape, where the parametrization is singular, it is the limit if the shape has one.
    ///
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §3-3.
    gaussian in Measure -> LengthPower<-2, Real> {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "gaussian(sphere((0, 0), 2), 0.3, 0.5) ~= 1/4 within 1e-12" => "true";
    example "gaussian(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "-1";
    refuses "gaussian(cone((0, 0), 3, 0, 4), 0, 1)" => "E0607: there is no curvature at (0, 1): Su × Sv vanishes there, and the curvatures around have no common limit";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<LengthPower<-2, Real>> {
    let plain = |u, v| args.s.gaussian_at(u, v);
    varying::number(
        &args.s,
        [&args.u, &args.v],
        ctx.span,
        plain,
        (2, |at: &varying::Varying| at.forms()?.gaussian()),
    )
    .map(LengthPower)
}
