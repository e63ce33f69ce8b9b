//! `curvature` of a curve.

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Curvature of a curve: the reciprocal of the radius of the osculating circle, never negative.
    ///
    /// |C' × C''| / |C'|³; where the first derivative vanishes there is none.
    curvature in Measure -> f64 {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
    }
    example "curvature(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    let t = inside(&args.c, args.t)?;
    args.c.curvature_at(t).at(args.t.span)
}
