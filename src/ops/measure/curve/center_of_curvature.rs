//! `center_of_curvature` of a curve.

use glam::DVec3;

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Side},
    value::{At, Ctx, op},
};

op! {
    /// Centre of the osculating circle of a curve: its point plus the radius along the principal normal.
    ///
    /// Where the curve is straight there is none.
    center_of_curvature in Measure -> DVec3 {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "center_of_curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "(1, 0.5, 0)";
    refuses "center_of_curvature(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no centre of curvature";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    local(&args.c, args.t, args.side)?.center_of_curvature().at(args.t.span)
}
