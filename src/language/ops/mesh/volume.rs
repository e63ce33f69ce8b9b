//! `volume` that meshes enclose.

use super::ClosedMesh;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, LengthPower, Volume, op},
};

op! {
    /// Volume that a closed mesh encloses, on whichever side its triangles face.
    ///
    /// Exact for the mesh, which is inside of a convex surface that it was made of. The mesh must
    /// close, with vertices within the document's tolerance at one place, and its triangles must
    /// face alike. A part that is turned inward inside of another is a hole in it. `none`, which a
    /// boolean leaves where there is nothing, has the volume 0.
    volume in Mesh -> Volume {
        /// The mesh.
        m: Spanned<ClosedMesh>,
    }
    example "volume(tessellate(box((0, 0, 0), (1, 2, 3)))) ~= 6" => "true";
    refuses "volume(grid_mesh(plane_patch((0, 0), (1, 0), (0, 1)), 1, 1))" => "E0612: the mesh does not close: it has 4 edges with one triangle around 1 hole, from (0, 1, 0) on";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume> {
    let Some(mesh) = &args.m.value.0 else { return Ok(LengthPower(0.0)) };
    mesh.check_solid(ctx.tolerance).at(args.m.span)?;
    Ok(LengthPower(mesh.measured_volume().at(args.m.span)?.abs()))
}
