//! `length` of the border of a face.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::Face,
    value::{At, Ctx, Length, op},
};

op! {
    /// Length of all edges of a face together.
    length in Face -> Length {
        /// The face.
        f: Arc<Face>,
    }
    example "length(trim(sphere((0, 0), 1), by = XY, keep = \"above\")) ~= tau within 1e-9" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Length> {
    args.f.border_length(ctx.tolerance).at(ctx.span).map(Length)
}
