//! `edit_points`: the points of a curve that go with its control points.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Points of a curve at its Greville parameters.
    ///
    /// Of a curve that is not clamped only those inside its domain.
    edit_points in Curve -> Vec<DVec3> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "edit_points(bezier((0, 0), (1, 2), (2, 0)))" => "[(0, 0, 0), (1, 1, 0), (2, 0, 0)]";
    refuses "edit_points(parametric(t => (t, t^2), 0..2))" => "E0301: `edit_points`: `c` must be a NURBS curve, found a parametric curve";
    derivative affine;
    scene r#"
        curve c = bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))
        points edited = edit_points(c) with (color = "red")
        curve polygon = control_polygon(c) with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    let parameters = args.c.knots().greville().into_iter();
    let inside: Vec<f64> =
        parameters.filter_map(|t| args.c.domain().clamp_inside(t).ok()).collect();
    ctx.made_by(&|| Some(args.c.factors_of_places(&inside)));
    Ok(inside.into_iter().map(|t| args.c.point_at(t)).collect())
}
