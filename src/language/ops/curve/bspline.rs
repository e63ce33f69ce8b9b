//! `bspline`: the polynomial B-spline on any knots.

use glam::DVec3;

use super::{check_closed, check_degree, knots_for};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Interval, NurbsCurve},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// B-spline of control points on given knots, or on uniform clamped ones over 0..1.
    ///
    /// A closed one is periodic over 0..1: it has as many segments as points, three or more, begins
    /// with the segment of the first points, and its seam is as smooth as its other joints. Piegl & Tiller, *The NURBS Book*, §3.2.
    bspline in Curve -> NurbsCurve {
        /// The control points, more than the degree.
        points: Spanned<AtLeast<2, DVec3>>,
        /// The degree.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// All knots: one more than points and degree together; a closed curve makes its own.
        knots: Option<Spanned<Vec<f64>>>,
        /// Whether the curve closes without a seam.
        closed: bool = false,
    }
    example "bspline((0, 0), (1, 2), (3, 2), (4, 0), degree = 2)(0.5)" => "(2, 2, 0)";
    example "bspline((0, 0), (1, 0), (1, 1), (0, 1), closed = true).closed" => "true";
    refuses "bspline((0, 0), (1, 2), (2, 0))" => "E0601: 3 points are too few for degree 3, which needs 4 or more";
    refuses "bspline((0, 0), (1, 2), (2, 0), degree = 2, knots = [0, 0, 1, 1])" => "E0602: 3 control points of degree 2 need 6 knots, got 4";
    refuses "bspline((0, 0), (1, 2), (2, 0), degree = 2, knots = [0, 0, 1, 0, 1, 1])" => "E0602: knot 3 is 0, below the 1 before it; knots never decrease";
    derivative control_points;
    picture "bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let span = args.points.span;
    let n_points = Spanned::new(points.len(), span);
    if !args.closed {
        let knots = knots_for(args.knots, args.degree, n_points)?;
        return NurbsCurve::polynomial(knots, &points).at(span);
    }
    if let Some(knots) = args.knots {
        return Diagnostic::error(
            Code::BadCall,
            knots.span,
            "a closed B-spline makes its own knots",
        )
        .hint("leave out `knots` or `closed`")
        .fail();
    }
    let degree = args.degree;
    if degree.value == 0 {
        check_degree(degree, n_points)?;
    }
    check_closed(n_points)?;
    let closed = NurbsCurve::uniform(degree.value, &points, true).at(span)?;
    Ok(closed.reparametrized(Interval::UNIT))
}
