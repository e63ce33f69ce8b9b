//! `intersection` of meshes.

use super::{ClosedMesh, ClosedMeshes};
use crate::{
    diag::{Result, Spanned},
    kernel::Mesh,
    value::{At, Ctx, op},
};

op! {
    /// What is in all of several closed meshes; `none` where there is nothing.
    ///
    /// The meshes must close within the document's tolerance, with triangles that face outward and cross
    /// nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    /// is of triangles without normals; its new vertices are rounded, and no further away than that.
    /// It is checked before it is given: it closes, and its volume and that of what the meshes have in
    /// common add up to theirs. What would touch itself in an edge or a point is refused with the place. Where nothing is in all
    /// of them, and a list of several stands among others, a warning tells that each of its members counts (W0013).
    intersection in Mesh -> ClosedMesh {
        /// The closed meshes; lists count as their members.
        meshes: Spanned<ClosedMeshes>,
    }
    example "volume(intersection(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((1, 1, 1), (2, 2, 2)))))" => "1";
    example "intersection(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((5, 0, 0), (1, 1, 1))))" => "none";
    picture "intersection(tessellate(sphere((0, 0, 0), 1), tolerance = 1e-3), tessellate(box((0, -1, -1), (1, 1.5, 2))))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<ClosedMesh> {
    let meshes = &args.meshes;
    if meshes.value.all.iter().any(|mesh| mesh.0.is_none()) {
        return Ok(ClosedMesh(None));
    }
    let found = Mesh::intersection(&meshes.value.there(), ctx.tolerance).at(meshes.span)?;
    if found.is_none() {
        meshes.value.listed.warn_of_no_intersection(ctx, meshes.span);
    }
    Ok(ClosedMesh::from(found))
}
