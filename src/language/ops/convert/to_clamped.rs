//! `to_clamped`: a curve as a clamped B-spline.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// The same curve as a clamped B-spline, which starts at its first point and ends at its last,
    /// on the same domain.
    ///
    /// Inner knots stand as often as the smoothness of the curve needs, so that a chain of Bézier
    /// or Hermite cubics that is C2 becomes the uniform clamped cubic. Always exact; weights stay.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (2.53).
    to_clamped in Curve -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "to_clamped(coons_cubic((0, 0), (0, 6), (6, 6), (6, 0))).points" => "[(1, 5, 0), (2, 6, 0), (4, 6, 0), (5, 5, 0)]";
    example "to_clamped(hermite([(0, 0), (1, 1), (2, 8)], [(1, 0), (1, 3), (1, 12)])).knots" => "[0, 0, 0, 0, 2, 2, 2, 2]";
    refuses "to_clamped(parametric(t => (t, t^2), 0..2))" => "E0301: `to_clamped`: `c` must be a NURBS curve, found a parametric curve";
    derivative shape;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    Ok(args.c.without_needless_knots())
}
