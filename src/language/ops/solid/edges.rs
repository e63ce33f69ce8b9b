//! `edges` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::{NurbsCurve, SolidEdge},
    value::{At, Ctx, op},
};

op! {
    /// The edges that faces of a solid have in common, each once, from vertex to vertex.
    ///
    /// Where three faces meet edges end, and where an edge of one of them does. A seam over which one face goes is no edge. Along lines of
    /// constant parameters, on planes, and where they are conics, edges are exact; elsewhere splines within an eighth
    /// of the document's tolerance; `report` of an edge bounds how far from both faces it is. It tells as well whether it
    /// is `convex`, the least `angle` between its faces through the inside by what 24 places show (90deg of a box, 270deg
    /// of a notch), the numbers of its `faces`, and its `length`.
    edges in Solid -> Vec<NurbsCurve> {
        /// The solid.
        s: GivenSolid,
    }
    example "len(edges(solid(box((0, 0, 0), (1, 2, 3)))))" => "12";
    example "len(edges(solid(cylinder((0, 0), 1, 3), cap = true)))" => "2";
    example "edges(solid(sphere((0, 0), 2)))" => "[]";
    example "[for e in edges(solid(box((0, 0, 0), (1, 2, 3)))): report(e).angle] ~= [for i in 1..12: 90deg]" => "true";
    example "len(filter(edges(solid(cylinder((0, 0), 1, 3), cap = true)), e => report(e).convex))" => "2";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let edges = args.s.edges(ctx.tolerance).at(ctx.span)?;
    let told = |edge: SolidEdge| args.s.reported_edge(edge, ctx.tolerance);
    Ok(edges.into_iter().map(told).collect())
}
