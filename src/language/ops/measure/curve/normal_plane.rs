//! `normal_plane` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Frame, Side},
    value::{At, Ctx, op},
};

op! {
    /// Plane at a point of a curve that is normal to its tangent.
    ///
    /// Its z is the tangent; its x is the principal normal where there is one, else as for `plane`.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    normal_plane in Measure -> Frame {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "normal_plane(line((0, 0), (0, 5)), 0.5)" => "plane at (0, 2.5, 0) with normal (0, 1, 0)";
    refuses "normal_plane(bezier([(1, 2)]), 0.5)" => "E0607: there is no tangent at parameter 0.5: every derivative vanishes";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    local(&args.c, args.t, args.side)?.normal_plane().at(args.t.span)
}
