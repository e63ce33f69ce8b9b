//! `ruled`: straight lines between two curves.

use super::with_area;
use crate::{
    diag::Result,
    kernel::{Curve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Surface of straight lines between points of equal parameter on two curves.
    ///
    /// The first curve lies at v = 0, the second at v = 1; u runs along them, and along each line
    /// v is the fraction of its length. Curves of other degrees and knots are made compatible,
    /// exactly; where their weights differ by more than a common factor the degree is the sum.
    /// A parametric curve is followed within the document's tolerance. Piegl & Tiller, *The NURBS Book*, §8.4.
    ruled in Surface -> NurbsSurface {
        /// The curve at v = 0.
        c0: Curve,
        /// The curve at v = 1.
        c1: Curve,
    }
    example "ruled(line((0, 0), (1, 0)), line((0, 1), (1, 1, 1)))(0.5, 0.5)" => "(0.5, 0.5, 0.25)";
    example "ruled(line((0, 0), (0, 1)), nurbs([(1, 0), (1, 1)], weights = [3, 3], degree = 1))(0.5, 0.5)" => "(0.5, 0.5, 0)";
    derivative shape;
    picture "ruled(circle((0, 0, 0), 2), rotate(circle((0, 0, 4), 2), 90deg))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let curve = |c: &Curve| c.nurbs_within(ctx.tolerance.distance).at(ctx.span);
    let surface = NurbsSurface::ruled(&*curve(&args.c0)?, &*curve(&args.c1)?).at(ctx.span)?;
    Ok(with_area(ctx, surface))
}
