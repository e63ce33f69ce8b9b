//! `closest` point of a face.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::Face,
    value::{At, Ctx, IntoValue, Length, Record, Value, op},
};

op! {
    /// Nearest point of a face to a point, its border included, as `{u, v, point, distance}`.
    ///
    /// The nearest of all, by branch and bound over the part of the surface that the face is.
    closest in Face -> Record {
        /// The face.
        f: Arc<Face>,
        /// The point.
        p: DVec3,
    }
    example "closest(trim(sphere((0, 0), 1), by = XY, keep = \"above\"), (3, 0, -4)).point ~= (1, 0) within 1e-9" => "true";
    example "closest(face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))]), (2.5, 2, 3)).point ~= (3, 2) within 1e-9" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let foot = args.f.closest(args.p, ctx.tolerance).at(ctx.span)?;
    let [u, v] = foot.parameters;
    Ok(Record::new([
        (Arc::from("u"), Value::number(u)),
        (Arc::from("v"), Value::number(v)),
        (Arc::from("point"), Value::Point(foot.point)),
        (Arc::from("distance"), Length(foot.distance).into_value()),
    ]))
}
