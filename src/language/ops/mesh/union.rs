//! `union` of meshes.

use super::{ClosedMesh, ClosedMeshes};
use crate::{
    diag::{Result, Spanned},
    kernel::Mesh,
    value::{At, Ctx, op},
};

op! {
    /// What is in any of several closed meshes. `none` among them counts for nothing.
    ///
    /// The meshes must close within the document's tolerance, with triangles that face outward and cross
    /// nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    /// is of triangles without normals; its new vertices are rounded, and no further away than that.
    /// It is checked before it is given: it closes, and its volume and that of what the meshes have in
    /// common add up to theirs. What would touch itself in an edge or a point is refused with the place.
    union in Mesh -> ClosedMesh {
        /// The closed meshes; lists count as their members.
        meshes: Spanned<ClosedMeshes>,
    }
    example "volume(union(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((1, 1, 1), (2, 2, 2)))))" => "15";
    example "union(none, none)" => "none";
    refuses "union(tessellate(box((0, 0, 0), (2, 2, 2))), tessellate(box((2, 2, 0), (1, 1, 2))))" => "E0613: the result would touch itself at (2, 2, 0): a body has one inside around each point";
    refuses "union(tessellate(box((0, 0, 0), (2, 2, 2))), box((1, 1, 1), (2, 2, 2)))" => "E0301: `union`: `meshes` must be a list of 1 or more meshes or lists of meshes, found a list of 2 values";
    picture "union(tessellate(sphere((0, 0, 0), 1), tolerance = 1e-3), tessellate(box((0, 0, 0), (1.5, 1, 1))))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<ClosedMesh> {
    let meshes = &args.meshes;
    Mesh::union(&meshes.value.there(), ctx.tolerance).at(meshes.span).map(ClosedMesh::from)
}
