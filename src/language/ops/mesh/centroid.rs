//! `centroid` of meshes, or of what they enclose.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::Mesh,
    ops::measure::MassOf,
    value::{At, Ctx, op},
};

op! {
    /// Centre of gravity of what a closed mesh encloses, or of its triangles.
    ///
    /// Of the volume the mesh must close, as for `volume`; of the area it need not.
    centroid in Mesh -> DVec3 {
        /// The mesh.
        m: Spanned<Arc<Mesh>>,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "centroid(tessellate(box((0, 0, 0), (1, 2, 3)))) ~= (0.5, 1, 1.5)" => "true";
    refuses "centroid(grid_mesh(plane_patch((0, 0), (1, 0), (0, 1)), 1, 1))" => "E0612: the mesh does not close: it has 4 edges with one triangle around 1 hole, from (0, 1, 0) on";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let Spanned { value: mesh, span } = args.m;
    match args.of {
        MassOf::Area => mesh.area_centroid().at(span),
        MassOf::Volume => {
            let hint = "`centroid(…, of = \"area\")` is that of the triangles themselves";
            let solid = mesh.check_solid(ctx.tolerance).at(span);
            solid.map_err(|open| Box::new((*open).hint(hint)))?;
            mesh.volume_centroid().at(span)
        }
    }
}
