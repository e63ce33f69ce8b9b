//! `flip` of a face: the normal turned around.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::Face,
    value::{Ctx, op},
};

op! {
    /// The same face with its normal turned around: v of its surface runs backwards.
    flip in Face -> Face {
        /// The face.
        f: Arc<Face>,
    }
    example "normal(flip(face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))])), 0.1, 0.1)" => "(0, 0, -1)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Face> {
    Ok(args.f.reversed())
}
