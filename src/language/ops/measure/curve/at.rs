//! `at` of a curve: its point.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Point of a curve at a parameter; `c(t)` is the same.
    at in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
    }
    example "at(line((0, 0), (2, 4)), 0.25)" => "(0.5, 1, 0)";
    refuses "at(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |t| args.c.point_at(t);
    varying::vector(
        &args.c,
        &args.t,
        args.t.value.side(),
        plain,
        (0, |d: &[Vector]| Ok(d[0].clone())),
    )
}
