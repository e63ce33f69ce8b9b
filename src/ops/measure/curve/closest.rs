//! `closest` point of a curve.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::Curve,
    value::{At, Ctx, Record, Value, op, shortest},
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
        c: Curve,
        /// The point.
        p: DVec3,
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
    let foot = args.c.closest(args.p, ctx.tolerance.distance).at(ctx.span)?;
    if let Some(stretch) = foot.stretch {
        let message = format!(
            "all of the curve from parameter {} to {} is equally near",
            shortest(stretch.start()),
            shortest(stretch.end())
        );
        let hint = "`t` is the first of the nearest places, and `count` counts the stretch once";
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message).hint(hint));
    }
    Ok(Record::new([
        (Arc::from("t"), Value::number(foot.parameter)),
        (Arc::from("point"), Value::Point(foot.point)),
        (Arc::from("distance"), Value::number(foot.distance)),
        (Arc::from("count"), Value::number(foot.count as f64)),
    ]))
}
