//! `self_intersections` of a curve.

use super::intersect::record;
use crate::{
    diag::Result,
    kernel::Curve,
    value::{At, Ctx, Record, op},
};

op! {
    /// Every place where a curve comes within the document's tolerance of itself, as
    /// `[{t, s, point}]` with `t` below `s`. The seam of a closed curve is none.
    ///
    /// Found completely: pieces that turn by less than half a turn cannot meet themselves, all
    /// others are halved. A cusp is no meeting of its two sides.
    /// A parametric curve is searched as the spline that `length` tells of; each place is then found
    /// on the function itself.
    self_intersections in Measure -> Vec<Record> {
        /// The curve.
        c: Curve,
    }
    example "len(self_intersections(bezier((0, 0), (4, 3), (-3, 3), (1, 0))))" => "1";
    example "self_intersections(circle((0, 0), 1))" => "[]";
    refuses "self_intersections(polyline((0, 0), (2, 0), (1, 0)))" => "E0607: the curve runs along itself from parameter 0 to 1";
    scene r#"
        curve c = bezier((0, 0), (4, 3), (-3, 3), (1, 0))
        points places = [for meeting in self_intersections(c): meeting.point] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Record>> {
    let meetings = args.c.self_intersections(ctx.tolerance.distance).at(ctx.span)?;
    Ok(meetings.into_iter().map(record).collect())
}
