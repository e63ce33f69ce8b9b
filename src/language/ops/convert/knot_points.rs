//! `knot_points`: the points where a curve's segments meet.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Points of a curve at its knots, each once, the ends of its domain among them.
    knot_points in Curve -> Vec<DVec3> {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "knot_points(clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4)))" => "[(1, 1, 0), (5, 4, 0), (9, 4, 0)]";
    refuses "knot_points(parametric(t => (t, t^2), 0..2))" => "E0301: `knot_points`: `c` must be a NURBS curve, found a parametric curve";
    derivative affine;
    scene r#"
        curve c = bspline((0, 0), (1, 2), (3, 1), (4, 3), (6, 0), (7, 1))
        points joints = knot_points(c) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    let breaks = args.c.knots().breaks();
    ctx.made_by(&|| Some(args.c.factors_of_places(&breaks)));
    Ok(breaks.into_iter().map(|t| args.c.point_at(t)).collect())
}
