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
    example "mean(parametric((u, v) => (2*cos(u), 2*sin(u), v), 0..tau, 0..1), 0, 0.5)" => "-0.25";
    example "mean(bezier([[(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)], [(1, -1, 0), (1, 0, -1), (1, 1, 0)]]), 0.5, 0.5)" => "0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(shape(&args.s, args.u, args.v, ctx)?.mean())
}
