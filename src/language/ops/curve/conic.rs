//! `conic`: the conic section of three points and a weight.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{KnotVector, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// Exact conic section from `a` to `c`, tangent there to the lines to `b`, on 0..1.
    ///
    /// A rational quadratic Bézier curve whose ends have weight 1. A weight of the middle point
    /// below 1 makes an ellipse, 1 a parabola, above 1 a hyperbola; 0 the straight line.
    /// Piegl & Tiller, *The NURBS Book*, §7.3.
    conic in Curve -> NurbsCurve {
        /// Where it starts.
        a: DVec3,
        /// Where the tangents of the ends meet.
        b: DVec3,
        /// Where it ends.
        c: DVec3,
        /// The weight of `b`, not negative.
        weight: Spanned<f64>,
    }
    example "conic((0, 0), (1, 2), (2, 0), 1)(0.5)" => "(1, 1, 0)";
    example "norm(conic((1, 0), (1, 1), (0, 1), sqrt(2) / 2)(0.3)) ~= 1" => "true";
    refuses "conic((0, 0), (1, 2), (2, 0), -1)" => "E0603: weight 1 is -1; weights are not negative";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let Args { a, b, c, weight } = args;
    let knots = KnotVector::bezier(2).at(weight.span)?;
    NurbsCurve::rational(knots, &[a, b, c], &[1.0, weight.value, 1.0]).at(weight.span)
}
