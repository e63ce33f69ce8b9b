//! `closest` point of a surface.

use std::sync::Arc;

use super::varying;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, IntoValue, Length, Real, RealSurface, Record, Vector, op},
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
        s: RealSurface,
        /// The point.
        p: Spanned<Vector>,
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
    let Spanned { value: p, span } = &args.p;
    let foot = args.s.closest(p.value()).at(ctx.span)?;
    let [u, v] = varying::closest(&args.s, p, foot.parameters).at(*span)?;
    let point = varying::point(&args.s, &[u.clone(), v.clone()], foot.point).at(*span)?;
    let distance = match (&point, p) {
        (Vector::Plain(_), Vector::Plain(_)) => Real::Plain(foot.distance),
        _ => point.minus(p).norm().at(*span)?.with_value(foot.distance),
    };
    Ok(Record::new([
        (Arc::from("u"), u.into_value()),
        (Arc::from("v"), v.into_value()),
        (Arc::from("point"), point.into_value()),
        (Arc::from("distance"), Length(distance).into_value()),
    ]))
}
