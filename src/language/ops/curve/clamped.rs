//! `clamped`: the uniform clamped B-spline.

use glam::DVec3;

use super::check_degree;
use crate::{
    diag::{Result, Spanned},
    kernel::{KnotVector, NurbsCurve},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Uniform B-spline that starts at its first point and ends at its last, one unit of parameter
    /// a segment.
    ///
    /// Its first and last knots are repeated, those between are 1 apart: of degree 3 with n + 1
    /// points {0, 0, 0, 0, 1, …, n - 3, n - 2, n - 2, n - 2, n - 2}. Linkeová, *Curves and
    /// Surfaces for Computer Graphics*, §2.5.
    clamped in Curve -> NurbsCurve {
        /// The control points, more than the degree.
        points: Spanned<AtLeast<2, DVec3>>,
        /// The degree.
        degree: Spanned<usize> = Spanned::unplaced(3),
    }
    example "clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4))(1)" => "(5, 4, 0)";
    example "clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4)).knots" => "[0, 0, 0, 0, 1, 2, 2, 2, 2]";
    refuses "clamped((0, 0), (1, 2), (2, 0))" => "E0601: 3 points are too few for degree 3, which needs 4 or more";
    derivative control_points;
    picture "clamped((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let (span, degree) = (args.points.span, args.degree);
    check_degree(degree, Spanned::new(points.len(), span))?;
    let end = (points.len() - degree.value) as f64;
    let knots =
        KnotVector::uniform_clamped(degree.value, points.len(), end).at(degree.span_or(span))?;
    NurbsCurve::polynomial(knots, &points).at(span)
}
