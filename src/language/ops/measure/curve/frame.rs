//! `frame` of a curve: the moving trihedron.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Frame, Side},
    value::{At, Ctx, op},
};

op! {
    /// Moving trihedron of a curve at its point: `.tangent`, `.normal` and `.binormal`, which are also
    /// x, y and z.
    ///
    /// Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §1-5.
    frame in Measure -> Frame {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "frame(circle((0, 0), 2), 0).origin" => "(2, 0, 0)";
    example "frame(circle((0, 0), 2), 0).normal" => "(-1, 0, 0)";
    refuses "frame(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no frame";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    local(&args.c, args.t, args.side)?.frame().at(args.t.span)
}
