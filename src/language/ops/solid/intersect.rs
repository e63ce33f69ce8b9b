//! `intersect` of a solid with a curve.

use std::sync::Arc;

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::{Curve, CurveSolidIntersection},
    value::{At, Ctx, Record, Value, op},
};

op! {
    /// Every place that a curve has in common with the faces of a solid, within the document's tolerance, as
    /// `[{t, face, u, v, point}]` in the order of `t`; `face` is its number among `s.faces`, on an edge the first.
    ///
    /// A curve that runs along the surface of a face, on the face or beside it, is an error.
    ///
    /// Between two of these places the curve is inside or outside, which `contains` of a point between them tells.
    intersect in Solid -> Vec<Record> {
        /// The solid.
        s: GivenSolid,
        /// The curve.
        c: Curve,
    }
    example "[for place in intersect(solid(sphere((0, 0), 2)), line((-4, 0), (4, 0))): place.point] ~= [(-2, 0), (2, 0)]" => "true";
    example "len(intersect(solid(box((0, 0, 0), (1, 1, 1))), line((-1, -1, -1), (3, 3, 3))))" => "2";
    example "intersect(solid(sphere((0, 0), 2)), line((0, 0), (1, 0)))" => "[]";
    refuses "intersect(solid(box((0, 0, 0), (1, 1, 1))), line((-1, 0.5, 1), (2, 0.5, 1)))" => "E0607: the curve runs along the surface from parameter 0.3333 to 0.6667";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Record>> {
    let places = args.s.piercings(&args.c, ctx.tolerance).at(ctx.span)?;
    let record = |found: CurveSolidIntersection| {
        Record::new([
            (Arc::from("t"), Value::number(found.place.t)),
            (Arc::from("face"), Value::number(found.face as f64)),
            (Arc::from("u"), Value::number(found.place.uv[0])),
            (Arc::from("v"), Value::number(found.place.uv[1])),
            (Arc::from("point"), Value::Point(found.place.point)),
        ])
    };
    Ok(places.into_iter().map(record).collect())
}
