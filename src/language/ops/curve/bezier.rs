//! `bezier`: the curve of a control polygon.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{KnotVector, NurbsCurve},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Bézier curve of a control polygon, of degree one less than its points, on 0..1.
    ///
    /// It starts at the first point and ends at the last, tangent to the polygon there, and lies
    /// in the convex hull of its points. One point makes a curve of degree 0.
    /// Piegl & Tiller, *The NURBS Book*, §1.3.
    bezier in Curve -> NurbsCurve {
        /// The control points, as a list or as the arguments themselves.
        points: Spanned<AtLeast<1, DVec3>>,
        /// A weight for each point; without them the curve is polynomial.
        weights: Option<Spanned<Vec<f64>>>,
    }
    example "bezier((0, 0), (1, 2), (2, 0))(0.5)" => "(1, 1, 0)";
    example "bezier([(0, 0), (1, 2), (2, 0)], weights = [1, 3, 1])(0.5)" => "(1, 1.5, 0)";
    refuses "bezier([])" => "E0601: `bezier`: `points` must be a list of 1 or more points, found an empty list";
    refuses "bezier([(0, 0), (1, 2), (2, 0)], weights = [1, 3])" => "E0603: 3 control points need 3 weights, got 2";
    refuses "bezier([(0, 0), (1, 2), (2, 0)], weights = [1, -3, 1])" => "E0603: weight 1 is -3; weights are not negative";
    derivative control_points;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let span = args.points.span;
    match args.weights {
        None => NurbsCurve::bezier(&points).at(span),
        Some(weights) => {
            let knots = KnotVector::bezier(points.len() - 1).at(span)?;
            NurbsCurve::rational(knots, &points, &weights.value).at(weights.span)
        }
    }
}
