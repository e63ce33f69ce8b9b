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
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        surface t = translate(flip(s), (6, -2)) with (color = "lightgray")
        curves u = arrows([s, t], "tangent_u", samples = 2) with (color = "red")
        curves v = arrows([s, t], "tangent_v", samples = 2) with (color = "green")
        curves normals = arrows([s, t], "normal", samples = 2)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.reversed(Direction::V).at(ctx.span)
}
