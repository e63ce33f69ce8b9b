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
        /// Whether a last leg leads back to the first point.
        closed: bool = false,
    }
    example "polyline((0, 0), (2, 0), (2, 2))(1.5)" => "(2, 1, 0)";
    example "polyline((0, 0), (2, 0), (2, 2), closed = true).domain" => "0..3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(mut points) = args.points.value;
    if args.closed {
        points.extend(points.first().copied());
    }
    NurbsCurve::polyline(&points).at(args.points.span)
}
