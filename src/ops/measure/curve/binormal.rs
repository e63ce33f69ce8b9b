//! `binormal` of a curve.

use glam::DVec3;

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Side},
    value::{At, Ctx, op},
};

op! {
    /// Unit binormal of a curve: tangent × principal normal, the axis that it turns about.
    ///
    /// Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §1-5.
    binormal in Measure -> DVec3 {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "binormal(circle((0, 0), 2), 0)" => "(0, 0, 1)";
    refuses "binormal(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no binormal";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    local(&args.c, args.t, args.side)?.binormal().at(args.t.span)
}
