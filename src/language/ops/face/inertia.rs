//! `inertia` of a face.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::Face,
    ops::region::inertia::of_skin,
    value::{At, Ctx, Record, op},
};

op! {
    /// Inertia of a face about its centroid, of a skin with density one: `{tensor, moments, axes}` as for
    /// surfaces.
    inertia in Face -> Record {
        /// The face.
        f: Arc<Face>,
    }
    example "inertia(face(plane_patch((0, 0), (2, 0), (0, 2)), [circle((1, 1), 1)])).moments ~= [pi/4, pi/4, pi/2]" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    Ok(of_skin(args.f.mass().at(ctx.span)?.inertia))
}
