//! `area` of meshes.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::Mesh,
    value::{Area, At, Ctx, LengthPower, op},
};

op! {
    /// Area of a mesh: the sum over its triangles.
    area in Mesh -> Area {
        /// The mesh.
        m: Spanned<Arc<Mesh>>,
    }
    example "area(grid_mesh(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), 1, 1))" => "6";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Area> {
    args.m.value.measured_area().at(args.m.span).map(LengthPower)
}
