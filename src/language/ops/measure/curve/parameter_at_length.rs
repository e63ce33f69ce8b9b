//! `parameter_at_length` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Length, Real, RealCurve, op},
};

op! {
    /// Parameter at which a curve is so long from its start: the inverse of `length`.
    ///
    /// Newton's method on the arc length, kept inside a bracket.
    /// Of a parametric curve on the same spline as `length`.
    parameter_at_length in Measure -> Real {
        /// The curve.
        c: RealCurve,
        /// The length from the start, not above the curve's own.
        s: Spanned<Length<Real>>,
    }
    example "parameter_at_length(polyline((0, 0), (3, 4), (3, 5)), 2.5)" => "0.5";
    refuses "parameter_at_length(line((0, 0), (3, 4)), 6)" => "E0606: the curve is 5 long, so that it has no place at length 6";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Real> {
    let Spanned { value: Length(length), span } = args.s;
    let t = args.c.parameter_at_length(length.value()).at(span)?;
    varying::parameter_at_length(&args.c, &length, t).at(span)
}
