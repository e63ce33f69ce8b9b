//! `radius_of_curvature` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Length, Real, RealCurve, op},
};

op! {
    /// Radius of the osculating circle of a curve: the reciprocal of the curvature.
    ///
    /// Where the curve is straight there is none.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    radius_of_curvature in Measure -> Length<Real> {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "radius_of_curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "0.5";
    refuses "radius_of_curvature(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no radius of curvature";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Length<Real>> {
    let plain = |t| args.c.local_at(t, args.side)?.radius_of_curvature();
    varying::number(
        &args.c,
        &args.t,
        args.side,
        plain,
        (2, |d, _| Real::Plain(1.0).over(&varying::bending(d)?.norm()?)),
    )
    .map(Length)
}
