//! `closest` point of a curve.

use std::sync::Arc;

use super::varying;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Side,
    value::{At, Ctx, IntoValue, Length, Real, RealCurve, Record, Value, Vector, op, shortest},
};

op! {
    /// Nearest point of a curve to a point, as `{t, point, distance, count}`.
    ///
    /// The nearest of the whole curve, ends included, by branch and bound. `count` tells how many places
    /// are as near as that, within the document's tolerance; `t` is the first of them. A whole stretch that
    /// is all as near, as a circle is to its centre, counts once, and a warning tells its parameters.
    /// At the end of a part before a jump `t` is the last number before the jump, where the curve is there.
    /// Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20 (2003).
    closest in Measure -> Record {
        /// The curve.
        c: RealCurve,
        /// The point.
        p: Spanned<Vector>,
    }
    example "closest(bezier((0, 0), (1, 2), (2, 0)), (1, 3)).point" => "(1, 1, 0)";
    example "closest(line((0, 0), (4, 0)), (5, 1)).t" => "1";
    example "closest(bezier((-2, 4), (0, -4), (2, 4)), (0, 4)).count" => "2";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        points p = [(1.5, 1.5)] with (color = "gray")
        curve way = line(p[0], closest(c, p[0]).point) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let foot = args.c.closest(args.p.value.value(), ctx.tolerance.distance).at(ctx.span)?;
    if let Some(stretch) = foot.stretch {
        let message = format!(
            "all of the curve from parameter {} to {} is equally near",
            shortest(stretch.start()),
            shortest(stretch.end())
        );
        let hint = "`t` is the first of the nearest places, and `count` counts the stretch once";
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message).hint(hint));
    }
    let Spanned { value: p, span } = &args.p;
    let t = varying::closest(&args.c, p, foot.parameter).at(*span)?;
    if foot.count > 1 && matches!(t, Real::Jet(_)) {
        varying::check_only(&args.c, p, foot.parameter).at(*span)?;
    }
    let point = match &t {
        Real::Plain(_) => Vector::Plain(foot.point),
        Real::Jet(t) => {
            let point = args.c.series_beside(t, Side::Right, 0).at(*span)?.remove(0);
            point.with_value(foot.point)
        }
    };
    let distance = match &t {
        Real::Plain(_) => Real::Plain(foot.distance),
        Real::Jet(_) => point.minus(p).norm().at(*span)?.with_value(foot.distance),
    };
    Ok(Record::new([
        (Arc::from("t"), t.into_value()),
        (Arc::from("point"), point.into_value()),
        (Arc::from("distance"), Length(distance).into_value()),
        (Arc::from("count"), Value::number(foot.count as f64)),
    ]))
}
