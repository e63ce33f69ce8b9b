//! `clamped` of a grid: the uniform clamped B-spline surface.

use super::{PerDirection, cubic, in_direction, with_area};
use crate::{
    diag::{Result, Spanned},
    kernel::{KnotVector, NurbsSurface},
    ops::curve::check_degree,
    value::{At, Ctx, Rows, op},
};

op! {
    /// Uniform clamped B-spline surface of a grid, one unit of parameter a patch.
    ///
    /// Its corners are the grid's. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.6.
    clamped in Surface -> NurbsSurface {
        /// The control points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
    }
    example "clamped([for i in 0..4: [for j in 0..3: (i, j)]]).domain_u" => "0..2";
    refuses "clamped([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])" => "E0601: along u: 2 points are too few for degree 3, which needs 4 or more";
    derivative control_points;
    picture "clamped([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let span = args.points.span;
    let knots = |degree: usize, n_points: usize| {
        check_degree(Spanned::new(degree, args.degree.span), Spanned::new(n_points, span))?;
        KnotVector::uniform_clamped(degree, n_points, (n_points - degree) as f64).at(span)
    };
    let knots_u = knots(args.degree.value.u, grid.n_rows())
        .map_err(|found| in_direction(found, "u", "rows"))?;
    let knots_v = knots(args.degree.value.v, grid.n_columns())
        .map_err(|found| in_direction(found, "v", "points in a row"))?;
    let surface = NurbsSurface::polynomial(knots_u, knots_v, &grid).at(span)?;
    Ok(with_area(ctx, surface))
}
