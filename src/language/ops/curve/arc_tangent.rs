//! `arc_tangent`: arcs of a radius that touch curves.

use glam::DVec3;

use super::tangent_ends::{TangentPlace, Tangents, chosen, sources};
use crate::{
    diag::{Result, Spanned},
    kernel::TangentArc,
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Exact arcs of a radius from a point or curve to another that touch each curve where they end: all of them, as a
    /// list in the order of the parameters of the places of contact, or the one that comes nearest to the point `near`.
    ///
    /// Both lie in one plane. An arc touches where the curve is, its ends included, but not in a corner; a point it
    /// goes through. Of each circle it is the shorter arc, with `long = true` the rest of it. Centres are found where
    /// offsets of the curves by the radius meet, which is complete up to the document's tolerance, and made exact by
    /// Newton's method. Curves that run alongside at twice the radius have as many arcs as places, which is an error.
    arc_tangent in Curve -> Tangents {
        /// Where it starts: a point, or a curve that it touches.
        a: Spanned<TangentPlace>,
        /// Where it ends.
        b: Spanned<TangentPlace>,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// A point to which the one that is meant comes nearest.
        near: Option<Spanned<DVec3>>,
        /// Whether it goes the longer way around.
        long: bool = false,
    }
    example "arc_tangent(line((0, 0), (5, 0)), line((0, 0), (0, 5)), 2, near = (0, 0)).start ~= (2, 0) within 1e-12" => "true";
    example "len(arc_tangent(circle((0, 0), 1), circle((4, 0), 1), 4))" => "8";
    example "arc_tangent((0, 0), line((-5, 2), (5, 2)), 2, near = (3, 1)).end ~= (2, 2) within 1e-12" => "true";
    refuses "arc_tangent(line((0, 0), (1, 0)), line((0, 5), (1, 5)), 1)" => "E0607: no arc of that radius touches both curves";
    refuses "arc_tangent(line((0, 0), (1, 0)), line((0, 5), (1, 5)), 0)" => "E0607: the radius must be positive, found 0";
    scene r#"
        curve a = circle((0, 0), 2)
        curve b = circle((6, 0), 1)
        curves arcs = arc_tangent(a, b, 3) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Tangents> {
    let radius = radius("the radius", args.radius)?;
    let ends = sources(&args.a, &args.b, "`arc_through` goes through three points", ctx)?;
    let both = [ends[0].end(), ends[1].end()];
    let arcs = TangentArc::all(both, radius, ctx.tolerance).at(ctx.span)?;
    let curve = |arc: TangentArc| arc.curve(args.long).at(ctx.span);
    let curves = arcs.into_iter().map(curve).collect::<Result<_>>()?;
    chosen("arc of that radius", &ends, curves, args.near, ctx)
}
