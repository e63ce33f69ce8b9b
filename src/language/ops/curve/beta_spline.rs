//! `beta_spline`: the cubic with bias and tension.

use glam::DVec3;

use super::check_cubic;
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Barsky's uniformly shaped cubic Beta-spline, one unit of parameter a segment.
    ///
    /// Segments meet with one tangent and one curvature vector (G2). Behind a joint the
    /// derivative is `bias` times the one before it; `tension` pulls the curve towards its
    /// points. Bias 1 and tension 0 give the Coons cubic B-spline; below tension 0 the curve may
    /// leave the hull of its points. A closed one begins with the segment of points 0 to 3.
    /// Barsky, *The Beta-spline*, University of Utah 1981.
    beta_spline in Curve -> NurbsCurve {
        /// The control points: four or more, for a closed curve three or more.
        points: Spanned<AtLeast<3, DVec3>>,
        /// The ratio of the derivatives behind and before a joint, positive.
        bias: Spanned<f64> = Spanned::unplaced(1.0),
        /// How strongly the points attract the curve.
        tension: Spanned<f64> = Spanned::unplaced(0.0),
        /// Whether the curve closes without a seam.
        closed: bool = false,
    }
    example "beta_spline((0, 0), (1, 2), (3, 2), (4, 0), (6, 1), bias = 2)(1) ~= (16/7, 40/21)" => "true";
    example "beta_spline((0, 0), (0, 6), (6, 6), (6, 0))(0)" => "(1, 5, 0)";
    refuses "beta_spline((0, 0), (1, 2), (3, 2))" => "E0601: a cubic needs 4 points or more, found 3";
    refuses "beta_spline((0, 0), (1, 2), (3, 2), (4, 0), bias = 0)" => "E0607: the bias is 0; it must be above zero";
    refuses "beta_spline((0, 0), (1, 2), (3, 2), (4, 0), tension = -20)" => "E0607: the tension is -20; with this bias it must be above -12";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let (AtLeast(points), span) = (args.points.value, args.points.span);
    check_cubic(Spanned::new(points.len(), span), args.closed)?;
    let blamed = if args.bias.value <= 0.0 {
        args.bias.span_or(ctx.span)
    } else {
        args.tension.span_or(span)
    };
    let (bias, tension, is_closed) = (args.bias.value, args.tension.value, args.closed);
    ctx.made_by(&|| {
        Some(NurbsCurve::factors_of_beta_spline(points.len(), bias, tension, is_closed))
    });
    NurbsCurve::beta_spline(&points, bias, tension, is_closed).at(blamed)
}
