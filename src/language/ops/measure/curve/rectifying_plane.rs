//! `rectifying_plane` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Frame, Side},
    value::{At, Ctx, op},
};

op! {
    /// Plane at a point of a curve that holds its tangent and its binormal.
    ///
    /// Its z is the principal normal, its x the binormal. Where the curve is straight there is none.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    rectifying_plane in Measure -> Frame {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "rectifying_plane(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "plane at (1, 1, 0) with normal (0, -1, 0)";
    refuses "rectifying_plane(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no rectifying plane";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    local(&args.c, args.t, args.side)?.rectifying_plane().at(args.t.span)
}
