//! `bezier` of a grid: the tensor-product Bézier surface.

use super::{weight_grid, with_area};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{KnotVector, NurbsSurface},
    value::{At, Ctx, Rows, op},
};

op! {
    /// Bézier surface of a grid of control points, on 0..1 in both directions.
    ///
    /// Its degrees are one less than the numbers of rows and of points in a row; its corners are
    /// the grid's. Piegl & Tiller, *The NURBS Book*, §1.5.
    bezier in Surface -> NurbsSurface {
        /// The control points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// A weight for each point, in the same grid; without them the surface is polynomial.
        weights: Option<Spanned<Vec<Vec<f64>>>>,
    }
    example "bezier([[(0, 0), (0, 1)], [(1, 0), (1, 1, 4)]])(0.5, 0.5)" => "(0.5, 0.5, 1)";
    refuses "bezier([[(0, 0), (0, 1)], [(1, 0)]])" => "E0605: `bezier`: `points`: row 1 has 1 point, row 0 has 2; every row needs the same number";
    refuses "bezier([[(0, 0), (0, 1)], [(1, 0), (1, 1)]], weights = [[1, 1], [1, 0]])" => "E0603: the weights vanish together at (1, 1), which leaves no point there";
    derivative control_points;
    picture "bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let span = args.points.span;
    if grid.n_rows() < 2 || grid.n_columns() < 2 {
        let (rows, columns) = (grid.n_rows(), grid.n_columns());
        let message = format!("a surface needs 2 x 2 points or more, found {rows} x {columns}");
        return Diagnostic::error(Code::TooFewPoints, span, message)
            .hint("one row alone is a curve: `bezier(points)` of a list of points")
            .fail();
    }
    let Some(weights) = args.weights else {
        let surface = NurbsSurface::bezier(&grid).at(span)?;
        return Ok(with_area(ctx, surface));
    };
    let net = weight_grid(weights.value, &grid, weights.span)?;
    let knots_u = KnotVector::bezier(grid.n_rows() - 1).at(span)?;
    let knots_v = KnotVector::bezier(grid.n_columns() - 1).at(span)?;
    let surface = NurbsSurface::rational(knots_u, knots_v, &grid, &net).at(weights.span)?;
    Ok(with_area(ctx, surface))
}
