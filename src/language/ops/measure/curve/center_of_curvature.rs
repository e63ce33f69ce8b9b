//! `center_of_curvature` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Centre of the osculating circle of a curve: its point plus the radius along the principal normal.
    ///
    /// Where the curve is straight there is none.
    center_of_curvature in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "center_of_curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "(1, 0.5, 0)";
    refuses "center_of_curvature(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no centre of curvature";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |t| args.c.local_at(t, args.side)?.center_of_curvature();
    varying::vector(&args.c, &args.t, args.side, plain, (2, varying::center_of_curvature))
}
