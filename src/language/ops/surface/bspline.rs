//! `bspline` of a grid: the polynomial B-spline surface.

use super::{PerDirection, cubic, tensor};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    value::{Ctx, Rows, op},
};

op! {
    /// B-spline surface of a grid on given knots, or on uniform clamped ones over 0..1.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §3.4.
    bspline in Surface -> NurbsSurface {
        /// The control points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
        /// All knots, for both directions or `{u: , v: }`.
        knots: Option<Spanned<PerDirection<Vec<f64>>>>,
    }
    example "bspline([for i in 0..3: [for j in 0..3: (i, j)]])(0.5, 0.5)" => "(1.5, 1.5, 0)";
    refuses "bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])" => "E0601: along u: 2 points are too few for degree 3, which needs 4 or more";
    refuses "bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)]], degree = 1, knots = [0, 0, 1])" => "E0602: along u: 2 control points of degree 1 need 4 knots, got 3";
    derivative control_points;
    picture "bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    tensor(ctx, args.points, None, args.degree, args.knots)
}
