//! `border` of meshes.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Mesh, NurbsCurve},
    value::{At, Ctx, op},
};

op! {
    /// Boundary of a mesh as polylines, the mesh to the left of each; none of one that is closed.
    ///
    /// Vertices within the document's tolerance are one, so that seams and creases are no boundary.
    /// The polylines are closed, but for those that end where more than two triangles meet in an
    /// edge. Such that touch in a vertex are several.
    border in Mesh -> Vec<NurbsCurve> {
        /// The mesh.
        m: Spanned<Arc<Mesh>>,
    }
    example "[for c in border(grid_mesh(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), 1, 1)): length(c)]" => "[6]";
    example "border(tessellate(box((0, 0, 0), (1, 2, 3))))" => "[]";
    scene r#"
        curves around = border(m) with (color = "red")
        mesh m = grid_mesh(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), 6, 6) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let mesh = &args.m.value;
    let lines = mesh.topology(ctx.tolerance).boundary_lines();
    let curve = |line: Vec<u32>| {
        let points: Vec<DVec3> = line.iter().map(|&i| mesh.vertices()[i as usize]).collect();
        NurbsCurve::polyline(&points).at(args.m.span)
    };
    lines.into_iter().map(curve).collect()
}
