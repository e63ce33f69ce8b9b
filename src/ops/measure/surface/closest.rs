//! `closest` point of a surface.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::Surface,
    value::{At, Ctx, Record, Value, op},
};

op! {
    /// Nearest point of a surface to a point, as `{u, v, point, distance}`.
    ///
    /// Of a NURBS the nearest of the whole surface, its boundary included, by branch and bound. At a
    /// seam and at a pole, where several parameters have the point, they are the start of the domain;
    /// of places that are equally near one is told. Of a `parametric` surface, of which only values
    /// can be known, the best that a search from 49 x 49 places comes to.
    /// Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20 (2003).
    closest in Measure -> Record {
        /// The surface.
        s: Surface,
        /// The point.
        p: DVec3,
    }
    example "closest(bilinear((0, 0), (0, 4), (4, 0), (4, 4)), (1, 3, 2))" => "{u: 0.25, v: 0.75, point: (1, 3, 0), distance: 2}";
    example "closest(bilinear((0, 0), (0, 4), (4, 0), (4, 4)), (7, 8)).distance" => "5";
    example "closest(parametric((u, v) => (u, v, u * v), 0..1, 0..1), (2, 2, 1)).point" => "(1, 1, 1)";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        points p = [(5, 1, 3)] with (color = "red")
        curve way = line(p[0], closest(s, p[0]).point) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let foot = args.s.closest(args.p).at(ctx.span)?;
    let [u, v] = foot.parameters;
    Ok(Record::new([
        (Arc::from("u"), Value::number(u)),
        (Arc::from("v"), Value::number(v)),
        (Arc::from("point"), Value::Point(foot.point)),
        (Arc::from("distance"), Value::number(foot.distance)),
    ]))
}
