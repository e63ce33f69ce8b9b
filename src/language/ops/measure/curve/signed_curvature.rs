//! `signed_curvature` of a curve.

use glam::DVec3;

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, Side},
    value::{At, Ctx, Curvature, LengthPower, Real, RealCurve, Vector, op},
};

op! {
    /// Curvature of a curve with a sign: positive where it turns counter-clockwise, seen from the tip
    /// of the normal.
    ///
    /// (x'y'' − y'x'') / |C'|³ of a curve in the plane of x and y; of any other curve its curvature, with
    /// the sign of its turn about the normal. Where it bends in a plane that holds the normal there is
    /// no sign.
    signed_curvature in Measure -> Curvature<Real> {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The direction that the curve is seen from.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "signed_curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "-2";
    example "signed_curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5, normal = (0, 0, -1))" => "2";
    refuses "signed_curvature(bezier((0, 0, 0), (1, 0, 2), (2, 0, 0)), 0.5)" => "E0607: at parameter 0.5 the curve bends in a plane that holds the normal (0, 0, 1): there is no left and right";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curvature<Real>> {
    let Spanned { value: normal, span } = args.normal;
    let axis = Frame::from_normal(DVec3::ZERO, normal, None).at(span)?.z();
    let plain = |t| args.c.local_at(t, args.side)?.signed_curvature(axis, ctx.tolerance.angle);
    let formula = |d: &[Vector], value| varying::signed_curvature(d, axis, value);
    varying::number(&args.c, &args.t, args.side, plain, (2, formula)).map(LengthPower)
}
