//! `intersect` two curves.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Curve, Meeting},
    value::{At, Ctx, Record, Value, op},
};

op! {
    /// Every place where two curves come within the document's tolerance of one another, as
    /// `[{t, s, point}]` in the order of `t`: `t` on the first, `s` on the second.
    ///
    /// Found completely, by halving pairs of pieces until they are apart, cross clearly or touch.
    /// Curves that share a stretch are an error that tells which.
    /// A parametric curve is searched as the spline that `length` tells of; each place is then found
    /// on the function itself.
    /// Sederberg & Nishita, *Curve intersection using Bézier clipping*, CAD 22 (1990).
    intersect in Measure -> Vec<Record> {
        /// One curve.
        a: Curve,
        /// The other.
        b: Curve,
    }
    example "intersect(line((0, 0), (4, 4)), line((0, 2), (4, 2)))" => "[{t: 0.5, s: 0.5, point: (2, 2, 0)}]";
    example "intersect(line((0, 0), (1, 0)), line((0, 1), (1, 1)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Record>> {
    let meetings = args.a.intersections(&args.b, ctx.tolerance.distance).at(ctx.span)?;
    Ok(meetings.into_iter().map(record).collect())
}

/// A meeting as scripts see it.
pub(super) fn record(meeting: Meeting) -> Record {
    Record::new([
        (Arc::from("t"), Value::number(meeting.first)),
        (Arc::from("s"), Value::number(meeting.second)),
        (Arc::from("point"), Value::Point(meeting.point)),
    ])
}
