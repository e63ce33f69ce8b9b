//! `greville`: the parameters that belong to control points.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Greville parameters of a curve, one a control point: means of as many consecutive knots as
    /// the degree says.
    ///
    /// There the point has most of its influence. Those of a curve that is not clamped may lie
    /// outside its domain. Farin, *Curves and Surfaces for CAGD*, §8.6.
    greville in Curve -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "greville(bezier((0, 0), (1, 3), (2, 3), (4, 0))) ~= [0, 1/3, 2/3, 1] within 1e-15" => "true";
    example "greville(clamped((0, 0), (1, 2), (3, 2), (4, 0), degree = 2))" => "[0, 0.5, 1.5, 2]";
    refuses "greville(parametric(t => (t, t^2), 0..2))" => "E0301: `greville`: `c` must be a NURBS curve, found a parametric curve";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    Ok(args.c.knots().greville())
}
