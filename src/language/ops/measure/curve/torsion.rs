//! `torsion` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Curvature, LengthPower, Real, RealCurve, op},
};

op! {
    /// Torsion of a curve: how fast its osculating plane turns about the tangent, by arc length.
    ///
    /// [C' C'' C‴] / |C' × C''|², positive for a right-handed screw and 0 for a plane curve. Where the
    /// curve is straight there is none. do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    torsion in Measure -> Curvature<Real> {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "torsion(bezier((0, 0), (1, 0), (2, 1), (3, 3, 3)), 0)" => "1";
    example "torsion(circle((0, 0), 2), 0.3)" => "0";
    refuses "torsion(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no torsion";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Curvature<Real>> {
    let plain = |t| args.c.local_at(t, args.side)?.torsion();
    varying::number(&args.c, &args.t, args.side, plain, (3, |d, _| varying::torsion(d)))
        .map(LengthPower)
}
