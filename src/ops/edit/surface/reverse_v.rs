//! `reverse_v`: v run backwards.

use crate::{
    diag::Result,
    kernel::{Direction, Surface},
    value::{At, Ctx, op},
};

op! {
    /// The same surface with v run backwards over the same domain.
    ///
    /// Its normal turns around.
    reverse_v in Edit -> Surface {
        /// The surface.
        s: Surface,
    }
    example "reverse_v(bilinear((0, 0), (0, 1), (2, 0), (2, 1)))(0, 0)" => "(0, 1, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.reversed(Direction::V).at(ctx.span)
}
