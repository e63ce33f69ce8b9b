//! `polyline`: straight legs through points.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Straight legs from point to point, a curve of degree 1 with one unit of parameter a leg.
    polyline in Curve -> NurbsCurve {
        /// The corners, two or more.
        points: Spanned<AtLeast<2, DVec3>>,
        /// Whether a last leg leads back to the first point, unless the last point is there.
        closed: bool = false,
    }
    example "polyline((0, 0), (2, 0), (2, 2))(1.5)" => "(2, 1, 0)";
    example "polyline((0, 0), (2, 0), (2, 2), closed = true).domain" => "0..3";
    example "polyline((0, 0), (2, 0), (2, 2), (0, 0), closed = true).domain" => "0..3";
    refuses "polyline([(0, 0)])" => "E0601: `polyline`: `points` must be a list of 2 or more points, found a list of 1 point";
    derivative control_points;
    picture "polyline((0, 0), (1, 2), (3, 1), (4, 3))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(mut points) = args.points.value;
    if args.closed {
        let (first, last) = (points[0], points[points.len() - 1]);
        if ctx.tolerance.distance < first.distance(last) {
            points.push(first);
        }
    }
    NurbsCurve::polyline(&points).at(args.points.span)
}
