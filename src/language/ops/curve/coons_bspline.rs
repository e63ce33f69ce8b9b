//! `coons_bspline`: the uniform cubic B-spline that is not clamped.

use glam::DVec3;

use super::check_cubic;
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Coons cubic B-spline: uniform, not clamped, one unit of parameter a segment.
    ///
    /// Every four consecutive points make one segment, a Coons cubic; segments meet with two
    /// derivatives (C2). A closed one has as many segments as points, begins with that of points
    /// 0 to 3, and its seam is as smooth as its other joints.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.4.
    coons_bspline in Curve -> NurbsCurve {
        /// The control points: four or more, for a closed curve three or more.
        points: Spanned<AtLeast<1, DVec3>>,
        /// Whether the curve closes without a seam.
        closed: bool = false,
    }
    example "coons_bspline((0, 0), (0, 6), (6, 6), (6, 0), (12, 0)).domain" => "0..2";
    example "coons_bspline((0, 0), (0, 6), (6, 6), (6, 0), (12, 0))(1) ~= (5, 5) within 1e-14" => "true";
    example "coons_bspline((0, 0), (6, 0), (6, 6), (0, 6), closed = true).segments" => "4";
    refuses "coons_bspline((0, 0), (1, 2), (2, 0))" => "E0601: a cubic needs 4 points or more, found 3";
    refuses "coons_bspline((0, 0))" => "E0601: a cubic needs 4 points or more, found 1";
    refuses "coons_bspline((0, 0), (1, 2), closed = true)" => "E0601: a closed curve needs 3 points or more, found 2";
    derivative control_points;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    check_cubic(Spanned::new(points.len(), args.points.span), args.closed)?;
    NurbsCurve::uniform(3, &points, args.closed).at(args.points.span)
}
