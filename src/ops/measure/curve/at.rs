//! `at` of a curve: its point.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Point of a curve at a parameter; `c(t)` is the same.
    at in Measure -> DVec3 {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
    }
    example "at(line((0, 0), (2, 4)), 0.25)" => "(0.5, 1, 0)";
    refuses "at(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    args.c.point_at(inside(&args.c, args.t)?).at(args.t.span)
}
