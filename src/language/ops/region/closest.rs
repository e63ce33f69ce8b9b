//! `closest` point of a region.

use std::sync::Arc;

use glam::DVec3;

use super::Given;
use crate::{
    diag::Result,
    value::{Ctx, IntoValue, Length, Record, Value, op},
};

op! {
    /// Nearest point of a region to a point, as `{point, distance}`: of the inside where the point is above
    /// that, else of the border.
    closest in Region -> Record {
        /// The region.
        r: Given,
        /// The point.
        p: DVec3,
    }
    example "closest(region(circle((0, 0), 2)), (5, 0, 4)).distance" => "5";
    example "closest(region(circle((0, 0), 2)), (1, 1, 3)).point" => "(1, 1, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let point = args.r.closest(args.p, ctx.tolerance.distance);
    Ok(Record::new([
        (Arc::from("point"), Value::Point(point)),
        (Arc::from("distance"), Length(point.distance(args.p)).into_value()),
    ]))
}
