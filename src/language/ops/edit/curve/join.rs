//! `join`: several curves as one.

use crate::{
    diag::{Result, Spanned},
    kernel::{self, Curve, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// Several curves, each starting where the one before ends, as one curve.
    ///
    /// Exact: each keeps the length of its domain, behind that of the one before; all get the
    /// highest degree among them, and weights that go on from one to the next. A joint keeps only
    /// the knots that its continuity needs, so that Bézier curves that meet C² become one
    /// spline with simple knots. Gaps up to the document's tolerance are closed halfway. A
    /// parametric curve is joined as a spline of degree 11 within 1e-13 of its size.
    join in Edit -> NurbsCurve {
        /// The curves in order, one or more.
        curves: Spanned<Vec<Curve>>,
    }
    example "join([line((0, 0), (1, 0)), line((1, 0), (2, 0))]).points" => "[(0, 0, 0), (2, 0, 0)]";
    example "join([line((0, 0), (1, 0)), line((1, 0), (1, 1))]).knots" => "[0, 0, 1, 2, 2]";
    example "join(decompose(clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4)))).knots" => "[0, 0, 0, 0, 1, 2, 2, 2, 2]";
    example "join(decompose(bezier((0, 0), (1, 2), (2, 0)))).points" => "[(0, 0, 0), (1, 2, 0), (2, 0, 0)]";
    refuses "join([line((0, 0), (1, 0)), line((2, 0), (3, 0))])" => "E0609: `curves[1]` starts 1 from where `curves[0]` ends, more than the tolerance 1e-6";
    refuses "join([line((0, 0), (1, 0)), line((2, 0), (1, 0))])" => "E0609: `curves[1]` starts 1 from where `curves[0]` ends, more than the tolerance 1e-6";
    derivative shape;
    scene r#"
        let parts = [bezier((0, 0), (1, 2), (2, 0)), bezier((2, 0), (3, -2), (4, 0))] with (hidden = true)
        curve c = join(parts)
        points ends = [for part in parts: part.end] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let spline = |curve: &Curve| curve.spline().map(|spline| (*spline).clone());
    let curves: std::result::Result<Vec<NurbsCurve>, _> =
        args.curves.value.iter().map(spline).collect();
    let curves = curves.at(args.curves.span)?;
    kernel::join(&curves, ctx.tolerance.distance).at(args.curves.span)
}
