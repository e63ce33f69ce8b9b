//! `normal` of a curve: the principal normal.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Principal unit normal of a curve: normal to the tangent, towards the centre of curvature.
    ///
    /// Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §1-5.
    normal in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "normal(circle((0, 0), 2), 0)" => "(-1, 0, 0)";
    refuses "normal(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no principal normal";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |t| args.c.local_at(t, args.side)?.normal();
    varying::vector(&args.c, &args.t, args.side, plain, (2, varying::normal))
}
