//! `nurbs` of a grid: the rational B-spline surface.

use super::{PerDirection, cubic, tensor};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    value::{Ctx, Rows, op},
};

op! {
    /// Rational B-spline surface (NURBS) of a grid with weights, on given knots or on uniform
    /// clamped ones over 0..1.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §4.4.
    nurbs in Surface -> NurbsSurface {
        /// The control points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// A weight for each point, in the same grid.
        weights: Option<Spanned<Vec<Vec<f64>>>>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
        /// All knots, for both directions or `{u: , v: }`.
        knots: Option<Spanned<PerDirection<Vec<f64>>>>,
    }
    example "nurbs([[(0, 0), (0, 1)], [(1, 0), (1, 1, 4)]], degree = 1).rational" => "false";
    example "nurbs([[(0, 0), (0, 1)], [(1, 0), (1, 1, 4)]], weights = [[1, 1], [1, 2]], degree = 1)(1, 0.5)" => "(1, 0.6666666666666666, 2.6666666666666665)";
    refuses "nurbs([[(0, 0), (0, 1)], [(1, 0), (1, 1)]], weights = [[1, 1]], degree = 1)" => "E0603: there are 2 x 2 points, but 1 x 2 weights; each point needs one";
    derivative control_points;
    scene r#"
        surface s = nurbs([for i in 0..4: [for j in 0..4: (i, j, if i == 2 and j == 2 then 4 else 0)]], weights = [for i in 0..4: [for j in 0..4: if i == 2 and j == 2 then 8 else 1]], degree = 2)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    tensor(ctx, args.points, args.weights, args.degree, args.knots)
}
