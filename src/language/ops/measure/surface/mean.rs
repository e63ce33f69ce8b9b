//! `mean` of a surface: the mean curvature.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Curvature, LengthPower, Real, op},
};

op! {
    /// Mean curvature of a surface: the mean of the principal curvatures.
    ///
    /// (EN − 2FM + GL)/(2(EG − F²)). A curvature is positive where its centre lies on the side of Su × Sv.
    /// At the pole of a closed shape it is the limit, if the shape has one. do Carmo, *Differential
    /// Geometry of Curves and Surfaces*, §3-3.
    mean in Measure -> Curvature<Real> {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "mean(cylinder((0, 0), 2, 1), 0, 0.5) ~= -1/4 within 1e-12" => "true";
    example "mean(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "0";
    refuses "mean(cone((0, 0), 3, 0, 4), 0, 1)" => "E0607: there is no curvature at (0, 1): Su × Sv vanishes there, and the curvatures around have no common limit";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curvature<Real>> {
    let plain = |u, v| Ok(args.s.shape_at(u, v)?.mean());
    varying::number(
        &args.s,
        [&args.u, &args.v],
        ctx.span,
        plain,
        (2, |at: &varying::Varying| at.forms()?.mean()),
    )
    .map(LengthPower)
}
