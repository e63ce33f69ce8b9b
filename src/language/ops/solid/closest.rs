//! `closest` point of a solid.

use std::sync::Arc;

use glam::DVec3;

use super::GivenSolid;
use crate::{
    diag::Result,
    value::{At, Ctx, IntoValue, Length, Record, Value, op},
};

op! {
    /// Nearest point of the faces of a solid to a point, as `{face, point, distance}`; `face` is its number among `s.faces`.
    ///
    /// Also from inside it is that of the skin: `contains` tells on which side a point is. Of faces that are equally near the first.
    closest in Solid -> Record {
        /// The solid.
        s: GivenSolid,
        /// The point.
        p: DVec3,
    }
    example "closest(solid(sphere((0, 0), 2)), (0.5, 0)).distance ~= 1.5" => "true";
    example "closest(solid(box((0, 0, 0), (1, 2, 3))), (4, 3, 7)).point" => "(1, 2, 3)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let nearest = args.s.closest(args.p, ctx.tolerance).at(ctx.span)?;
    Ok(Record::new([
        (Arc::from("face"), Value::number(nearest.face as f64)),
        (Arc::from("point"), Value::Point(nearest.foot.point)),
        (Arc::from("distance"), Length(nearest.foot.distance).into_value()),
    ]))
}
