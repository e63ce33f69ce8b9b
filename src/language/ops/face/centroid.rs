//! `centroid` of a face.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::Face,
    value::{At, Ctx, op},
};

op! {
    /// Centre of gravity of a face, as of a skin.
    centroid in Face -> DVec3 {
        /// The face.
        f: Arc<Face>,
    }
    example "centroid(trim(sphere((0, 0), 1), by = XY, keep = \"above\")) ~= (0, 0, 0.5)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(args.f.mass().at(ctx.span)?.centroid)
}
