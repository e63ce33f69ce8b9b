//! `line_tangent`: lines that touch curves.

use glam::DVec3;

use super::tangent_ends::{TangentPlace, Tangents, chosen, sources};
use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsCurve, TangentLine},
    value::{At, Ctx, op},
};

op! {
    /// Straight lines from a point or curve to another that touch each curve where they end: all of them, as a list in
    /// the order of the parameters of the places of contact, or the one that comes nearest to the point `near`.
    ///
    /// Both lie in one plane. A line touches where the curve is, its ends included, but not in a corner, nor where the
    /// curve stands still; straight parts of a curve touch nothing. Found completely, as lines that the tangents of
    /// both have in common, up to what touches within a millionth of a piece beside a standstill, and made exact by
    /// Newton's method. Curves that have a stretch in common have as many tangents as that has places, which is an
    /// error.
    line_tangent in Curve -> Tangents {
        /// Where it starts: a point, or a curve that it touches.
        a: Spanned<TangentPlace>,
        /// Where it ends.
        b: Spanned<TangentPlace>,
        /// A point to which the one that is meant comes nearest.
        near: Option<Spanned<DVec3>>,
    }
    example "line_tangent((5, 0), circle((0, 0), 3), near = (2, 2)).end ~= (1.8, 2.4) within 1e-12" => "true";
    example "[for l in line_tangent(circle((0, 0), 3), circle((10, 0), 3)): length(l)] ~= [8, 10, 10, 8] within 1e-9" => "true";
    example "len(line_tangent(bezier((-1, 1), (0, -1), (1, 1)), bezier((3, 1), (4, -1), (5, 1))))" => "1";
    refuses "line_tangent((1, 0), circle((0, 0), 3))" => "E0607: no line from the point (1, 0, 0) touches the curve";
    refuses "line_tangent((0, 0), (1, 0))" => "E0401: two points have nothing to touch: one of both must be a curve";
    refuses "line_tangent((5, 0), circle((0, 0), 3), near = (0, 0))" => "E0607: of 2 tangents two are equally near to the point";
    scene r#"
        curve a = circle((0, 0), 2)
        curve b = circle((6, 0), 1)
        curves belts = line_tangent(a, b) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Tangents> {
    let ends = sources(&args.a, &args.b, "`line(a, b)` joins them", ctx)?;
    let lines = TangentLine::all([ends[0].end(), ends[1].end()], ctx.tolerance).at(ctx.span)?;
    let curve = |line: TangentLine| NurbsCurve::line(line.points[0], line.points[1]).at(ctx.span);
    let curves = lines.into_iter().map(curve).collect::<Result<_>>()?;
    chosen("line", &ends, curves, args.near, ctx)
}
