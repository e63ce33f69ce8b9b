//! `edges` of a solid.

use std::sync::Arc;

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::{NurbsCurve, SolidEdge, SurfaceCurve},
    value::{At, Ctx, op},
};

op! {
    /// The edges that faces of a solid have in common, each once, from vertex to vertex.
    ///
    /// Where three faces meet edges end, and where an edge of one of them does. A seam over which one face goes is no edge. Along lines of
    /// constant parameters, on planes, and where they are conics, edges are exact; elsewhere splines within an eighth
    /// of the document's tolerance; `report` of an edge bounds how far from both faces it is.
    edges in Solid -> Vec<NurbsCurve> {
        /// The solid.
        s: GivenSolid,
    }
    example "len(edges(solid(box((0, 0, 0), (1, 2, 3)))))" => "12";
    example "len(edges(solid(cylinder((0, 0), 1, 3), cap = true)))" => "2";
    example "edges(solid(sphere((0, 0), 2)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let topology = args.s.topology(ctx.tolerance).at(ctx.span)?;
    let faces = args.s.faces();
    let told = |edge: SolidEdge| {
        let surfaces = edge.faces.map(|face| Arc::clone(faces[face].surface()));
        SurfaceCurve::reported(edge.curve, surfaces, ctx.tolerance, "edges")
    };
    Ok(topology.edges.into_iter().filter(|edge| !edge.is_seam()).map(told).collect())
}
