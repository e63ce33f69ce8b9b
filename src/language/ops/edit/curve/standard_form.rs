//! `standard_form`: a curve with weight one at both ends.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Curve, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// The same curve with weight 1 at both ends.
    ///
    /// A rational linear change of the parameter: no point leaves the curve, each has another
    /// parameter of the same domain. Weights and inner knots change with it. An unclamped curve is
    /// clamped first.
    /// Farin, *Curves and Surfaces for CAGD*, §13.4; Piegl & Tiller, *The NURBS Book*, §6.4.
    standard_form in Edit -> Curve {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "standard_form(nurbs([(1, 0), (1, 1), (0, 1)], weights = [1, 1, 2], degree = 2)).weights" => "[1, 0.7071067811865475, 1]";
    example "standard_form(line((0, 0), (2, 4))).weights" => "[1, 1]";
    refuses "standard_form(parametric(t => (t, t^2), 0..2))" => "E0301: `standard_form`: `c` must be a NURBS curve, found a parametric curve";
    scene r#"
        curve c = nurbs([(1, 0), (1, 1), (0, 1)], weights = [1, 1, 2], degree = 2) with (color = "gray")
        curve even = translate(standard_form(c), (-0.2, -0.2))
        points before = sample(c, 9) with (color = "gray")
        points places = sample(even, 9) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    args.c.standard_form().map(Curve::from).at(ctx.span)
}
