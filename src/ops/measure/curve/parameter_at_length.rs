//! `parameter_at_length` of a curve.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, Length, op},
};

op! {
    /// Parameter at which a curve is so long from its start: the inverse of `length`.
    ///
    /// Newton's method on the arc length, kept inside a bracket.
    /// Of a parametric curve on the same spline as `length`.
    parameter_at_length in Measure -> f64 {
        /// The curve.
        c: Curve,
        /// The length from the start, not above the curve's own.
        s: Spanned<Length>,
    }
    example "parameter_at_length(polyline((0, 0), (3, 4), (3, 5)), 2.5)" => "0.5";
    refuses "parameter_at_length(line((0, 0), (3, 4)), 6)" => "E0606: the curve is 5 long, so that it has no place at length 6";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    args.c.parameter_at_length(args.s.value.0).at(args.s.span)
}
