//! `binormal_line` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NurbsCurve, Side},
    value::{At, Ctx, Length, op},
};

op! {
    /// Segment from a point of a curve along its binormal.
    ///
    /// Where the curve is straight there is none.
    binormal_line in Measure -> NurbsCurve {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// Its length; a negative one runs the other way.
        length: Length = Length(1.0),
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "binormal_line(circle((0, 0), 2), 0).end" => "(2, 0, 1)";
    refuses "binormal_line(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no binormal";
    scene r#"
        curve c = helix((0, 0), 2, 3, 1.5)
        curves binormals = [for t in linspace(0, 1, 13): binormal_line(c, t)] with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let local = local(&args.c, args.t, args.side)?;
    let direction = local.binormal().at(args.t.span)?;
    let tip = local.point() + direction * args.length.0;
    NurbsCurve::line(local.point(), tip).at(args.t.span)
}
