//! `flip`: the normal turned around.

use crate::{
    diag::Result,
    kernel::{Direction, Surface},
    value::{At, Ctx, op},
};

op! {
    /// The same surface with its normal turned around: v runs backwards, as with `reverse_v`.
    ///
    /// `swap_uv` and `reverse_u` turn it around as well, and change something else.
    flip in Edit -> Surface {
        /// The surface.
        s: Surface,
    }
    example "normal(flip(bilinear((0, 0), (0, 1), (2, 0), (2, 1))), 0.5, 0.5)" => "(0, 0, -1)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.reversed(Direction::V).at(ctx.span)
}
