//! `normal_line` of a surface.

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    ops::face::SurfaceOrFace,
    value::{At, Ctx, Length, op},
};

op! {
    /// Segment from a point of a surface along its normal.
    ///
    /// It runs along Su × Sv. At a pole or a collapsed edge it is the limit, where that exists.
    normal_line in Measure -> NurbsCurve {
        /// The surface, or a part of one.
        s: SurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
        /// Its length; a negative one runs the other way.
        length: Length = Length(1.0),
    }
    example "normal_line(cylinder((0, 0), 2, 1), 0, 0.5).end" => "(3, 0, 0.5)";
    example "normal_line(cylinder((0, 0), 2, 1), 0, 0.5, length = -2).end" => "(0, 0, 0.5)";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves normals = [for t in [0, 0.25, 0.5, 0.75, 1]: normal_line(s, t, 0.5)] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    let point = args.s.point_at(u, v).at(ctx.span)?;
    let normal = args.s.normal_at(u, v).at(ctx.span)?;
    NurbsCurve::line(point, point + normal * args.length.0).at(ctx.span)
}
