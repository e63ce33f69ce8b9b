//! `swap_uv`: u and v exchanged.

use crate::{
    diag::Result,
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// The same surface with u and v exchanged: `swap_uv(s)(a, b)` is `s(b, a)`.
    ///
    /// Its normal turns around.
    swap_uv in Edit -> Surface {
        /// The surface.
        s: Surface,
    }
    example "swap_uv(bilinear((0, 0), (0, 1), (2, 0), (2, 1)))(1, 0)" => "(0, 1, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.swapped().at(ctx.span)
}
