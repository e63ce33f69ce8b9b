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
    /// Piegl & Tiller, *The NURBS Book*, §6.5.
    reverse_u in Edit -> Surface {
        /// The surface.
        s: Surface,
    }
    example "reverse_u(bilinear((0, 0), (0, 1), (2, 0), (2, 1)))(0, 0)" => "(2, 0, 0)";
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        surface t = translate(reverse_u(s), (6, -2)) with (color = "lightgray")
        curves u = arrows([s, t], "tangent_u", samples = 2) with (color = "red")
        curves v = arrows([s, t], "tangent_v", samples = 2) with (color = "green")
        curves normals = arrows([s, t], "normal", samples = 2)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    args.s.reversed(Direction::U).at(ctx.span)
}
