//! `area` of meshes.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::Mesh,
    value::{Ctx, op},
};

op! {
    /// Area of a mesh: the sum over its triangles.
    area in Mesh -> f64 {
        /// The mesh.
        m: Arc<Mesh>,
    }
    example "area(grid_mesh(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), 1, 1))" => "6";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<f64> {
    Ok(args.m.area())
}
