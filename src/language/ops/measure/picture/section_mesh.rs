//! `section` of a mesh by a plane.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Frame, Mesh, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// Polylines in which a plane cuts the triangles of a mesh.
    ///
    /// To their left, seen from the side of the normals, the mesh is above the plane. What lies in
    /// the plane counts as above it: a face there is told by its border towards what is below.
    section in Measure -> Vec<NurbsCurve> {
        /// The mesh.
        g: Arc<Mesh>,
        /// The plane.
        plane: Arc<Frame>,
    }
    example "[for c in section(tessellate(box((0, 0, 0), (1, 1, 1))), plane((0, 0, 0.25), (0, 0, 1))): length(c)]" => "[4]";
    example "section(grid_mesh(sphere((0, 0), 5), 8, 4), plane((0, 0, 6), (0, 0, 1)))" => "[]";
    scene r#"
        mesh m = tessellate(torus((0, 0, 0), 3, 1), tolerance = 0.05) with (color = "lightgray")
        curves cut = section(m, plane((0, 0, 0.5), (0, 0, 1))) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    args.g.section(*args.plane).at(ctx.span)
}
