//! `trim` of a curve: a part of it.

use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Interval},
    value::{At, Ctx, op},
};

op! {
    /// Part of a curve over a range of its parameter, which it keeps: `trim(c, a..b)(t)` is `c(t)`.
    ///
    /// Exact. The result begins at its first control point and ends at its last.
    /// A parametric curve stays one.
    trim in Edit -> Curve {
        /// The curve.
        c: Curve,
        /// The range, inside the curve's domain.
        range: Spanned<Interval>,
    }
    example "trim(line((0, 0), (4, 8)), 0.25..0.5).points" => "[(1, 2, 0), (2, 4, 0)]";
    example "trim(line((0, 0), (4, 8)), 0.25..0.5).domain" => "0.25..0.5";
    picture "trim(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 0.2..0.7)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    args.c.trimmed(args.range.value).at(args.range.span)
}
