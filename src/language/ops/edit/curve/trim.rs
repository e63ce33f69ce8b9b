//! `trim` of a curve: a part of it.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, ParameterRange, op},
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
        range: Spanned<ParameterRange>,
    }
    example "trim(line((0, 0), (4, 8)), 0.25..0.5).points" => "[(1, 2, 0), (2, 4, 0)]";
    example "trim(line((0, 0), (4, 8)), 0.25..0.5).domain" => "0.25..0.5";
    refuses "trim(bezier((0, 0), (1, 2), (2, 0)), 0.5..2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "trim(bezier((0, 0), (1, 2), (2, 0)), 0.5..0.5)" => "E0606: `trim`: `range`: an interval needs its start below its end, got 0.5..0.5";
    refuses "trim(line((0, 0), (10, 0)), 0mm..0.5mm)" => "E0303: `trim`: `range` must be a range of plain numbers, found the range 0..0.5";
    derivative shape;
    scene r#"
        curve part = trim(c, 0.2..0.7) with (color = "red")
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1)) with (color = "gray")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    args.c.trimmed(args.range.value.0).at(args.range.span)
}
