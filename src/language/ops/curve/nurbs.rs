//! `nurbs`: the rational B-spline.

use glam::DVec3;

use super::knots_for;
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Rational B-spline (NURBS) of control points with weights, on given knots or on uniform
    /// clamped ones over 0..1.
    ///
    /// A larger weight pulls the curve towards its point, a weight of zero takes the point away.
    /// Piegl & Tiller, *The NURBS Book*, §4.2.
    nurbs in Curve -> NurbsCurve {
        /// The control points, more than the degree.
        points: Spanned<AtLeast<2, DVec3>>,
        /// A weight for each point: none negative, the first and the last positive.
        weights: Option<Spanned<Vec<f64>>>,
        /// The degree.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// All knots: one more than points and degree together.
        knots: Option<Spanned<Vec<f64>>>,
    }
    example "nurbs((1, 0), (1, 1), (0, 1), weights = [1, 1, 2], degree = 2)(0.5) ~= (0.6, 0.8)" => "true";
    refuses "nurbs((0, 0), (1, 2), (2, 0), weights = [1, 1], degree = 2)" => "E0603: 3 control points need 3 weights, got 2";
    refuses "nurbs((0, 0), (1, 2), (2, 0), weights = [0, 1, 1], degree = 2)" => "E0603: weight 0 is 0; the first and the last weight are positive";
    derivative control_points;
    picture "nurbs((0, 0), (1, 3), (3, 3), (4, 0), weights = [1, 4, 1, 1])";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let span = args.points.span;
    let knots = knots_for(args.knots, args.degree, Spanned::new(points.len(), span))?;
    match args.weights {
        None => NurbsCurve::polynomial(knots, &points).at(span),
        Some(weights) => NurbsCurve::rational(knots, &points, &weights.value).at(weights.span),
    }
}
