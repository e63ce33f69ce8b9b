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
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        surface t = translate(swap_uv(s), (6, -2)) with (color = "lightgray")
        curves u = arrows([s, t], "tangent_u", samples = 2) with (color = "red")
        curves v = arrows([s, t], "tangent_v", samples = 2) with (color = "green")
        curves normals = arrows([s, t], "normal", samples = 2)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.swapped().at(ctx.span)
}
