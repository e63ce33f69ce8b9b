//! `normal_line` of a curve.

use super::local;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NurbsCurve, Side},
    value::{At, Ctx, Length, op},
};

op! {
    /// Segment from a point of a curve along its principal normal.
    ///
    /// Where the curve is straight there is none.
    normal_line in Measure -> NurbsCurve {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// Its length; a negative one runs the other way.
        length: Length = Length(1.0),
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "normal_line(circle((0, 0), 2), 0, length = 2).end" => "(0, 0, 0)";
    refuses "normal_line(line((0, 0), (1, 2)), 0.5)" => "E0607: the curve is straight at parameter 0.5: there is no principal normal";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        curves normals = [for t in [0, 0.2, 0.4, 0.6, 0.8, 1]: normal_line(c, t)] with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let local = local(&args.c, args.t, args.side)?;
    let direction = local.normal().at(args.t.span)?;
    let tip = local.point() + direction * args.length.0;
    NurbsCurve::line(local.point(), tip).at(args.t.span)
}
