//! `coons_bspline` of a grid: the uniform bicubic B-spline surface that is not clamped.

use glam::DVec3;

use super::{PerDirection, in_direction};
use crate::{
    diag::{Result, Spanned},
    kernel::{Grid, KnotVector, NurbsSurface},
    ops::curve::check_cubic,
    value::{At, Ctx, Rows, op},
};

op! {
    /// Coons bicubic B-spline surface: uniform, not clamped, one unit of parameter a patch.
    ///
    /// Every 4 by 4 neighbouring points make one patch; patches meet with two derivatives (C2).
    /// Where it is closed it has as many patches as points, begins with that of points 0 to 3, and
    /// its seam is as smooth as its other joints.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.4.
    coons_bspline in Surface -> NurbsSurface {
        /// The control points, `points[i][j]`, i along u, j along v: four or more in each
        /// direction, three or more where it closes.
        points: Spanned<Rows>,
        /// Whether the surface closes without a seam, in both directions or `{u: , v: }`.
        closed: PerDirection<bool> = PerDirection { u: false, v: false },
    }
    example "coons_bspline([for i in 0..4: [for j in 0..3: (i, j)]]).domain_u" => "0..2";
    example "coons_bspline([for i in 0..3: [for j in 0..3: (i, j, i * j)]])(0.5, 0.5) ~= (1.5, 1.5, 2.25)" => "true";
    example "coons_bspline([for i in 0..5: [for j in 0..3: (j, polar(1, i * 60deg).y, i)]], closed = {u: true, v: false}).patches" => "[6, 1]";
    refuses "coons_bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])" => "E0601: along u: a cubic needs 4 points or more, found 2";
    derivative control_points;
    picture "coons_bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]])";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let (span, closed) = (args.points.span, args.closed);
    let counts = [grid.n_rows(), grid.n_columns()].map(|n| Spanned::new(n, span));
    check_cubic(counts[0], closed.u).map_err(|found| in_direction(found, "u", "rows"))?;
    check_cubic(counts[1], closed.v)
        .map_err(|found| in_direction(found, "v", "points in a row"))?;
    let around = |n: usize, is_closed: bool| if is_closed { n + 3 } else { n };
    let (n_rows, n_columns) = (grid.n_rows(), grid.n_columns());
    let row = |i: usize| -> Vec<DVec3> {
        let columns = 0..around(n_columns, closed.v);
        columns.map(|j| grid.get(i % n_rows, j % n_columns)).collect()
    };
    let net = Grid::from_rows((0..around(n_rows, closed.u)).map(row).collect()).at(span)?;
    let knots_u = KnotVector::uniform(3, net.n_rows()).at(span)?;
    let knots_v = KnotVector::uniform(3, net.n_columns()).at(span)?;
    NurbsSurface::polynomial(knots_u, knots_v, &net).at(span)
}
