//! `edges` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The edges that faces of a solid have in common, each once, from vertex to vertex.
    ///
    /// Where three faces meet edges end, and where an edge of one of them does. A seam over which one face goes is no edge. Along lines of
    /// constant parameters, on planes, and where they are conics, edges are exact; elsewhere splines within an eighth
    /// of the document's tolerance.
    edges in Solid -> Vec<NurbsCurve> {
        /// The solid.
        s: GivenSolid,
    }
    example "len(edges(solid(box((0, 0, 0), (1, 2, 3)))))" => "12";
    example "len(edges(solid(cylinder((0, 0), 1, 3), cap = true)))" => "2";
    example "edges(solid(sphere((0, 0), 2)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    args.s.edges(ctx.tolerance).at(ctx.span)
}
