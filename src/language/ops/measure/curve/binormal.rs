//! `binormal` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Unit binormal of a curve: tangent × principal normal, the axis that it turns about.
    ///
    /// Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §1-5.
    binormal in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "binormal(circle((0, 0), 2), 0)" => "(0, 0, 1)";
    refuses "binormal(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no binormal";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |t| args.c.local_at(t, args.side)?.binormal();
    varying::vector(&args.c, &args.t, args.side, plain, (2, varying::binormal))
}
