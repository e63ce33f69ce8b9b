//! `osculating_plane` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Frame, Side},
    value::{At, Ctx, op},
};

op! {
    /// Plane of the osculating circle of a curve, which holds tangent and principal normal.
    ///
    /// Its z is the binormal, its x the tangent. Where the curve is straight there is none.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    osculating_plane in Measure -> Frame {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "osculating_plane(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "plane at (1, 1, 0) with normal (0, 0, -1)";
    refuses "osculating_plane(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no osculating plane";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    local(&args.c, args.t, args.side)?.osculating_plane().at(args.t.span)
}
