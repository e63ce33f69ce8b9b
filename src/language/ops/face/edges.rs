//! `edges` of a face.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Face, NurbsCurve, SurfaceCurve},
    value::{At, Ctx, op},
};

op! {
    /// The border of a face from corner to corner, with the face to the left, seen from the tip of Su × Sv.
    ///
    /// A loop without corners is one closed curve. A seam over which the face goes is no border. Along lines
    /// of constant parameters, on planes, and where they are conics, edges are exact; elsewhere cubic or quintic
    /// splines within an eighth of the document's tolerance; `report` of an edge bounds how far from the surface it is.
    edges in Face -> Vec<NurbsCurve> {
        /// The face.
        f: Arc<Face>,
    }
    example "len(edges(face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))])))" => "5";
    example "edges(face(sphere((0, 0), 1)))" => "[]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let edges = args.f.edges(ctx.tolerance).at(ctx.span)?;
    let told = |edge| {
        let surface = Arc::clone(args.f.surface());
        SurfaceCurve::reported_on(edge, surface, ctx.tolerance, "edges")
    };
    Ok(edges.into_iter().map(told).collect())
}
