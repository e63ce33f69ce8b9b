//! `osculating_circle` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NurbsCurve, Side},
    value::{At, Ctx, op},
};

op! {
    /// Circle that agrees with a curve up to the second derivative, as an exact curve on 0..1.
    ///
    /// It starts at the point of the curve and runs in its direction. Where the curve is straight there
    /// is none.
    osculating_circle in Measure -> NurbsCurve {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "osculating_circle(bezier((0, 0), (1, 2), (2, 0)), 0.5)(0)" => "(1, 1, 0)";
    example "osculating_circle(bezier((0, 0), (1, 2), (2, 0)), 0.5).closed" => "true";
    refuses "osculating_circle(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no osculating circle";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        curves circles = [for t in [0.2, 0.8]: osculating_circle(c, t)] with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    local(&args.c, args.t, args.side)?.osculating_circle().at(args.t.span)
}
