//! `mean` of a surface: the mean curvature.

use super::shape;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{Ctx, op},
};

op! {
    /// Mean curvature of a surface: the mean of the principal curvatures.
    ///
    /// (EN − 2FM + GL)/(2(EG − F²)). A curvature is positive where its centre lies on the side of Su × Sv.
    /// At the pole of a closed shape it is the limit, if the shape has one. do Carmo, *Differential
    /// Geometry of Curves and Surfaces*, §3-3.
    mean in Measure -> f64 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "mean(cylinder((0, 0), 2, 1), 0, 0.5) ~= -1/4 within 1e-12" => "true";
    example "mean(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "0";
    refuses "mean(cone((0, 0), 3, 0, 4), 0, 1)" => "E0607: there is no curvature at (0, 1): Su × Sv vanishes there, and the curvatures around have no common limit";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(shape(&args.s, args.u, args.v, ctx)?.mean())
}
