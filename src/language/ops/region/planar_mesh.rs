//! `planar_mesh` of a region.

use super::Given;
use crate::{
    diag::{Result, Spanned},
    kernel::{Mesh, tolerance::DEFAULT_CHORD_RELATIVE},
    ops::positive,
    value::{At, Ctx, Length, op},
};

op! {
    /// Mesh of a region, whose borders are nowhere further from the curves than the tolerance.
    ///
    /// All vertices are on the borders; the triangles are as far from slivers as that allows.
    planar_mesh in Region -> Mesh {
        /// The region.
        r: Spanned<Given>,
        /// The tolerance; when left out a thousandth of the size of the region.
        tolerance: Option<Spanned<Length>>,
    }
    example "planar_mesh(region(polyline([(0, 0), (4, 0), (4, 3), (0, 3)], closed = true)))" => "mesh of 4 vertices and 2 triangles";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    let size = args.r.value.bounds().diagonal();
    let tolerance = match args.tolerance {
        Some(tolerance) => positive("the tolerance", tolerance)?,
        None => DEFAULT_CHORD_RELATIVE * size,
    };
    let distance = ctx.tolerance.distance_for(size);
    args.r.value.mesh(tolerance, distance, ctx.limits.mesh_vertices).at(args.r.span)
}
