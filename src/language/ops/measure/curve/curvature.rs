//! `curvature` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Curvature, LengthPower, Real, RealCurve, op},
};

op! {
    /// Curvature of a curve: the reciprocal of the radius of the osculating circle, never negative.
    ///
    /// |C' × C''| / |C'|³, and 0 where the curve is straight. Where the first derivative vanishes it is
    /// the limit, if there is one: at a cusp there is none. do Carmo, *Differential Geometry of Curves
    /// and Surfaces*, §1-5.
    curvature in Measure -> Curvature<Real> {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "2";
    example "curvature(line((0, 0), (1, 2)), 0.5)" => "0";
    refuses "curvature(bezier((0, 0), (1, 1), (0, 1), (1, 0)), 0.5)" => "E0607: the derivative vanishes at parameter 0.5, where the curvature grows without bound: there is no curvature";
    refuses "curvature(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Curvature<Real>> {
    let plain = |t| args.c.local_at(t, args.side)?.curvature();
    varying::number(&args.c, &args.t, args.side, plain, (2, varying::curvature)).map(LengthPower)
}
