//! `difference` of meshes.

use super::{ClosedMesh, ClosedMeshes};
use crate::{
    diag::{Result, Spanned},
    kernel::Mesh,
    value::{At, Ctx, op},
};

op! {
    /// What is in the first of several closed meshes and in none of the others; `none` where there is nothing.
    ///
    /// The meshes must close within the document's tolerance, with triangles that face outward and cross
    /// nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    /// is of triangles without normals; its new vertices are rounded, and no further away than that.
    /// It is checked before it is given: it closes, and its volume and that of what the meshes have in
    /// common add up to theirs. What would touch itself in an edge or a point is refused with the place. Where a list of several
    /// comes first and others follow, a warning tells that only its first mesh is kept (W0013).
    difference in Mesh -> ClosedMesh {
        /// The closed meshes; lists count as their members.
        meshes: Spanned<ClosedMeshes>,
    }
    example "volume(difference(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((1, 1, 1), (2, 2, 2)))))" => "7";
    example "volume(difference(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((0, 0, 0), (2, 2, 2)))))" => "0";
    picture "difference(tessellate(box((-1, -1, -1), (2, 2, 2))), tessellate(sphere((1, 1, 1), 1.2), tolerance = 1e-3))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<ClosedMesh> {
    let meshes = &args.meshes;
    meshes.value.listed.warn_of_difference(ctx, meshes.span, "mesh");
    if meshes.value.all[0].0.is_none() {
        return Ok(ClosedMesh(None));
    }
    Mesh::difference(&meshes.value.there(), ctx.tolerance).at(meshes.span).map(ClosedMesh::from)
}
