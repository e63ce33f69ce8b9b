//! `reverse_u`: u run backwards.

use crate::{
    diag::Result,
    kernel::{Direction, Surface},
    value::{At, Ctx, op},
};

op! {
    /// The same surface with u run backwards over the same domain.
    ///
    /// Its normal turns around.
    reverse_u in Edit -> Surface {
        /// The surface.
        s: Surface,
    }
    example "reverse_u(bilinear((0, 0), (0, 1), (2, 0), (2, 1)))(0, 0)" => "(2, 0, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.reversed(Direction::U).at(ctx.span)
}
